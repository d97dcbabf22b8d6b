#include "MesoConeTexture.h"

#include "MesoAlgorithmRun.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkImageData.h"
#include "vtkMesoConeMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

MesoConeTexture::MesoConeTexture()
  : MesoMapTexture(1)
{
}

MesoConeTexture::~MesoConeTexture() = default;

std::string MesoConeTexture::Prepare(vtkImageData* heights, MesoWrap wrap)
{
  this->Cones->SetInputData(heights);
  this->Cones->SetWrap(wrap);
  try
  {
    std::vector<std::string> warnings;
    MesoRunAlgorithm(this->Cones, "cones of the height map", warnings);
  }
  catch (const MesoInputError& problem)
  {
    return problem.what();
  }
  if (this->GetImage() != this->Cones->GetOutput())
  {
    this->SetImage(this->Cones->GetOutput());
  }
  return {};
}

std::string MesoConeTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  vtkImageData* cones = this->GetImage();
  int size[3];
  cones->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (2 * size[0] > limit || 2 * size[1] > limit)
  {
    return "the height map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit / 2) +
      " that this device takes for a search by cones";
  }
  vtkPointData* arrays = cones->GetPointData();
  auto* apexes = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ConeApex"));
  auto* steepnesses = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ConeSteepness"));
  const unsigned char* apex = apexes->GetPointer(0);
  const unsigned char* steepness = steepnesses->GetPointer(0);
  const std::size_t width = std::size_t(size[0]);
  const std::size_t height = std::size_t(size[1]);
  std::vector<unsigned char> quarters(8 * width * height);
  for (std::size_t row = 0; row < height; ++row)
  {
    for (std::size_t column = 0; column < width; ++column)
    {
      for (std::size_t way = 0; way < 4; ++way, ++apex, ++steepness)
      {
        const std::size_t there =
          (row + (way / 2) * height) * 2 * width + column + (way % 2) * width;
        quarters[2 * there] = *apex;
        quarters[2 * there + 1] = *steepness;
      }
    }
  }
  vtkTextureObject* texture = this->Texture();
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(2 * width),
        static_cast<unsigned int>(2 * height), 2, VTK_UNSIGNED_CHAR, quarters.data()))
  {
    return "the cones of the height map could not be made a texture";
  }
  this->Bytes = quarters.size();
  return {};
}

std::string MesoConeTexture::Activate(
  vtkOpenGLRenderWindow* window, vtkImageData* heights, MesoWrap wrap)
{
  const std::string failure = this->Prepare(heights, wrap);
  return failure.empty() ? MesoMapTexture::Activate(window, wrap) : failure;
}

void MesoConeTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoCones");
}

#include "MesoConeTexture.h"

#include "MesoAlgorithmRun.h"
#include "MesoLevelLayout.h"
#include "MesoMapUpload.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkImageData.h"
#include "vtkMesoConeMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr std::size_t Channels = 4;

/// A level's cones to where they lie in a texture of so many texels a row.
void CopyCones(vtkImageData* cones, unsigned char* corner, std::size_t width)
{
  int size[3];
  cones->GetDimensions(size);
  vtkPointData* arrays = cones->GetPointData();
  const unsigned char* apex =
    vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ConeApex"))->GetPointer(0);
  const unsigned char* steepness =
    vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ConeSteepness"))->GetPointer(0);
  const std::size_t columns = std::size_t(size[0]);
  const std::size_t rows = std::size_t(size[1]);
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      for (std::size_t way = 0; way < 4; ++way, ++apex, ++steepness)
      {
        unsigned char* numbers =
          corner + Channels * (row * width + column + (way % 2) * columns) + 2 * (way / 2);
        numbers[0] = *apex;
        numbers[1] = *steepness;
      }
    }
  }
}
}

MesoConeTexture::MesoConeTexture()
  : MesoMapTexture(1)
{
}

MesoConeTexture::~MesoConeTexture() = default;

std::string MesoConeTexture::Prepare(
  const std::vector<vtkSmartPointer<vtkImageData>>& levels, MesoWrap wrap)
{
  if (levels.size() != this->Cones.size())
  {
    this->Cones.clear();
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      this->Cones.push_back(vtkSmartPointer<vtkMesoConeMap>::New());
    }
    this->SetStale();
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    this->Cones[i]->SetInputData(levels[i]);
    this->Cones[i]->SetWrap(wrap);
    try
    {
      std::vector<std::string> warnings;
      MesoRunAlgorithm(this->Cones[i], "cones of the height map", warnings);
    }
    catch (const MesoInputError& problem)
    {
      return problem.what();
    }
  }
  if (this->GetImage() != this->Cones.front()->GetOutput())
  {
    this->SetImage(this->Cones.front()->GetOutput());
  }
  return {};
}

std::string MesoConeTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  int size[3];
  this->GetImage()->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  const MesoLevelLayout layout{ 2 * std::size_t(size[0]), std::size_t(size[1]),
    this->Cones.size() };
  if (2 * std::max(size[0], size[1]) > limit)
  {
    return "the height map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit / 2) +
      " that this device takes for a search by cones";
  }
  std::vector<unsigned char> texels(Channels * layout.GetTexels());
  for (std::size_t level = 0; level < this->Cones.size(); ++level)
  {
    CopyCones(this->Cones[level]->GetOutput(), texels.data() + Channels * layout.FirstOf(level),
      layout.GetWidth());
  }
  if (!MesoUploadTexels(this->Texture(), window, layout.GetWidth(), layout.GetHeight(),
        int(Channels), VTK_UNSIGNED_CHAR, texels.data()))
  {
    return "the cones of the height map could not be made a texture";
  }
  this->Bytes = texels.size();
  return {};
}

void MesoConeTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoCones");
}

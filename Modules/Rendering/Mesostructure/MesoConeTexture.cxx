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

namespace
{
constexpr std::size_t Channels = 2;

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
        unsigned char* texel =
          corner + Channels * ((row + (way / 2) * rows) * width + column + (way % 2) * columns);
        texel[0] = *apex;
        texel[1] = *steepness;
      }
    }
  }
}

bool MakeTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, std::size_t width,
  std::size_t height, std::vector<unsigned char>& texels)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), int(Channels), VTK_UNSIGNED_CHAR, texels.data());
}
}

MesoConeTexture::MesoConeTexture()
  : MesoMapTexture(2)
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
  if (2 * size[0] > limit || 2 * size[1] > limit)
  {
    return "the height map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit / 2) +
      " that this device takes for a search by cones";
  }
  const std::size_t width = 2 * std::size_t(size[0]);
  const std::size_t height = 2 * std::size_t(size[1]);
  std::vector<unsigned char> texels(Channels * width * height);
  CopyCones(this->GetImage(), texels.data(), width);
  bool made = MakeTexture(this->Texture(), window, width, height, texels);
  this->Bytes = texels.size();
  // Without levels the second texture is of one texel.
  const bool hasLevels = this->Cones.size() > 1;
  const std::size_t widthBeside = hasLevels ? width : 1;
  const std::size_t heightBeside = hasLevels ? height / 2 : 1;
  texels.assign(Channels * widthBeside * heightBeside, 0);
  for (std::size_t level = 1; level < this->Cones.size(); ++level)
  {
    CopyCones(this->Cones[level]->GetOutput(),
      texels.data() + Channels * (width - ((2 * width) >> level)), width);
  }
  made = made && MakeTexture(this->Texture(1), window, widthBeside, heightBeside, texels);
  this->Bytes += texels.size();
  return made ? std::string() : "the cones of the height map could not be made a texture";
}

void MesoConeTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoCones");
  this->SetSampler(program, "mesoConeLevels", 1);
}

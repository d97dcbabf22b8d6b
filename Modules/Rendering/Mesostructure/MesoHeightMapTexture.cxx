#include "MesoHeightMapTexture.h"

#include "MesoHeightPyramid.h"
#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>

MesoHeightMapTexture::MesoHeightMapTexture()
  : MesoMapTexture(1)
{
}

void MesoHeightMapTexture::SetHeightMap(vtkImageData* heights)
{
  this->SetImage(heights);
}

void MesoHeightMapTexture::SetMipmaps(bool mipmaps)
{
  if (mipmaps != this->Mipmaps)
  {
    this->Mipmaps = mipmaps;
    this->SetStale();
  }
}

std::string MesoHeightMapTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  vtkDataArray* heights = this->GetImage()->GetPointData()->GetScalars();
  if (!heights || heights->GetDataType() != VTK_FLOAT || heights->GetNumberOfComponents() != 1)
  {
    return "the height map must have one component of float";
  }
  const std::size_t bytes = std::size_t(heights->GetNumberOfValues()) * sizeof(float);
  const auto* values = static_cast<const float*>(heights->GetVoidPointer(0));
  if (this->Mipmaps)
  {
    this->CompareLevels(values);
  }
  this->Bytes = this->Mipmaps ? bytes * 4 / 3 : bytes;
  return MesoUploadMap(
    this->Texture(), window, this->GetImage(), wrap, this->Mipmaps, "height map");
}

void MesoHeightMapTexture::CompareLevels(const float* heights)
{
  int size[3];
  this->GetImage()->GetDimensions(size);
  const auto pyramid = MesoMakeHeightPyramid(size[0], size[1], heights);
  this->LastLevel = std::min(static_cast<int>(pyramid.size()), MostLevels - 1);
  const std::array<double, 2> ofMap = MesoMeanSquareSlopes(size[0], size[1], heights);
  for (int axis = 0; axis < 2; ++axis)
  {
    this->SlopesLost[0][axis] = static_cast<float>(ofMap[axis]);
  }
  for (int number = 1; number <= this->LastLevel; ++number)
  {
    const MesoHeightLevel& level = pyramid[std::size_t(number) - 1];
    const std::array<double, 2> left =
      MesoMeanSquareSlopes(level.Width, level.Height, level.Heights.data());
    for (int axis = 0; axis < 2; ++axis)
    {
      this->SlopesLost[number][axis] = static_cast<float>(std::max(ofMap[axis] - left[axis], 0.));
    }
  }
}

void MesoHeightMapTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoHeightMap");
  if (program->IsUniformUsed("mesoSlopesLost"))
  {
    program->SetUniform2fv("mesoSlopesLost", MostLevels, this->SlopesLost);
  }
  if (program->IsUniformUsed("mesoLastLevel"))
  {
    program->SetUniformi("mesoLastLevel", this->LastLevel);
  }
}

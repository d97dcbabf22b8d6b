#include "MesoHeightMapTexture.h"

#include "MesoHeightPyramid.h"
#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
/// Of normally distributed numbers whose absolute values have this mean.
double VarianceOf(double meanSize)
{
  constexpr double HalfPi = 1.57079632679489661923;
  return HalfPi * meanSize * meanSize;
}
}

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
  const MesoMapSlopes ofMap = MesoSlopesOfMap(size[0], size[1], heights);
  for (int axis = 0; axis < 2; ++axis)
  {
    this->SlopesLost[0][axis] = static_cast<float>(ofMap.MeanSquare[axis]);
  }
  for (int number = 1; number <= this->LastLevel; ++number)
  {
    const MesoHeightLevel& level = pyramid[std::size_t(number) - 1];
    const MesoMapSlopes left = MesoSlopesOfMap(level.Width, level.Height, level.Heights.data());
    for (int axis = 0; axis < 2; ++axis)
    {
      this->SlopesLost[number][axis] =
        static_cast<float>(std::max(ofMap.MeanSquare[axis] - left.MeanSquare[axis], 0.));
      // A few steep walls hide and shade less than the mean of their squares, and more than slopes that go up and
      // down as much evenly.
      const double bySize =
        std::max(VarianceOf(ofMap.MeanSize[axis]) - VarianceOf(left.MeanSize[axis]), 0.);
      this->Roughness[number][axis] =
        static_cast<float>(std::sqrt(bySize * this->SlopesLost[number][axis]));
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
  if (program->IsUniformUsed("mesoRoughnessOfLevels"))
  {
    program->SetUniform2fv("mesoRoughnessOfLevels", MostLevels, this->Roughness);
  }
  if (program->IsUniformUsed("mesoLastLevel"))
  {
    program->SetUniformi("mesoLastLevel", this->LastLevel);
  }
}

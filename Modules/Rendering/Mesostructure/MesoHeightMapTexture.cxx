#include "MesoHeightMapTexture.h"

#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <cstddef>

namespace
{
/// Root mean square of the steps from texel to texel along one axis, times the texels of a tile.
float SlopeOf(vtkImageData* image, const float* heights, int axis)
{
  int size[3];
  image->GetDimensions(size);
  const int stride = axis == 0 ? 1 : size[0];
  double sum = 0.;
  for (int row = 0; row + axis < size[1]; ++row)
  {
    const float* from = heights + std::ptrdiff_t(row) * size[0];
    for (int column = 0; column + (1 - axis) < size[0]; ++column)
    {
      const double step = double(from[column + stride]) - from[column];
      sum += step * step;
    }
  }
  return static_cast<float>(std::sqrt(sum / (double(size[0]) * size[1])) * size[axis]);
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
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Slope[axis] = SlopeOf(this->GetImage(), values, axis);
  }
  this->Bytes = this->Mipmaps ? bytes * 4 / 3 : bytes;
  return MesoUploadMap(
    this->Texture(), window, this->GetImage(), wrap, this->Mipmaps, "height map");
}

void MesoHeightMapTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoHeightMap");
  if (program->IsUniformUsed("mesoRootMeanSquareSlope"))
  {
    program->SetUniform2f("mesoRootMeanSquareSlope", this->Slope);
  }
}

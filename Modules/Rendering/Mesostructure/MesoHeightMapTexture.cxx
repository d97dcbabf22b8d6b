#include "MesoHeightMapTexture.h"

#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

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
  this->Bytes = this->Mipmaps ? bytes * 4 / 3 : bytes;
  return MesoUploadMap(
    this->Texture(), window, this->GetImage(), wrap, this->Mipmaps, "height map");
}

void MesoHeightMapTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoHeightMap");
}

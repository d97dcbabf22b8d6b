#include "MesoHeightMapTexture.h"

#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

MesoHeightMapTexture::MesoHeightMapTexture() = default;

MesoHeightMapTexture::~MesoHeightMapTexture() = default;

void MesoHeightMapTexture::SetHeightMap(vtkImageData* heights)
{
  this->HeightMap = heights;
  this->UploadedTime = 0;
}

vtkImageData* MesoHeightMapTexture::GetHeightMap() const
{
  return this->HeightMap;
}

void MesoHeightMapTexture::SetMipmaps(bool mipmaps)
{
  if (mipmaps != this->Mipmaps)
  {
    this->Mipmaps = mipmaps;
    this->UploadedTime = 0;
  }
}

std::string MesoHeightMapTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  vtkDataArray* heights = this->HeightMap->GetPointData()->GetScalars();
  if (!heights || heights->GetDataType() != VTK_FLOAT || heights->GetNumberOfComponents() != 1)
  {
    return "the height map must have one component of float";
  }
  const std::string failure =
    MesoUploadMap(this->Texture, window, this->HeightMap, wrap, this->Mipmaps, "height map");
  if (!failure.empty())
  {
    return failure;
  }
  this->UploadedTime = this->HeightMap->GetMTime();
  this->UploadedWrap = wrap;
  return {};
}

std::string MesoHeightMapTexture::Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  if (!this->HeightMap)
  {
    return {};
  }
  if (this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
    this->UploadedTime != this->HeightMap->GetMTime() || this->UploadedWrap != wrap)
  {
    const std::string failure = this->Upload(window, wrap);
    if (!failure.empty())
    {
      return failure;
    }
  }
  this->Texture->Activate();
  return {};
}

void MesoHeightMapTexture::SetUniforms(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("mesoHeightMap"))
  {
    program->SetUniformi("mesoHeightMap", this->Texture->GetTextureUnit());
  }
}

void MesoHeightMapTexture::Deactivate()
{
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Deactivate();
  }
}

void MesoHeightMapTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

std::size_t MesoHeightMapTexture::GetGPUBytes() const
{
  if (this->Texture->GetHandle() == 0)
  {
    return 0;
  }
  const std::size_t bytes =
    std::size_t(this->Texture->GetWidth()) * this->Texture->GetHeight() * sizeof(float);
  return this->Mipmaps ? bytes * 4 / 3 : bytes;
}

#include "MesoHeightMapTexture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
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

std::string MesoHeightMapTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  vtkDataArray* heights = this->HeightMap->GetPointData()->GetScalars();
  if (!heights || heights->GetDataType() != VTK_FLOAT || heights->GetNumberOfComponents() != 1)
  {
    return "the height map must have one component of float";
  }
  int size[3];
  this->HeightMap->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[0] > limit || size[1] > limit)
  {
    return "the height map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit) + " that this device takes";
  }
  const int wraps[] = { vtkTextureObject::Repeat, vtkTextureObject::ClampToEdge,
    vtkTextureObject::MirroredRepeat };
  vtkTextureObject* texture = this->Texture;
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(wraps[static_cast<int>(wrap)]);
  texture->SetWrapT(wraps[static_cast<int>(wrap)]);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), 1, VTK_FLOAT, heights->GetVoidPointer(0)))
  {
    return "the height map could not be made a texture";
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
  return std::size_t(this->Texture->GetWidth()) * this->Texture->GetHeight() * sizeof(float);
}

#include "MesoMapTexture.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

MesoMapTexture::MesoMapTexture(std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Textures.push_back(vtkSmartPointer<vtkTextureObject>::New());
  }
}

MesoMapTexture::~MesoMapTexture() = default;

void MesoMapTexture::SetImage(vtkImageData* image)
{
  this->Image = image;
  this->SetStale();
}

vtkImageData* MesoMapTexture::GetImage() const
{
  return this->Image;
}

vtkTextureObject* MesoMapTexture::Texture(std::size_t index) const
{
  return this->Textures[index];
}

bool MesoMapTexture::IsUploaded(vtkOpenGLRenderWindow* window, MesoWrap wrap) const
{
  return this->UploadedTime == this->Image->GetMTime() && this->UploadedWrap == wrap &&
    std::all_of(this->Textures.begin(), this->Textures.end(),
      [&](const auto& texture)
      { return texture->GetHandle() != 0 && texture->GetContext() == window; });
}

std::string MesoMapTexture::Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  if (!this->Image)
  {
    return {};
  }
  if (!this->IsUploaded(window, wrap))
  {
    const std::string failure = this->Upload(window, wrap);
    if (!failure.empty())
    {
      return failure;
    }
    this->UploadedTime = this->Image->GetMTime();
    this->UploadedWrap = wrap;
  }
  for (const auto& texture : this->Textures)
  {
    texture->Activate();
  }
  return {};
}

bool MesoMapTexture::SetSampler(
  vtkShaderProgram* program, const char* name, std::size_t index) const
{
  if (!program->IsUniformUsed(name))
  {
    return false;
  }
  program->SetUniformi(name, this->Textures[index]->GetTextureUnit());
  return true;
}

void MesoMapTexture::Deactivate()
{
  for (const auto& texture : this->Textures)
  {
    if (texture->GetHandle() != 0)
    {
      texture->Deactivate();
    }
  }
}

void MesoMapTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
}

std::size_t MesoMapTexture::GetGPUBytes() const
{
  return this->Textures.front()->GetHandle() == 0 ? 0 : this->Bytes;
}

#include "vtk_glew.h" // must come first

#include "MesoBufferTexture.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

MesoBufferTexture::MesoBufferTexture() = default;

MesoBufferTexture::~MesoBufferTexture() = default;

std::string MesoBufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<float>& numbers, const char* what)
{
  int most = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t texels = numbers.size() / 4;
  if (texels > static_cast<std::size_t>(most))
  {
    return std::string(what) + " need " + std::to_string(texels) +
      " texels of a buffer, of which this device takes " + std::to_string(most);
  }
  vtkTextureObject* texture = this->Texture;
  const bool first = texture->GetHandle() == 0 || texture->GetContext() != window;
  if (!this->Buffer->Upload(numbers, vtkOpenGLBufferObject::TextureBuffer))
  {
    return std::string(what) + " could not be made a buffer";
  }
  // A texture follows what its buffer holds.
  if (first)
  {
    texture->SetContext(window);
    if (!texture->CreateTextureBuffer(
          static_cast<unsigned int>(texels), 4, VTK_FLOAT, this->Buffer))
    {
      return std::string(what) + " could not be made a texture";
    }
  }
  this->Bytes = numbers.size() * sizeof(float);
  return {};
}

void MesoBufferTexture::Activate()
{
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Activate();
  }
}

void MesoBufferTexture::SetUniform(vtkShaderProgram* program, const char* name)
{
  if (this->Texture->GetHandle() != 0 && program->IsUniformUsed(name))
  {
    program->SetUniformi(name, this->Texture->GetTextureUnit());
  }
}

void MesoBufferTexture::Deactivate()
{
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Deactivate();
  }
}

void MesoBufferTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Bytes = 0;
}

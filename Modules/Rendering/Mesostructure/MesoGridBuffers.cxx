#include "vtk_glew.h" // must come first

#include "MesoGridBuffers.h"

#include "MesoGridBase.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

MesoGridBuffers::MesoGridBuffers() = default;

MesoGridBuffers::~MesoGridBuffers() = default;

std::string MesoGridBuffers::Upload(
  int which, vtkOpenGLRenderWindow* window, const std::vector<float>& numbers, const char* what)
{
  int most = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t texels = numbers.size() / 4;
  if (texels > static_cast<std::size_t>(most))
  {
    return std::string(what) + " need " + std::to_string(texels) +
      " texels of a buffer, of which this device takes " + std::to_string(most);
  }
  vtkTextureObject* texture = this->Textures[which];
  const bool first = texture->GetHandle() == 0 || texture->GetContext() != window;
  if (!this->Buffers[which]->Upload(numbers, vtkOpenGLBufferObject::TextureBuffer))
  {
    return std::string(what) + " could not be made a buffer";
  }
  // A texture follows what its buffer holds.
  if (first)
  {
    texture->SetContext(window);
    if (!texture->CreateTextureBuffer(
          static_cast<unsigned int>(texels), 4, VTK_FLOAT, this->Buffers[which]))
    {
      return std::string(what) + " could not be made a texture";
    }
  }
  this->Bytes[which] = numbers.size() * sizeof(float);
  return {};
}

std::string MesoGridBuffers::SetCorners(
  vtkOpenGLRenderWindow* window, const std::vector<float>& numbers)
{
  return this->Upload(0, window, numbers, "the corners of the mesh");
}

std::string MesoGridBuffers::SetPieces(vtkOpenGLRenderWindow* window, const MesoGridPieces& pieces)
{
  return this->Upload(1, window, pieces.Numbers, "the grids over the mesh");
}

void MesoGridBuffers::Activate()
{
  for (const auto& texture : this->Textures)
  {
    if (texture->GetHandle() != 0)
    {
      texture->Activate();
    }
  }
}

void MesoGridBuffers::SetUniforms(vtkShaderProgram* program)
{
  const char* const names[] = { "mesoCorners", "mesoPieces" };
  for (int i = 0; i < 2; ++i)
  {
    if (program->IsUniformUsed(names[i]))
    {
      program->SetUniformi(names[i], this->Textures[i]->GetTextureUnit());
    }
  }
}

void MesoGridBuffers::Deactivate()
{
  for (const auto& texture : this->Textures)
  {
    if (texture->GetHandle() != 0)
    {
      texture->Deactivate();
    }
  }
}

void MesoGridBuffers::Draw(vtkShaderProgram* program, const MesoGridPieces& pieces)
{
  if (this->Indices->GetHandle() == 0)
  {
    const std::vector<std::uint16_t> indices = MesoGridBase::MakeIndices();
    this->Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    this->Bytes[2] = indices.size() * sizeof(std::uint16_t);
  }
  this->Indices->Bind();
  for (const MesoGridPieces::Group& group : pieces.Groups)
  {
    program->SetUniformi("mesoFirstPiece", group.First);
    glDrawElementsInstanced(
      GL_TRIANGLES, 3 * group.Rows * group.Rows, GL_UNSIGNED_SHORT, nullptr, group.Count);
  }
  this->Indices->Release();
}

void MesoGridBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (int i = 0; i < 2; ++i)
  {
    this->Textures[i]->ReleaseGraphicsResources(window);
    this->Buffers[i]->ReleaseGraphicsResources();
  }
  this->Indices->ReleaseGraphicsResources();
  this->Bytes[0] = this->Bytes[1] = this->Bytes[2] = 0;
}

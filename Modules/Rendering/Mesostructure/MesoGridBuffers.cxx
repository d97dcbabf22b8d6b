#include "vtk_glew.h" // must come first

#include "MesoGridBuffers.h"

#include "MesoGridBase.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkShaderProgram.h"

MesoGridBuffers::MesoGridBuffers() = default;

MesoGridBuffers::~MesoGridBuffers() = default;

std::string MesoGridBuffers::SetCorners(
  vtkOpenGLRenderWindow* window, const std::vector<float>& numbers)
{
  return this->Corners.Upload(window, numbers, "the corners of the mesh");
}

std::string MesoGridBuffers::SetPieces(vtkOpenGLRenderWindow* window, const MesoGridPieces& pieces)
{
  return this->Pieces.Upload(window, pieces.Numbers, "the grids over the mesh");
}

void MesoGridBuffers::Activate()
{
  this->Corners.Activate();
  this->Pieces.Activate();
}

void MesoGridBuffers::SetUniforms(vtkShaderProgram* program)
{
  this->Corners.SetUniform(program, "mesoCorners");
  this->Pieces.SetUniform(program, "mesoPieces");
}

void MesoGridBuffers::Deactivate()
{
  this->Corners.Deactivate();
  this->Pieces.Deactivate();
}

void MesoGridBuffers::Draw(vtkShaderProgram* program, const MesoGridPieces& pieces)
{
  if (this->Indices->GetHandle() == 0)
  {
    this->Indices->Upload(MesoGridBase::MakeIndices(), vtkOpenGLBufferObject::ElementArrayBuffer);
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
  this->Corners.ReleaseGraphicsResources(window);
  this->Pieces.ReleaseGraphicsResources(window);
  this->Indices->ReleaseGraphicsResources();
}

std::size_t MesoGridBuffers::GetGPUBytes() const
{
  vtkOpenGLBufferObject* indices = this->Indices;
  const std::size_t ofIndices = indices->GetHandle() != 0
    ? std::size_t(3) * MesoGridBase::MostRows * MesoGridBase::MostRows * sizeof(std::uint16_t)
    : 0;
  return this->Corners.GetGPUBytes() + this->Pieces.GetGPUBytes() + ofIndices;
}

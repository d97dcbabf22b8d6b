#include "vtkMesoGeometryImageMapper.h"

#include "MesoActorView.h"
#include "MesoGeometryImageShader.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoGeometryImageMapper);

vtkMesoGeometryImageMapper::vtkMesoGeometryImageMapper()
  : Shader(std::make_unique<MesoGeometryImageShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::GeometryImage;
  this->SetOptions(options);
}

vtkMesoGeometryImageMapper::~vtkMesoGeometryImageMapper() = default;

void vtkMesoGeometryImageMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GeometryImage: " << this->GetGeometryImage() << "\n";
  os << indent << "LevelDrawn: " << this->GetLevelDrawn() << "\n";
}

void vtkMesoGeometryImageMapper::SetGeometryImage(vtkImageData* image)
{
  if (image != this->GetGeometryImage())
  {
    this->Shader->SetImage(image);
    this->Modified();
  }
}

vtkImageData* vtkMesoGeometryImageMapper::GetGeometryImage()
{
  return this->Shader->GetImage();
}

int vtkMesoGeometryImageMapper::GetLevelDrawn() const
{
  return this->Shader->GetLevel();
}

std::int64_t vtkMesoGeometryImageMapper::GetNumberOfTrianglesDrawn()
{
  return this->GetWhyPlain().empty() && this->Shader->GetShape().Diced
    ? this->Shader->GetNumberOfTriangles()
    : this->Superclass::GetNumberOfTrianglesDrawn();
}

MesoTechniqueShader* vtkMesoGeometryImageMapper::GetTechnique()
{
  return this->Shader.get();
}

MesoTechnique vtkMesoGeometryImageMapper::TechniqueOf(const MesoMesostructureOptions&) const
{
  return MesoTechnique::GeometryImage;
}

void vtkMesoGeometryImageMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = MesoTechnique::GeometryImage; // whose effects "auto" means
  this->Shader->SetOptions(options);
}

void vtkMesoGeometryImageMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceStart(renderer, actor);
  if (!this->PlacesVertices(actor))
  {
    return;
  }
  // The buffer of positions, whose place all matrices have in them, is made by now.
  vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO("vertexMC");
  std::array<double, 3> shift = { 0., 0., 0. };
  std::array<double, 3> scale = { 1., 1., 1. };
  if (buffer && buffer->GetCoordShiftAndScaleEnabled())
  {
    std::copy_n(buffer->GetShift().begin(), 3, shift.begin());
    std::copy_n(buffer->GetScale().begin(), 3, scale.begin());
  }
  this->Shader->SetBufferPlace(shift, scale);
  this->Shader->Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  this->Shader->ChooseLevel(MesoViewOfActor(renderer, actor));
}

void vtkMesoGeometryImageMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->PlacesVertices(actor))
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  if (this->ReadyToPlaceVertices(renderer, actor))
  {
    this->Shader->Draw();
  }
}

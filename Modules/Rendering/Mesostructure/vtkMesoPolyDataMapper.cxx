#include "vtk_glew.h" // must come first

#include "vtkMesoPolyDataMapper.h"

#include "MesoActorPasses.h"
#include "MesoClosedMesh.h"
#include "MesoHeightColors.h"
#include "MesoNormalMapTexture.h"
#include "MesoTechniqueShader.h"
#include "MesoVertexAttributes.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoShadowCasterPass.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
/// Whether each sample of a multisampled window has a ray of its own: where rays that miss are what makes
/// the outline, which the rasteriser's coverage knows nothing of.
bool TracesEachSample(vtkRenderer* renderer, const MesoEffects& drawn)
{
  return drawn.Has(MesoEffect::Silhouette) && GLEW_ARB_sample_shading &&
    renderer->GetRenderWindow()->GetMultiSamples() > 1;
}
}

vtkStandardNewMacro(vtkMesoPolyDataMapper);

vtkMesoPolyDataMapper::vtkMesoPolyDataMapper()
  : Plain(std::make_unique<MesoTechniqueShader>())
  , Attributes(std::make_unique<MesoVertexAttributes>())
  , NormalMap(std::make_unique<MesoNormalMapTexture>())
  , HeightColors(std::make_unique<MesoHeightColors>())
{
}

vtkMesoPolyDataMapper::~vtkMesoPolyDataMapper() = default;

void vtkMesoPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Options.Scale << "\n";
  os << indent << "Tiles: " << this->Options.Tiles[0] << " " << this->Options.Tiles[1] << "\n";
  os << indent << "Wrap: " << MesoName(this->Options.Wrap) << "\n";
  os << indent << "Quality: " << MesoName(this->Options.Quality) << "\n";
  os << indent << "NormalMap: " << this->GetNormalMap() << "\n";
  os << indent << "HeightColors: " << this->GetHeightColors() << "\n";
  os << indent << "ContourLines: spacing " << this->ContourLines.Spacing << ", "
     << this->ContourLines.Heights.size() << " heights, width " << this->ContourLines.Width << "\n";
  os << indent << "MapNumbers: " << this->MapNumbers[0] << " " << this->MapNumbers[1] << "\n";
  os << indent << "Effects:";
  for (const std::string& name : this->EffectsDrawn.Names())
  {
    os << " " << name;
  }
  os << "\n";
}

void vtkMesoPolyDataMapper::SetOptions(const MesoMesostructureOptions& options)
{
  const double scale = options.Scale;
  if (!(scale >= 0.0) || !(options.Tiles[0] > 0.0) || !(options.Tiles[1] > 0.0))
  {
    vtkErrorMacro("Scale must be at least 0 and tiles above 0; got scale "
      << scale << ", tiles " << options.Tiles[0] << " " << options.Tiles[1]);
    return;
  }
  if (!options.Effects.Auto)
  {
    const MesoEffects missing =
      options.Effects.Named.Without(MesoEffectsOfTechnique(this->TechniqueOf(options)));
    if (!missing.Empty())
    {
      vtkErrorMacro("The technique does not provide the effect " << missing.Names().front());
      return;
    }
  }
  this->Options = options;
  this->OptionsTime.Modified();
  this->OptionsChanged();
}

void vtkMesoPolyDataMapper::SetScale(double scale)
{
  MesoMesostructureOptions options = this->Options;
  options.Scale = scale;
  this->SetOptions(options);
}

void vtkMesoPolyDataMapper::ComputeBounds()
{
  this->Superclass::ComputeBounds();
  // Said here, as what has no bounds comes to no drawing.
  vtkDataObject* data = this->GetInputDataObject(0, 0);
  if (data && !this->GetInput())
  {
    this->WhyPlain = "The input is a " + std::string(data->GetClassName()) +
      " and only a vtkPolyData is drawn: vtkCompositeDataGeometryFilter makes one of the surfaces "
      "of composite data.";
    this->WarnOnce(this->WhyPlain);
  }
  const MesoShaderShape shape = this->GetTechnique()->GetShape();
  if (vtkMath::AreBoundsInitialized(this->Bounds) && (shape.Traces || shape.Diced) &&
    MesoEffectsOfTechnique(this->TechniqueOf(this->Options)).Has(MesoEffect::Depth))
  {
    for (int i = 0; i < 6; ++i)
    {
      this->Bounds[i] += i % 2 == 0 ? -this->Options.Scale : this->Options.Scale;
    }
  }
}

void vtkMesoPolyDataMapper::SetTiles(double u, double v)
{
  MesoMesostructureOptions options = this->Options;
  options.Tiles = { u, v };
  this->SetOptions(options);
}

MesoTechnique vtkMesoPolyDataMapper::TechniqueOf(const MesoMesostructureOptions&) const
{
  return MesoTechnique::Plain;
}

void vtkMesoPolyDataMapper::SetHeightColors(vtkLookupTable* table)
{
  if (table != this->HeightColors->GetTable())
  {
    this->HeightColors->SetTable(table);
    this->Modified();
  }
}

vtkLookupTable* vtkMesoPolyDataMapper::GetHeightColors() const
{
  return this->HeightColors->GetTable();
}

void vtkMesoPolyDataMapper::SetContourLines(const MesoContourLines& lines)
{
  const std::string problem = lines.Problem();
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return;
  }
  this->ContourLines = lines;
  this->Modified();
}

void vtkMesoPolyDataMapper::SetMapNumbers(double atZero, double atOne)
{
  this->MapNumbers = { atZero, atOne };
}

bool vtkMesoPolyDataMapper::DrawsContours(const MesoShaderShape& shape) const
{
  const bool readsHeights = shape.Traces && shape.UsesFrame &&
    std::find(shape.Chunks.begin(), shape.Chunks.end(), "Kernels/HeightField.glsl") !=
      shape.Chunks.end();
  return !this->ContourLines.Empty() && (readsHeights || shape.Displaced);
}

void vtkMesoPolyDataMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkMesoPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetOptions(other->Options);
    this->SetHeightColors(other->GetHeightColors());
    this->SetNormalMap(other->GetNormalMap(), other->NormalMap->GetMeaning());
    this->SetContourLines(other->ContourLines);
    this->SetMapNumbers(other->MapNumbers[0], other->MapNumbers[1]);
  }
  if (auto* other = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetPointIdArrayName(other->GetPointIdArrayName());
    this->SetCompositeIdArrayName(other->GetCompositeIdArrayName());
    this->SetProcessIdArrayName(other->GetProcessIdArrayName());
    this->SetCellIdArrayName(other->GetCellIdArrayName());
  }
  // vtkOpenGLPolyDataMapper's own copies these, and shader code by functions that warn of themselves.
  this->vtkPolyDataMapper::ShallowCopy(mapper);
}

void vtkMesoPolyDataMapper::SetNormalMap(vtkImageData* map, const MesoNormalMapMeaning& meaning)
{
  this->NormalMap->SetNormalMap(map, meaning);
  this->Modified();
}

vtkImageData* vtkMesoPolyDataMapper::GetNormalMap() const
{
  return this->NormalMap->GetNormalMap();
}

MesoShaderShape vtkMesoPolyDataMapper::Shape()
{
  MesoShaderShape shape = this->GetTechnique()->GetShape();
  if (shape.Traces && this->GetNormalMap() && this->EffectsChosen().Has(MesoEffect::Shading))
  {
    this->NormalMap->AddTo(shape);
  }
  return shape;
}

MesoEffects vtkMesoPolyDataMapper::EffectsChosen() const
{
  return this->Options.Effects.Auto ? MesoEffectsOfTechnique(this->TechniqueOf(this->Options))
                                    : this->Options.Effects.Named;
}

MesoTechniqueShader* vtkMesoPolyDataMapper::GetTechnique()
{
  return this->Plain.get();
}

void vtkMesoPolyDataMapper::WarnOnce(const std::string& reason)
{
  if (reason != this->LastWarning)
  {
    this->LastWarning = reason;
    vtkWarningMacro(<< reason);
  }
}

std::string vtkMesoPolyDataMapper::WhyNot(const MesoShaderShape& shape)
{
  if (!shape.Traces && !shape.Diced)
  {
    return {};
  }
  const std::string missing = MesoVertexAttributes::Missing(this->CurrentInput, shape);
  if (!missing.empty())
  {
    return "The input lacks" + missing +
      ": the base mesh is drawn. vtkMesoSurfaceFrames makes frames from texture coordinates, "
      "vtkMesoQuadricFit quadrics.";
  }
  return {};
}

void vtkMesoPolyDataMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  MesoTechniqueShader* technique = this->GetTechnique();
  const MesoShaderShape shape = this->Shape();
  this->WhyPlain = this->WhyNot(shape);
  if (this->WhyPlain.empty())
  {
    this->WhyPlain =
      technique->Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  }
  if (this->WhyPlain.empty())
  {
    this->WhyPlain = this->NormalMap->Activate(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), this->Options.Wrap);
  }
  if (!this->WhyPlain.empty())
  {
    this->WarnOnce(this->WhyPlain);
  }
  else if (shape.Traces && actor->GetProperty()->GetTexture("normalTex"))
  {
    this->WarnOnce(
      "The normal texture of the actor's property is not read: relief has the normals of "
      "its height map.");
  }
  this->EffectsDrawn = !this->WhyPlain.empty() || !(shape.Traces || shape.Displaced)
    ? MesoEffects()
    : this->EffectsChosen();
  const bool takesShadows = this->CastsShadow() && MesoInPass<vtkMesoShadowMapPass>(actor);
  this->EffectsDrawn.Set(MesoEffect::CastShadow, takesShadows);
  const bool caster = MesoInPass<vtkMesoShadowCasterPass>(actor);
  const std::string uncolored =
    this->HeightColors->Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  this->HeightColorsReady = this->HeightColors->GetTable() && uncolored.empty();
  if (!uncolored.empty())
  {
    this->WarnOnce(uncolored);
  }
  // The same in all passes of a frame with shadows, so that none undoes another's. A technique that
  // places the vertices reads no attributes.
  if (this->PlacesVertices(actor))
  {
    this->Attributes->Clear(this);
  }
  else if (shape.Traces || MesoInPass<vtkMesoAOVPass>(actor) || this->HeightColorsReady ||
    this->DrawsContours(shape) || takesShadows || caster)
  {
    this->Attributes->Map(this, this->CurrentInput, shape);
  }
  else
  {
    this->Attributes->Clear(this);
  }
  this->Superclass::RenderPieceStart(renderer, actor);
  if (caster)
  {
    this->SetCulling(renderer);
  }
  if (TracesEachSample(renderer, this->EffectsDrawn))
  {
    glEnable(GL_SAMPLE_SHADING_ARB);
    glMinSampleShadingARB(1.f);
  }
}

void vtkMesoPolyDataMapper::SetCulling(vtkRenderer* renderer)
{
  vtkOpenGLState* state =
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  if (this->ClosedMesh != this->CurrentInput ||
    this->ClosedTime < this->CurrentInput->GetMeshMTime())
  {
    this->ClosedMesh = this->CurrentInput;
    this->Closed = MesoIsClosed(this->CurrentInput);
    this->ClosedTime.Modified();
  }
  // Of a traced surface that is closed, what is seen from behind lies behind what is seen from
  // before; a ray that misses the front has passed it by.
  if (this->Closed && this->WhyPlain.empty() && this->GetTechnique()->GetShape().Traces)
  {
    state->vtkglCullFace(GL_BACK);
    state->vtkglEnable(GL_CULL_FACE);
  }
  else
  {
    state->vtkglDisable(GL_CULL_FACE);
  }
}

void vtkMesoPolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  if (TracesEachSample(renderer, this->EffectsDrawn))
  {
    glDisable(GL_SAMPLE_SHADING_ARB);
  }
  if (MesoInPass<vtkMesoShadowCasterPass>(actor))
  {
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
      ->GetState()
      ->vtkglDisable(GL_CULL_FACE);
  }
  this->GetTechnique()->Deactivate();
  this->NormalMap->Deactivate();
  this->HeightColors->Deactivate();
}

void vtkMesoPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->GetTechnique()->ReleaseGraphicsResources(window);
  this->NormalMap->ReleaseGraphicsResources(window);
  this->HeightColors->ReleaseGraphicsResources(window);
  this->BuiltKeys.clear();
  this->Superclass::ReleaseGraphicsResources(window);
}

bool vtkMesoPolyDataMapper::PlacesVertices(vtkActor* actor)
{
  return this->WhyPlain.empty() && this->GetTechnique()->GetShape().Diced && !this->PointPicking &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

bool vtkMesoPolyDataMapper::ReadyToPlaceVertices(vtkRenderer* renderer, vtkActor* actor)
{
  this->DrawingVertices = false;
  this->DrawingSelection = false;
  // What is drawn stands for polygons and strips alike; the first of the two that there is lends its
  // shader.
  for (const int kind : { PrimitiveTris, PrimitiveTriStrips })
  {
    vtkOpenGLHelper& helper = this->Primitives[kind];
    if (helper.IBO->IndexCount > 0)
    {
      this->UpdateShaders(helper, renderer, actor);
      return helper.Program != nullptr;
    }
  }
  return false;
}

std::int64_t vtkMesoPolyDataMapper::GetNumberOfTrianglesDrawn()
{
  return this->GetInput() ? this->GetInput()->GetNumberOfPolys() : 0;
}

std::size_t vtkMesoPolyDataMapper::GetGPUBytes()
{
  std::size_t bytes = this->GetTechnique()->GetGPUBytes() + this->NormalMap->GetGPUBytes() +
    this->HeightColors->GetGPUBytes() + this->GetGeometryBytes();
  std::vector<std::string> buffers = this->Attributes->Names();
  buffers.insert(buffers.end(), { "vertexMC", "normalMC", "scalarColor", "tcoord" });
  for (const std::string& name : buffers)
  {
    if (vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO(name.c_str()))
    {
      bytes += std::size_t(buffer->GetNumberOfTuples()) * buffer->GetStride();
    }
  }
  for (const vtkOpenGLHelper& primitive : this->Primitives)
  {
    bytes += primitive.IBO->IndexCount * sizeof(unsigned int);
  }
  return bytes;
}

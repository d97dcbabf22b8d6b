#include "vtk_glew.h" // must come first

#include "vtkMesoPolyDataMapper.h"

#include "MesoActorPasses.h"
#include "MesoClosedMesh.h"
#include "MesoHeightColors.h"
#include "MesoHitTextures.h"
#include "MesoNormalMapTexture.h"
#include "MesoShaderAssembler.h"
#include "MesoShaderBuild.h"
#include "MesoShaderLibrary.h"
#include "MesoSurfaceUniforms.h"
#include "MesoTechniqueShader.h"
#include "MesoVertexAttributes.h"
#include "MesoViewMatrices.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoShadowCasterPass.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkTexture.h"

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

MesoShaderBuild vtkMesoPolyDataMapper::DescribeBuild(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  MesoShaderBuild build;
  const auto& info = this->PrimitiveInfo[&cellBO];
  build.LightComplexity = info.LastLightCount > 0 ? info.LastLightComplexity : 0;
  build.LightCount = info.LastLightCount;
  build.Lit = info.LastLightComplexity > 0;
  const bool aov = MesoInPass<vtkMesoAOVPass>(actor);
  build.Caster = MesoInPass<vtkMesoShadowCasterPass>(actor);
  const bool takesShadows = this->CastsShadow() && MesoInPass<vtkMesoShadowMapPass>(actor);
  build.OwnLighting = build.LightComplexity > 0 && !build.Caster &&
    actor->GetProperty()->GetInterpolation() != VTK_PBR && !MesoInLightingMap(actor);

  vtkPointData* points = this->CurrentInput->GetPointData();
  const bool triangles =
    cellBO.PrimitiveType == PrimitiveTris || cellBO.PrimitiveType == PrimitiveTriStrips;
  MesoShaderShape shape = this->WhyPlain.empty() ? this->Shape() : this->Plain->GetShape();
  if (build.Caster && shape.MeshCasts)
  {
    shape = this->Plain->GetShape();
  }
  build.Surface = triangles && !this->PointPicking &&
    (shape.Traces || aov || this->HeightColorsReady || this->DrawsContours(shape) ||
      takesShadows) &&
    points->GetNormals() && (points->GetTCoords() || !shape.Traces);
  build.Diced = triangles && this->PlacesVertices(actor);
  build.Surface = build.Surface && build.Diced == shape.Diced;
  build.HeightColored = build.Surface && this->HeightColorsReady && !build.Caster;
  build.MatterColored =
    build.Surface && shape.MatterColored && !build.HeightColored && !build.Caster;
  build.Contoured = build.Surface && this->DrawsContours(shape) && !build.Caster;
  build.ContourHeights = static_cast<int>(this->ContourLines.Heights.size());
  build.Traces = build.Surface && shape.Traces;
  build.Clipped = build.Traces && this->GetNumberOfClippingPlanes() > 0;
  build.WritesDepth = build.Traces && (shape.WritesDepth || build.Caster);
  build.Textured = !build.Caster && build.Traces && this->HaveTCoords(this->CurrentInput) &&
    MesoHasColorTextures(this->GetTextures(actor));

  build.NormalMapped = build.Traces && shape.NormalMapped;

  const bool scalarsAtVertices = this->VBOs->GetNumberOfComponents("scalarColor") != 0;
  build.ScalarTexture = !scalarsAtVertices && this->InterpolateScalarsBeforeMapping &&
    this->ColorCoordinates && this->HaveTCoords(this->CurrentInput);
  build.Scalars = build.Traces && !build.HeightColored && !this->DrawingVertices &&
    (scalarsAtVertices || build.ScalarTexture);
  build.Numbers = aov;
  build.TakesShadows = takesShadows && build.OwnLighting;
  build.Specular = actor->GetProperty()->GetSpecular() != 0.0;
  vtkInformation* keys = actor->GetPropertyKeys();
  build.TextureMoved = keys && keys->Has(vtkProp::GeneralTextureTransform());
  build.Define(shape);
  return build;
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

bool vtkMesoPolyDataMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const bool rebuild = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  std::string& built = this->BuiltKeys[&cellBO];
  const std::string wanted = this->DescribeBuild(cellBO, actor).Definitions;
  if (built == wanted)
  {
    return rebuild;
  }
  built = wanted;
  return true;
}

void vtkMesoPolyDataMapper::Report(const MesoShaderAssembler& assembler)
{
  for (const std::string& error : assembler.GetErrors())
  {
    vtkErrorMacro(<< error);
  }
}

void vtkMesoPolyDataMapper::ReplaceShaderValues(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const MesoShaderBuild build = this->DescribeBuild(*this->LastBoundBO, actor);
  MesoShaderAssembler vertex("vertex shader", shaders[vtkShader::Vertex]->GetSource());
  MesoShaderAssembler geometry("geometry shader", shaders[vtkShader::Geometry]->GetSource());
  MesoShaderAssembler fragment("fragment shader", shaders[vtkShader::Fragment]->GetSource());
  if (build.Surface || build.Diced)
  {
    build.SpliceVertexShader(vertex);
    if (!geometry.GetText().empty())
    {
      build.SpliceGeometryShader(geometry);
    }
  }
  if (build.Surface || build.Diced || build.OwnLighting)
  {
    build.SpliceFragmentShader(fragment);
  }
  shaders[vtkShader::Vertex]->SetSource(vertex.GetText());
  shaders[vtkShader::Geometry]->SetSource(geometry.GetText());
  shaders[vtkShader::Fragment]->SetSource(fragment.GetText());

  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);

  if (build.Diced)
  {
    MesoShaderAssembler placed("vertex shader", shaders[vtkShader::Vertex]->GetSource());
    MesoShaderAssembler edges("geometry shader", shaders[vtkShader::Geometry]->GetSource());
    MesoShaderAssembler cells("fragment shader", shaders[vtkShader::Fragment]->GetSource());
    MesoShaderBuild::PlaceVertices(placed, edges, cells);
    shaders[vtkShader::Vertex]->SetSource(placed.GetText());
    shaders[vtkShader::Geometry]->SetSource(edges.GetText());
    shaders[vtkShader::Fragment]->SetSource(cells.GetText());
    this->Report(placed);
    this->Report(edges);
    this->Report(cells);
  }
  if (build.Textured || build.Scalars)
  {
    MesoShaderAssembler atHit("fragment shader", shaders[vtkShader::Fragment]->GetSource());
    if (build.Textured)
    {
      MesoReadTexturesAtHit(atHit, this->GetTextures(actor));
    }
    if (build.Scalars)
    {
      MesoReadScalarsAtHit(atHit, build.ScalarTexture);
    }
    shaders[vtkShader::Fragment]->SetSource(atHit.GetText());
    this->Report(atHit);
  }
  if (build.WritesDepth && MesoInPass<vtkShadowMapBakerPass>(actor))
  {
    MesoShaderAssembler baked("fragment shader", shaders[vtkShader::Fragment]->GetSource());
    MesoShaderBuild::ShowDetailToVTKShadows(baked);
    shaders[vtkShader::Fragment]->SetSource(baked.GetText());
    this->Report(baked);
  }
  this->Report(vertex);
  this->Report(geometry);
  this->Report(fragment);
  MesoDumpShader("vert", shaders[vtkShader::Vertex]->GetSource());
  MesoDumpShader("geom", shaders[vtkShader::Geometry]->GetSource());
  MesoDumpShader("frag", shaders[vtkShader::Fragment]->GetSource());
}

void vtkMesoPolyDataMapper::ReplaceShaderLight(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const MesoShaderBuild build = this->DescribeBuild(*this->LastBoundBO, actor);
  if (build.Caster)
  {
    return;
  }
  if (!build.OwnLighting)
  {
    this->Superclass::ReplaceShaderLight(shaders, renderer, actor);
    return;
  }
  MesoShaderAssembler fragment("fragment shader", shaders[vtkShader::Fragment]->GetSource());
  build.AddLighting(fragment, static_cast<vtkOpenGLRenderer*>(renderer)->GetLightingUniforms());
  shaders[vtkShader::Fragment]->SetSource(fragment.GetText());
  this->Report(fragment);
}

void vtkMesoPolyDataMapper::ReplaceShaderClip(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  // VTK's planes cut the base mesh; those of the hit are in the shader already.
  if (!this->DescribeBuild(*this->LastBoundBO, actor).Clipped)
  {
    this->Superclass::ReplaceShaderClip(shaders, renderer, actor);
  }
}

void vtkMesoPolyDataMapper::ReplaceShaderCoincidentOffset(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->DescribeBuild(*this->LastBoundBO, actor).WritesDepth)
  {
    this->Superclass::ReplaceShaderCoincidentOffset(shaders, renderer, actor);
    return;
  }
  float factor = 0.0f;
  float offset = 0.0f;
  this->GetCoincidentParameters(renderer, actor, factor, offset);
  if (factor == 0.0f && offset == 0.0f)
  {
    return;
  }
  MesoShaderAssembler fragment("fragment shader", shaders[vtkShader::Fragment]->GetSource());
  fragment.Replace("//VTK::Coincident::Dec", "Common/CoincidentDec.glsl",
    MesoShaderText("Common/CoincidentDec.glsl"));
  fragment.Replace("//MESO::CoincidentDepth", "Common/CoincidentImpl.glsl",
    MesoShaderText("Common/CoincidentImpl.glsl"));
  shaders[vtkShader::Fragment]->SetSource(fragment.GetText());
  this->Report(fragment);
}

void vtkMesoPolyDataMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  if (cellBO.Program->IsUniformUsed("mesoTiles"))
  {
    const float tiles[2] = { static_cast<float>(this->Options.Tiles[0]),
      static_cast<float>(this->Options.Tiles[1]) };
    cellBO.Program->SetUniform2f("mesoTiles", tiles);
  }
  if (this->WhyPlain.empty())
  {
    this->GetTechnique()->SetUniforms(cellBO.Program);
    this->NormalMap->SetUniforms(cellBO.Program);
  }
  MesoSetContourUniforms(cellBO.Program, this->ContourLines);
  if (this->HeightColorsReady)
  {
    this->HeightColors->SetUniforms(cellBO.Program);
  }
}

void vtkMesoPolyDataMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  vtkOpenGLVertexBufferObject* positions = this->VBOs->GetVBO("vertexMC");
  const bool moved = positions && positions->GetCoordShiftAndScaleEnabled();
  if (this->ClippingPlanes)
  {
    MesoSetClipUniforms(cellBO.Program, this->ClippingPlanes, renderer);
  }
  MesoSetViewMatrices(cellBO.Program, renderer, actor, moved ? this->VBOShiftScale.Get() : nullptr,
    this->GetTechnique()->GetCentre());
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

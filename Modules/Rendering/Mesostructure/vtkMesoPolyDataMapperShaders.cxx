// What vtkMesoPolyDataMapper does for its shaders: which parts they need, putting those into VTK's text, and
// setting their uniforms.

#include "vtk_glew.h" // must come first

#include "vtkMesoPolyDataMapper.h"

#include "MesoActorPasses.h"
#include "MesoHeightColors.h"
#include "MesoHitTextures.h"
#include "MesoNormalMapTexture.h"
#include "MesoShaderAssembler.h"
#include "MesoShaderBuild.h"
#include "MesoShaderLibrary.h"
#include "MesoSurfaceUniforms.h"
#include "MesoTechniqueShader.h"
#include "MesoViewMatrices.h"
#include "vtkActor.h"
#include "vtkLookupTable.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoShadowCasterPass.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkTexture.h"

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

#include "vtk_glew.h" // must come first

#include "vtkMesoPolyDataMapper.h"

#include "MesoActorPasses.h"
#include "MesoHeightColors.h"
#include "MesoShaderAssembler.h"
#include "MesoShaderBuild.h"
#include "MesoShaderLibrary.h"
#include "MesoTechniqueShader.h"
#include "MesoViewMatrices.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMesoAOVPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
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
#include <cstdlib>
#include <fstream>

vtkStandardNewMacro(vtkMesoPolyDataMapper);

namespace
{
void DumpShader(const char* stage, const std::string& text)
{
  const char* folder = std::getenv("MESO_DUMP_SHADERS");
  if (folder && *folder && !text.empty())
  {
    static int number = 0;
    std::ofstream(
      std::string(folder) + "/shader" + std::to_string(number++) + "." + stage + ".glsl")
      << text;
  }
}
}

vtkMesoPolyDataMapper::vtkMesoPolyDataMapper()
  : Plain(std::make_unique<MesoTechniqueShader>())
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
  os << indent << "HeightColors: " << this->GetHeightColors() << "\n";
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
  if (vtkMath::AreBoundsInitialized(this->Bounds) && this->GetTechnique()->GetShape().Traces)
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

std::string vtkMesoPolyDataMapper::WhyNot(const MesoShaderShape& shape, vtkActor* actor)
{
  if (!shape.Traces)
  {
    return {};
  }
  if (MesoInPass<vtkShadowMapBakerPass>(actor))
  {
    return "Shadow map passes do not see the displaced surface yet: the base mesh is drawn.";
  }
  vtkPointData* points = this->CurrentInput->GetPointData();
  std::string missing;
  // Attributes of a shader are mapped by the arrays' names.
  if (!points->GetNormals() || !points->GetNormals()->GetName())
  {
    missing += " named normals";
  }
  if (!points->GetTCoords() || !points->GetTCoords()->GetName() ||
    points->GetTCoords()->GetNumberOfComponents() != 2)
  {
    missing += " named texture coordinates (2 components)";
  }
  for (const auto& attribute : shape.Attributes)
  {
    if (!points->GetArray(attribute.second.c_str()))
    {
      missing += " " + attribute.second;
    }
  }
  if (!missing.empty())
  {
    return "The input lacks" + missing +
      ": the base mesh is drawn. vtkMesoSurfaceFrames makes frames from texture coordinates, "
      "vtkMesoQuadricFit quadrics.";
  }
  return {};
}

void vtkMesoPolyDataMapper::MapAttributes(const MesoShaderShape& shape, bool numbers)
{
  if (!shape.Traces && !numbers)
  {
    this->RemoveVertexAttributeMapping("mesoTCoord"); // left by AOVs
    this->RemoveVertexAttributeMapping("mesoNormal");
    for (const auto& attribute : shape.Attributes)
    {
      this->RemoveVertexAttributeMapping(attribute.first.c_str());
    }
    return;
  }
  vtkPointData* points = this->CurrentInput->GetPointData();
  const auto map = [&](const char* attribute, vtkDataArray* array)
  {
    const auto mapped = this->ExtraAttributes.find(attribute);
    const std::string now =
      mapped == this->ExtraAttributes.end() ? std::string() : mapped->second.DataArrayName;
    const std::string wanted = array && array->GetName() ? array->GetName() : "";
    if (now != wanted)
    {
      this->MapDataArrayToVertexAttribute(attribute, wanted.empty() ? nullptr : wanted.c_str(),
        vtkDataObject::FIELD_ASSOCIATION_POINTS);
    }
  };
  map("mesoTCoord", points->GetTCoords());
  map("mesoNormal", points->GetNormals());
  for (const auto& attribute : shape.Attributes)
  {
    map(attribute.first.c_str(), points->GetArray(attribute.second.c_str()));
  }
}

void vtkMesoPolyDataMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  MesoTechniqueShader* technique = this->GetTechnique();
  const MesoShaderShape shape = technique->GetShape();
  this->WhyPlain = this->WhyNot(shape, actor);
  if (this->WhyPlain.empty())
  {
    this->WhyPlain =
      technique->Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  }
  if (!this->WhyPlain.empty())
  {
    this->WarnOnce(this->WhyPlain);
  }
  else if (shape.Traces && this->GetNumberOfClippingPlanes() > 0)
  {
    this->WarnOnce("Clipping planes cut the base mesh, not the relief below it.");
  }
  this->EffectsDrawn = !this->WhyPlain.empty() || !(shape.Traces || shape.Displaced)
    ? MesoEffects()
    : (this->Options.Effects.Auto ? MesoEffectsOfTechnique(this->TechniqueOf(this->Options))
                                  : this->Options.Effects.Named);
  const std::string uncolored =
    this->HeightColors->Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  this->HeightColorsReady = this->HeightColors->GetTable() && uncolored.empty();
  if (!uncolored.empty())
  {
    this->WarnOnce(uncolored);
  }
  this->MapAttributes(shape, MesoInPass<vtkMesoAOVPass>(actor) || this->HeightColorsReady);
  this->Superclass::RenderPieceStart(renderer, actor);
}

void vtkMesoPolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  this->GetTechnique()->Deactivate();
  this->HeightColors->Deactivate();
}

void vtkMesoPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->GetTechnique()->ReleaseGraphicsResources(window);
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
  build.OwnLighting = build.LightComplexity > 0 &&
    actor->GetProperty()->GetInterpolation() != VTK_PBR && !MesoInLightingMap(actor);

  vtkPointData* points = this->CurrentInput->GetPointData();
  const bool triangles =
    cellBO.PrimitiveType == PrimitiveTris || cellBO.PrimitiveType == PrimitiveTriStrips;
  const MesoShaderShape shape =
    this->WhyPlain.empty() ? this->GetTechnique()->GetShape() : this->Plain->GetShape();
  build.Surface = triangles && !this->PointPicking &&
    (shape.Traces || aov || this->HeightColorsReady) && points->GetNormals() &&
    (points->GetTCoords() || !shape.Traces);
  build.HeightColored = build.Surface && this->HeightColorsReady;
  build.Chunks = shape.Chunks;
  build.VertexChunks = shape.VertexChunks;
  build.Traces = build.Surface && shape.Traces;
  build.WritesDepth = build.Traces && shape.WritesDepth;
  build.Textured =
    build.Traces && this->HaveTCoords(this->CurrentInput) && this->HasColorTextures(actor);

  std::vector<std::pair<std::string, std::string>> defines;
  const auto define = [&](const char* name, bool on)
  {
    if (on)
    {
      defines.emplace_back(name, "");
    }
  };
  define("MESO_SURFACE", build.Surface);
  define("MESO_AOV", aov && build.Surface);
  define("MESO_HEIGHT_COLORS", build.HeightColored);
  define("MESO_LIT", build.Lit);
  define("MESO_LIGHTING", build.OwnLighting);
  define("MESO_HEADLIGHT", build.LightComplexity == 1);
  define("MESO_SPECULAR", actor->GetProperty()->GetSpecular() != 0.0);
  vtkInformation* keys = actor->GetPropertyKeys();
  define("MESO_TEXTURE_TRANSFORM",
    build.Textured && keys && keys->Has(vtkProp::GeneralTextureTransform()));
  defines.emplace_back("MESO_LIGHT_COUNT", std::to_string(build.LightCount));
  if (build.Surface)
  {
    define("MESO_FRAME", shape.UsesFrame);
    define("MESO_DISPLACED", shape.Displaced);
    defines.insert(defines.end(), shape.Defines.begin(), shape.Defines.end());
  }
  build.Definitions = MesoShaderAssembler::DefineLines(defines);
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

bool vtkMesoPolyDataMapper::HasColorTextures(vtkActor* actor)
{
  const auto textures = this->GetTextures(actor);
  return std::any_of(textures.begin(), textures.end(),
    [](const auto& texture) { return texture.second != "colortexture"; }); // scalar colours
}

void vtkMesoPolyDataMapper::ReadTexturesAtHit(MesoShaderAssembler& fragment, vtkActor* actor)
{
  for (const auto& texture : this->GetTextures(actor))
  {
    if (texture.second == "colortexture" || texture.first->GetCubeMap())
    {
      continue; // scalar colours, environments
    }
    const std::string asWritten = "texture(" + texture.second + ", tcoordVCVSOutput)";
    // A texture that VTK has no use for is not read; the actor's own always is.
    const int count = fragment.Count(asWritten);
    if (count > 0 || texture.second == "actortexture")
    {
      fragment.Rename(
        asWritten, "textureAtHit(" + texture.second + ", tcoordVCVSOutput)", std::max(1, count));
    }
  }
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
  if (build.Surface)
  {
    build.SpliceVertexShader(vertex);
    if (!geometry.GetText().empty())
    {
      build.SpliceGeometryShader(geometry);
    }
  }
  if (build.Surface || build.OwnLighting)
  {
    build.SpliceFragmentShader(fragment);
  }
  shaders[vtkShader::Vertex]->SetSource(vertex.GetText());
  shaders[vtkShader::Geometry]->SetSource(geometry.GetText());
  shaders[vtkShader::Fragment]->SetSource(fragment.GetText());

  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);

  if (build.Textured)
  {
    MesoShaderAssembler textured("fragment shader", shaders[vtkShader::Fragment]->GetSource());
    this->ReadTexturesAtHit(textured, actor);
    shaders[vtkShader::Fragment]->SetSource(textured.GetText());
    this->Report(textured);
  }
  this->Report(vertex);
  this->Report(geometry);
  this->Report(fragment);
  DumpShader("vert", shaders[vtkShader::Vertex]->GetSource());
  DumpShader("geom", shaders[vtkShader::Geometry]->GetSource());
  DumpShader("frag", shaders[vtkShader::Fragment]->GetSource());
}

void vtkMesoPolyDataMapper::ReplaceShaderLight(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const MesoShaderBuild build = this->DescribeBuild(*this->LastBoundBO, actor);
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
  fragment.Replace("//VTK::Depth::Impl", "Common/CoincidentImpl.glsl",
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
  }
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
  MesoSetViewMatrices(cellBO.Program, renderer, actor, moved ? this->VBOShiftScale.Get() : nullptr);
}

std::size_t vtkMesoPolyDataMapper::GetGPUBytes()
{
  std::size_t bytes = this->GetTechnique()->GetGPUBytes() + this->HeightColors->GetGPUBytes();
  std::vector<std::string> buffers = { "vertexMC", "normalMC", "scalarColor", "tcoord",
    "mesoTCoord", "mesoNormal" };
  for (const auto& attribute : this->GetTechnique()->GetShape().Attributes)
  {
    buffers.push_back(attribute.first);
  }
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

#include "MesoShaderBuild.h"

#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"
#include "MesoTechniqueShader.h"

namespace
{
/// One line of GLSL for a light: where it comes from.
std::string LightLine(int complexity, int index)
{
  const std::string i = std::to_string(index);
  const std::string kinds[] = { "headlight()", "directionalLight(lightDirectionVC" + i + ")",
    "positionalLight(vertexVC.xyz, lightPositional" + i + ", lightDirectionVC" + i +
      ", lightPositionVC" + i + ", lightAttenuation" + i + ", lightConeAngle" + i +
      ", lightExponent" + i + ")" };
  return "  mesoLights[" + i + "] = " + kinds[complexity - 1] + ";\n";
}

/// Two lines of GLSL for a light: shade by it. vtkShadowMapPass rewrites just the first of them.
std::string ShadingLines(int complexity, int index)
{
  const std::string i = std::to_string(index);
  const std::string shade = complexity == 1
    ? "  shadeHeadlight(radiance, normalVCVSOutput, diffuseColor, specularPower);\n"
    : "  shade(" + i + ", radiance, normalVCVSOutput, vertexVC.xyz, specularPower);\n";
  return "  radiance = lightColor" + i + ";\n" + shade;
}

/// Splices the text of a chunk of Shaders/ before a hook.
void Before(MesoShaderAssembler& shader, const char* hook, const std::string& chunk)
{
  shader.Before(hook, chunk, MesoShaderText(chunk));
}
}

void MesoShaderBuild::Define(const MesoShaderShape& shape)
{
  this->Chunks = shape.Chunks;
  this->VertexChunks = shape.VertexChunks;
  std::vector<std::pair<std::string, std::string>> defines;
  const auto define = [&](const char* name, bool on)
  {
    if (on)
    {
      defines.emplace_back(name, "");
    }
  };
  define("MESO_SURFACE", this->Surface);
  define("MESO_DICED", this->Diced);
  define("MESO_AOV", this->Numbers && this->Surface);
  define("MESO_CAST_SHADOW", this->TakesShadows);
  define("MESO_CASTER", this->Caster);
  define("MESO_HEIGHT_COLORS", this->HeightColored);
  define("MESO_CLIPPED", this->Clipped);
  define("MESO_DIFFERENTIAL", this->UsesDifferential());
  define("MESO_SCALARS", this->Scalars);
  define("MESO_SCALAR_TEXTURE", this->Scalars && this->ScalarTexture);
  define("MESO_LIT", this->Lit);
  define("MESO_LIGHTING", this->OwnLighting);
  define("MESO_HEADLIGHT", this->LightComplexity == 1);
  define("MESO_SPECULAR", this->Specular);
  define("MESO_TEXTURE_TRANSFORM", this->Textured && this->TextureMoved);
  defines.emplace_back("MESO_LIGHT_COUNT", std::to_string(this->LightCount));
  if (this->Contoured)
  {
    defines.emplace_back("MESO_CONTOUR_HEIGHTS", std::to_string(this->ContourHeights));
  }
  if (this->Surface)
  {
    define("MESO_FRAME", shape.UsesFrame);
    define("MESO_DISPLACED", shape.Displaced);
    define("MESO_PRISMS", shape.Prisms);
  }
  if (this->Surface || this->Diced)
  {
    defines.insert(defines.end(), shape.Defines.begin(), shape.Defines.end());
  }
  if (this->Surface)
  {
    define("MESO_OCCLUSION", this->Caster); // the light sees the detail in any case
  }
  this->Definitions = MesoShaderAssembler::DefineLines(defines);
}

void MesoShaderBuild::SpliceVertexShader(MesoShaderAssembler& vertex) const
{
  const char* const declarations = "//VTK::CustomUniforms::Dec";
  vertex.Before(declarations, "definitions", this->Definitions);
  for (const std::string& chunk : this->VertexChunks)
  {
    Before(vertex, declarations, chunk);
  }
  if (this->Surface)
  {
    Before(vertex, declarations, "Common/VertexDec.glsl");
    Before(vertex, "//VTK::CustomEnd::Impl", "Common/VertexImpl.glsl");
  }
}

void MesoShaderBuild::SpliceGeometryShader(MesoShaderAssembler& geometry) const
{
  // Edges and wide lines bring a geometry shader: without these lines everything that the vertices
  // hand on would be undefined in the fragments, with no error.
  geometry.Before("//VTK::TCoord::Dec", "definitions", this->Definitions);
  Before(geometry, "//VTK::TCoord::Dec", "Common/GeometryDec.glsl");
  Before(geometry, "//VTK::TCoord::Impl", "Common/GeometryImpl.glsl");
}

void MesoShaderBuild::SpliceFragmentShader(MesoShaderAssembler& fragment) const
{
  const char* const declarations = "//VTK::CustomUniforms::Dec";
  fragment.Before(declarations, "definitions", this->Definitions);
  if (this->Diced)
  {
    fragment.Before(declarations, "base's triangle", "flat in int mesoCellVSOutput;\n");
  }
  if (this->Surface)
  {
    Before(fragment, declarations, "Common/Surface.glsl");
    for (const std::string& chunk : this->Chunks)
    {
      Before(fragment, declarations, chunk);
    }
    if (this->UsesDifferential())
    {
      // Derivatives are taken before a miss discards the fragment: undefined after that.
      Before(fragment, declarations, "Common/DifferentialDec.glsl");
      Before(fragment, "//VTK::UniformFlow::Impl", "Common/DifferentialImpl.glsl");
    }
    if (this->Textured)
    {
      Before(fragment, declarations, "Common/TextureDec.glsl");
    }
    if (this->Scalars)
    {
      Before(fragment, declarations, "Common/ScalarDec.glsl");
      Before(fragment, "//VTK::UniformFlow::Impl", "Common/ScalarImpl.glsl");
    }
    if (this->Clipped)
    {
      Before(fragment, declarations, "Common/ClipDec.glsl");
    }
    Before(fragment, "//VTK::UniformFlow::Impl", "Common/TraceImpl.glsl");
  }
  if (this->HeightColored)
  {
    Before(fragment, declarations, "Common/HeightColorDec.glsl");
    fragment.After("//VTK::Color::Impl", "Common/HeightColorImpl.glsl",
      MesoShaderText("Common/HeightColorImpl.glsl"));
  }
  if (this->MatterColored)
  {
    Before(fragment, declarations, "Common/VolumeColorDec.glsl");
    fragment.After("//VTK::Color::Impl", "Common/VolumeColorImpl.glsl",
      MesoShaderText("Common/VolumeColorImpl.glsl"));
  }
  if (this->Contoured)
  {
    Before(fragment, declarations, "Kernels/Contour.glsl");
    Before(fragment, declarations, "Common/ContourDec.glsl");
    fragment.After(
      "//VTK::TCoord::Impl", "Common/ContourImpl.glsl", MesoShaderText("Common/ContourImpl.glsl"));
  }
  if (this->WritesDepth)
  {
    Before(fragment, declarations, "Common/DepthDec.glsl");
    // The hook goes: where depth peeling still finds it, it writes the base mesh's depth.
    fragment.Replace(
      "//VTK::Depth::Impl", "Common/DepthImpl.glsl", MesoShaderText("Common/DepthImpl.glsl"));
  }
  if (this->OwnLighting)
  {
    Before(fragment, declarations, "Common/Lighting.glsl");
  }
  if (this->Traces && this->Lit && !this->Caster)
  {
    fragment.After(
      "//VTK::Normal::Impl", "Common/NormalImpl.glsl", MesoShaderText("Common/NormalImpl.glsl"));
  }
}

void MesoShaderBuild::PlaceVertices(
  MesoShaderAssembler& vertex, MesoShaderAssembler& geometry, MesoShaderAssembler& fragment)
{
  // VTK 9.1 to 9.5, vtkPolyDataVS.glsl and vtkOpenGLPolyDataMapper: attributes, byte by byte.
  const char* const attributes[][3] = { { "in vec4 vertexMC;", "vec4 vertexMC;",
                                          "  vertexMC = mesoVertexMC;\n" },
    { "in vec3 normalMC;", "vec3 normalMC;", "  normalMC = mesoNormal;\n" },
    { "in vec2 tcoord;", "vec2 tcoord;", "  tcoord = coordinateHere();\n" },
    { "in vec4 scalarColor;", "vec4 scalarColor;", "  scalarColor = colorHere();\n" } };
  std::string placing = "  placeVertex(gl_VertexID, gl_InstanceID);\n";
  for (const auto& attribute : attributes)
  {
    if (vertex.Count(attribute[0]) > 0)
    {
      vertex.Rename(attribute[0], attribute[1], 1);
      placing += attribute[2];
    }
  }
  vertex.Before("//VTK::CustomBegin::Impl", "vertex", placing);
  // The number of a triangle among those drawn says nothing here: neither which of its edges are those of
  // a polygon (all are drawn), nor which cell it is of.
  const char* const polygonEdges =
    "255.0*texelFetch(edgeTexture, gl_PrimitiveIDIn + PrimitiveIDOffset).r";
  geometry.Rename(polygonEdges, "7.0", geometry.Count(polygonEdges));
  fragment.Rename("gl_PrimitiveID", "mesoCellVSOutput", fragment.Count("gl_PrimitiveID"));
}

void MesoShaderBuild::ShowDetailToVTKShadows(MesoShaderAssembler& fragment)
{
  // VTK 9.1 to 9.5, vtkShadowMapBakerPass::PreReplaceShaderValues: these two lines, byte by byte.
  fragment.Rename("float ldepth =  gl_FragCoord.z;", "float ldepth = depthOf(mesoHitVC);", 1);
  fragment.Rename("ldepth =  (1.0/gl_FragCoord.w - nearZ)", "ldepth = (-mesoHitVC.z - nearZ)", 1);
}

void MesoShaderBuild::AddLighting(
  MesoShaderAssembler& fragment, const std::string& lightUniforms) const
{
  std::string lights;
  std::string shading;
  for (int i = 0; i < this->LightCount; ++i)
  {
    lights += LightLine(this->LightComplexity, i);
    shading += ShadingLines(this->LightComplexity, i);
  }
  // VTK leaves its hook in place for what comes after lighting.
  Before(fragment, "//VTK::Light::Impl", "Common/LightImpl.glsl");
  fragment.Replace("//MESO::Lights", "lights", lights);
  fragment.Replace("//MESO::Shading", "shading", shading);
  fragment.Replace("//VTK::Light::Dec", "lights' uniforms", lightUniforms);
}

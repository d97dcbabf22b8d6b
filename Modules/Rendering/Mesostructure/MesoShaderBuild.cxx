#include "MesoShaderBuild.h"

#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"

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

void MesoShaderBuild::SpliceVertexShader(MesoShaderAssembler& vertex) const
{
  const char* const declarations = "//VTK::CustomUniforms::Dec";
  vertex.Before(declarations, "definitions", this->Definitions);
  for (const std::string& chunk : this->VertexChunks)
  {
    Before(vertex, declarations, chunk);
  }
  Before(vertex, declarations, "Common/VertexDec.glsl");
  Before(vertex, "//VTK::CustomEnd::Impl", "Common/VertexImpl.glsl");
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
  if (this->Surface)
  {
    Before(fragment, declarations, "Common/Surface.glsl");
    for (const std::string& chunk : this->Chunks)
    {
      Before(fragment, declarations, chunk);
    }
    if (this->Textured)
    {
      // Derivatives are taken before a miss discards the fragment: undefined after that.
      Before(fragment, declarations, "Common/TextureDec.glsl");
      Before(fragment, "//VTK::UniformFlow::Impl", "Common/TextureImpl.glsl");
    }
    Before(fragment, "//VTK::UniformFlow::Impl", "Common/TraceImpl.glsl");
  }
  if (this->HeightColored)
  {
    Before(fragment, declarations, "Common/HeightColorDec.glsl");
    fragment.After("//VTK::Color::Impl", "Common/HeightColorImpl.glsl",
      MesoShaderText("Common/HeightColorImpl.glsl"));
  }
  if (this->WritesDepth)
  {
    Before(fragment, declarations, "Common/DepthDec.glsl");
    Before(fragment, "//VTK::Depth::Impl", "Common/DepthImpl.glsl");
  }
  if (this->OwnLighting)
  {
    Before(fragment, declarations, "Common/Lighting.glsl");
  }
  if (this->Traces && this->Lit)
  {
    fragment.After(
      "//VTK::Normal::Impl", "Common/NormalImpl.glsl", MesoShaderText("Common/NormalImpl.glsl"));
  }
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

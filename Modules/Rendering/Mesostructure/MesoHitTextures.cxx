#include "MesoHitTextures.h"

#include "MesoShaderAssembler.h"
#include "vtkTexture.h"

#include <algorithm>

namespace
{
const char* const ScalarColors = "colortexture"; // VTK's name for a lookup table as a texture
}

bool MesoHasColorTextures(const MesoActorTextures& textures)
{
  return std::any_of(textures.begin(), textures.end(),
    [](const auto& texture) { return texture.second != ScalarColors; });
}

void MesoReadTexturesAtHit(MesoShaderAssembler& fragment, const MesoActorTextures& textures)
{
  for (const auto& texture : textures)
  {
    if (texture.second == ScalarColors || texture.first->GetCubeMap())
    {
      continue; // cubes are environments
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

void MesoReadScalarsAtHit(MesoShaderAssembler& fragment, bool texture)
{
  if (texture)
  {
    fragment.Rename("texture(colortexture, tcoordVCVSOutput.st)",
      "texture(colortexture, scalarPlaceAtHit(tcoordVCVSOutput.st))", 1);
    return;
  }
  fragment.Rename("vertexColorVSOutput.rgb", "scalarAtHit(vertexColorVSOutput).rgb", 2);
  fragment.Rename("vertexColorVSOutput.a", "scalarAtHit(vertexColorVSOutput).a", 1);
}

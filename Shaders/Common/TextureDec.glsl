// Colour textures are read where the ray hit, filtered over what the pixel covers there (mesoMapDx, mesoMapDy
// of Common/DifferentialDec): the differences between the hits of neighbouring pixels jump at every edge of
// the relief and would choose wrong levels there.
//   MESO_TEXTURE_TRANSFORM  the actor carries a texture transform
#ifdef MESO_TEXTURE_TRANSFORM
uniform mat4 tcMatrix; // VTK's
#endif

// A step over the map as one of VTK's texture coordinates.
vec2 textureStep(vec2 mapStep)
{
  vec2 moved = mapStep / mesoTiles;
#ifdef MESO_TEXTURE_TRANSFORM
  moved = (tcMatrix * vec4(moved, 0.0, 0.0)).xy;
#endif
  return moved;
}

// base: the texture coordinate of the fragment, transformed, as VTK hands it on.
vec4 textureAtHit(sampler2D map, vec2 base)
{
  return textureGrad(map, base + textureStep(mesoHit.MapCoord - mesoFragment.MapCoord),
    textureStep(mesoMapDx), textureStep(mesoMapDy));
}

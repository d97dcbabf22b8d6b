// Colour textures are read where the ray hit, with the base's own derivatives: those of the hit jump
// at every edge of the relief and would choose wrong mip levels there.
//   MESO_TEXTURE_TRANSFORM  the actor carries a texture transform
vec2 mesoTextureDx;
vec2 mesoTextureDy;
#ifdef MESO_TEXTURE_TRANSFORM
uniform mat4 tcMatrix; // VTK's
#endif

// base: the texture coordinate of the fragment, transformed, as VTK hands it on.
vec4 textureAtHit(sampler2D map, vec2 base)
{
  vec2 moved = (mesoHit.MapCoord - mesoFragment.MapCoord) / mesoTiles;
#ifdef MESO_TEXTURE_TRANSFORM
  moved = (tcMatrix * vec4(moved, 0.0, 0.0)).xy;
#endif
  return textureGrad(map, base + moved, mesoTextureDx, mesoTextureDy);
}

// Colour textures are read where the ray hit, with the base's own derivatives: those of the hit jump
// at every edge of the relief and would choose wrong mip levels there.
vec2 mesoTextureDx;
vec2 mesoTextureDy;

vec4 textureAtHit(sampler2D map, vec2 tcoord)
{
  return textureGrad(
    map, tcoord + (mesoHit.MapCoord - mesoFragment.MapCoord) / mesoTiles, mesoTextureDx, mesoTextureDy);
}

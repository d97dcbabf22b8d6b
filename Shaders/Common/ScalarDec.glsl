// Scalar colours where the ray hit: the base mesh's number at the fragment goes on as it changes over
// the map in the fragment's own triangle. Exact while the hit lies over that triangle.
//   MESO_SCALARS         these chunks are in the shader
//   MESO_SCALAR_TEXTURE  VTK reads the colour in a texture of the lookup table, else from the vertices
vec4 mesoScalarPerU;
vec4 mesoScalarPerV;

// Takes how an interpolated number changes from pixel to pixel. In uniform flow.
void setScalarSlope(vec4 scalarDx, vec4 scalarDy)
{
  vec2 mapDx = dFdx(mesoTCoordVSOutput) * mesoTiles;
  vec2 mapDy = dFdy(mesoTCoordVSOutput) * mesoTiles;
  float area = mapDx.x * mapDy.y - mapDx.y * mapDy.x;
  mesoScalarPerU = vec4(0.0);
  mesoScalarPerV = vec4(0.0);
  // Seen edge on, or without a chart, the number stays that of the fragment.
  if (abs(area) > 1.0e-4 * length(mapDx) * length(mapDy))
  {
    mesoScalarPerU = (mapDy.y * scalarDx - mapDx.y * scalarDy) / area;
    mesoScalarPerV = (mapDx.x * scalarDy - mapDy.x * scalarDx) / area;
  }
}

vec4 scalarAtHit(vec4 base)
{
  vec2 moved = mesoHit.MapCoord - mesoFragment.MapCoord;
  return clamp(base + moved.x * mesoScalarPerU + moved.y * mesoScalarPerV, 0.0, 1.0);
}

// A place in VTK's texture of a lookup table: the number along it, and whether there is one.
vec2 scalarPlaceAtHit(vec2 base)
{
  return vec2(scalarAtHit(vec4(base.x)).x, base.y);
}

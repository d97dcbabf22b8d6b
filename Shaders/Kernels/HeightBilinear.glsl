// A height map's surface as the truth has it: bilinear between texel centres. One of two: HeightBicubic
// has the same names.
//
// Needs HeightField.glsl

float mapHeight(vec2 uv)
{
  return bilinearHeight(uv);
}

// (dh/du, dh/dv) of the shading normal, and of the surface itself.
vec2 mapGradient(vec2 uv)
{
  return heightGradient(uv);
}

vec2 mapFacet(vec2 uv)
{
  return patchGradient(uv);
}

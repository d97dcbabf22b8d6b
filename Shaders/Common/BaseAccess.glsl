// The only functions that know the image of the base mesh (vtkMesoBaseImage); Kernels/BaseSurface
// stands on these.
uniform sampler2D mesoBasePosition;
uniform sampler2D mesoBaseNormal;
uniform vec2 mesoBaseScale;  // from the mesh's own coordinates to texels
uniform vec2 mesoBaseOffset;
uniform ivec2 mesoBaseWraps;

vec4 fetchBasePosition(ivec2 texel)
{
  return texelFetch(mesoBasePosition, texel, 0);
}

vec3 fetchBaseNormal(ivec2 texel)
{
  return texelFetch(mesoBaseNormal, texel, 0).xyz;
}

ivec2 baseSize()
{
  return textureSize(mesoBasePosition, 0);
}

bvec2 baseWraps()
{
  return bvec2(mesoBaseWraps.x != 0, mesoBaseWraps.y != 0);
}

vec2 baseScale()
{
  return mesoBaseScale / mesoTiles;
}

vec2 baseOffset()
{
  return mesoBaseOffset;
}

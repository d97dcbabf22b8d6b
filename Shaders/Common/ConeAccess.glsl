// The only function that knows the texture of cones; the kernel HeightCone stands on it. The four ways
// of travel lie in the texture's quarters: leftwards in the right half, downwards in the upper.
uniform sampler2D mesoCones;

vec2 fetchCone(ivec2 texel, int travel)
{
  ivec2 quarter = ivec2(travel - travel / 2 * 2, travel / 2) * mapSize();
  return texelFetch(mesoCones, texel + quarter, 0).rg;
}

// A generalized displacement map as a sum of products, d = sum_r W_r(x, y, phi) E_r(theta, z): Wang2004,
// section 4.1. Each factor is linear between its points, so the sum is what the whole table would be.
//
// Needs GDMTable.glsl
//
// Accessors, defined before this file:
//   int gdmGroups()                                          products, in fours
//   vec4 gdmWeights(int group, vec2 tile, float azimuth)     W of four products; tile repeats
//   vec4 gdmFunctions(int group, float polar, float level)   E of them

// Distance in tile widths from a position along a direction to the solid, or to the plane z = 0 or z = 1 that
// the ray leaves through; 0 within the solid.
float gdmDistance(vec3 position, vec3 direction)
{
  GDMPlace place = gdmPlace(position, direction);
  float sum = 0.0;
  for (int group = 0; group < gdmGroups(); ++group)
  {
    sum += dot(gdmWeights(group, place.Tile, place.Azimuth),
      gdmFunctions(group, place.Polar, place.Level));
  }
  return max(sum, 0.0);
}

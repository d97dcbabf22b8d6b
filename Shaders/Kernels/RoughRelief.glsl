// How relief that has been averaged away shades: as a rough surface, whose slopes are distributed normally about
// the mean that is left. What is seen of them, and what light reaches, are Smith1967's; their shading is a mean over
// nine slopes (Dupuy2013), each of which counts by the area that it shows.
//
// Directions are unit and point out, in a frame of the base: x and y over it, z along its normal. A slope m is
// (dz/dx, dz/dy); its variances are those along x and y.

// How much of the surface towards a direction hides behind itself, as a multiple of what does not: Smith1967 for normally
// distributed slopes, by the fit of Walter2007 (equation 35).
float hiddenPerSeen(vec3 direction, vec2 meanSlope, vec2 variance)
{
  float along = dot(direction.xy * direction.xy, variance);
  float above = max(0.0, direction.z - dot(meanSlope, direction.xy));
  if (!(along > 1.0e-12) || above * above > 5.12 * along)
  {
    return 0.0;
  }
  float a = max(0.02, above / sqrt(2.0 * along));
  return max(0.0, 1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a);
}

// The share of what is seen that its own relief leaves in the light. Heights of what is seen and lit are those of one
// surface; directions of one azimuth are hidden by the same of it.
float litShare(vec3 viewOut, vec3 lightOut, vec2 meanSlope, vec2 variance)
{
  float unseen = hiddenPerSeen(viewOut, meanSlope, variance);
  float unlit = hiddenPerSeen(lightOut, meanSlope, variance);
  float apart = (1.0 + unseen) / (1.0 + unseen + unlit);
  float together = min(1.0, (1.0 + unseen) / (1.0 + unlit));
  float size = length(viewOut.xy) * length(lightOut.xy);
  float cosine = size > 0.0 ? dot(viewOut.xy, lightOut.xy) / size : 0.0;
  float same = cosine > 0.0 ? cosine * cosine * cosine * cosine : 0.0;
  return mix(apart, together, same);
}

// The mean of max(0, n . lightOut) over what is seen, n being the unit normals; of the mean slope where nothing is, as
// at rims whose normal looks away.
float meanCosine(vec3 viewOut, vec3 lightOut, vec2 meanSlope, vec2 variance)
{
  vec2 spread = sqrt(3.0 * variance); // Gauss-Hermite: three places, the outer of a quarter of the middle's weight
  float lit = 0.0;
  float seen = 0.0;
  for (int i = -1; i <= 1; ++i)
  {
    for (int j = -1; j <= 1; ++j)
    {
      vec2 slope = meanSlope + spread * vec2(float(i), float(j));
      float weight = (i == 0 ? 4.0 : 1.0) * (j == 0 ? 4.0 : 1.0) *
        max(0.0, viewOut.z - dot(slope, viewOut.xy));
      lit += weight * max(0.0, lightOut.z - dot(slope, lightOut.xy)) / sqrt(1.0 + dot(slope, slope));
      seen += weight;
    }
  }
  float ofMean = max(0.0, lightOut.z - dot(meanSlope, lightOut.xy)) / sqrt(1.0 + dot(meanSlope, meanSlope));
  return seen > 0.0 ? lit / seen : ofMean;
}

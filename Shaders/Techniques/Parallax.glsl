// Parallax mapping: Kaneko2001 (Documentation/Techniques/References.md), in the two forms that games draw.
// The map is read where the view ray meets the relief, about, and the surface stays where it is. Completes
// Techniques/Bump; stands on Common/ReliefFrame.
//   MESO_PARALLAX_STEPS   steps along the ray: of occlusion mapping at a grazing view, a quarter of them
//                         along the normal
//   MESO_PARALLAX_OFFSET  not occlusion mapping, but steps as far as the plane of the slope

const float LeastDescent = 1.0e-5; // depth a tile: flatter rays cannot be told from rays along the plane

#ifdef MESO_PARALLAX_OFFSET

// Each step goes towards where the ray would meet the plane that touches the relief below it. The way is
// shortened by the cosine of the view, which keeps grazing rays from flying off.
float rayDepth(MesoFragment f, vec2 perDepth, float cosine, inout MesoSurfaceHit hit)
{
  float depth = 0.0;
  vec2 at = f.MapCoord;
  vec2 alongU = vec2(1.0 / float(mapSize().x), 0.0);
  vec2 alongV = vec2(0.0, 1.0 / float(mapSize().y));
  for (int i = 0; i < MESO_PARALLAX_STEPS; ++i)
  {
    vec2 slope = 0.5 * vec2(mapSize()) *
      vec2(sampleHeight(at + alongU) - sampleHeight(at - alongU),
        sampleHeight(at + alongV) - sampleHeight(at - alongV));
    float upright = dot(normalOfCross(f, vec3(slope, 1.0)), f.NormalVC);
    depth += (1.0 - sampleHeight(at) - depth) * cosine * upright;
    at = f.MapCoord + depth * perDepth;
    hit.Fetches += 5;
    hit.Iterations += 1;
  }
  return depth;
}

#else

// Equal steps until a sample lies above the ray, then the straight line between the last two samples.
float rayDepth(MesoFragment f, vec2 perDepth, float cosine, inout MesoSurfaceHit hit)
{
  float most = float(MESO_PARALLAX_STEPS);
  float steps = floor(mix(most, 0.25 * most, cosine) + 0.5);
  float before = 1.0 - sampleHeight(f.MapCoord); // depth of the relief below the ray
  hit.Fetches += 1;
  float depth = 0.0;
  if (!(before > 0.0))
  {
    return 0.0;
  }
  for (int i = 1; i <= MESO_PARALLAX_STEPS; ++i)
  {
    float next = float(i) / steps;
    float after = 1.0 - sampleHeight(f.MapCoord + next * perDepth) - next;
    hit.Fetches += 1;
    hit.Iterations += 1;
    if (!(after > 0.0))
    {
      return mix(depth, next, before / (before - after));
    }
    depth = next;
    before = after;
  }
  return 1.0; // a number is not finite
}

#endif

void shiftByParallax(MesoFragment f, inout MesoSurfaceHit hit)
{
  vec3 rate; // of u, v and depth along the view ray
  if (!directionInTS(f, f.ViewVC, rate) ||
    !(rate.z > LeastDescent * (abs(rate.x) + abs(rate.y))))
  {
    return;
  }
  vec2 perDepth = rate.xy / rate.z;
  float cosine = min(abs(dot(f.ViewVC, f.NormalVC)), 1.0);
  int read = hit.Fetches;
  hit.MapCoord = f.MapCoord + rayDepth(f, perDepth, cosine, hit) * perDepth;
  hit.TexelReads += 4 * (hit.Fetches - read);
}

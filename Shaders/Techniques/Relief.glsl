// Relief mapping in the tangent plane: Policarpo2005, as reviewed in
// Oliveira2005, section 2.1 (Documentation/Techniques/References.md).
// Model: around the fragment the base is its tangent plane with constant dp/du, dp/dv and n, so the
// view ray is straight in (u, v, depth). Stands on Kernels/Frame, HeightField, LinearBinarySearch.
//   MESO_LINEAR_STEPS, MESO_BINARY_STEPS  the search's steps

// A ray that runs further than this many tiles before it is one unit deep grazes the surface so
// flatly that a float no longer tells neighbouring texels apart: the base itself is drawn.
const float MESO_MAX_TILES = 1.0e5;

// Normal of q = p + (h - 1) D n for dh/du, dh/dv = gradient, with dp/du, dp/dv, n held constant:
// q_u x q_v with q_u = p_u + h_u D n, divided by the base's own area so that a mirrored chart, where
// p_u x p_v points against n, comes out right and a flat map gives n itself.
vec3 reliefNormal(MesoFragment f, vec2 gradient)
{
  vec3 outward = -f.PerDepth;
  vec3 tilt = gradient.x * cross(outward, f.PerMapV) + gradient.y * cross(f.PerMapU, outward);
  float area = dot(cross(f.PerMapU, f.PerMapV), f.NormalVC);
  if (!(abs(area) > 0.0) || tilt == vec3(0.0))
  {
    return f.NormalVC;
  }
  return normalize(f.NormalVC + tilt / area);
}

// From behind the base itself is drawn: its normal has been turned to the eye, PerDepth has not.
bool seenFromBehind(MesoFragment f)
{
  return dot(f.PerDepth, f.NormalVC) > 0.0;
}

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  if (seenFromBehind(f))
  {
    return hit;
  }
#ifdef MESO_OCCLUSION
  vec3 rate; // of u, v and depth along the view ray
  if (!solveFrame(f.PerMapU, f.PerMapV, f.PerDepth, f.ViewVC, rate) ||
    !(rate.z * MESO_MAX_TILES > abs(rate.x) + abs(rate.y)))
  {
    return hit;
  }
  HeightHit found =
    searchLinearBinary(f.MapCoord, rate.xy / rate.z, 0.0, MESO_LINEAR_STEPS, MESO_BINARY_STEPS);
  if (!found.Hit)
  {
    return hit; // a number that is not finite
  }
  hit.RayLength = found.RayDepth / rate.z;
  hit.MapCoord = found.MapCoord;
  hit.Relief = found.Relief;
  hit.Fetches = found.Fetches;
  hit.Iterations = found.Iterations;
#else
  hit.Relief = 1.0 - bilinearHeight(f.MapCoord);
  hit.Fetches = 1;
#endif
  hit.TexelReads = 4 * hit.Fetches;
#ifdef MESO_SHADING
  hit.NormalVC = reliefNormal(f, heightGradient(hit.MapCoord));
  hit.Fetches += 1;
  hit.TexelReads += 12;
#endif
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV)
  hit.FacetNormalVC = reliefNormal(f, patchGradient(hit.MapCoord));
#endif
#ifdef MESO_SELF_SHADOW
  hit.Fetches += 1; // the facet's; AOVs alone do not count as cost
  hit.TexelReads += 4;
#endif
  return hit;
}

// The shadow ray starts 1e-3 texel off the surface along the facet's normal.
float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
  if (!(dot(hit.FacetNormalVC, lightOutVC) > 0.0))
  {
    return 1.0;
  }
  if (seenFromBehind(f))
  {
    return 0.0;
  }
#ifdef MESO_SELF_SHADOW
  vec3 rate;
  vec3 lift;
  vec2 texel = vec2(length(f.PerMapU), length(f.PerMapV)) / vec2(mapSize());
  vec3 offset = 1.0e-3 * min(texel.x, texel.y) * hit.FacetNormalVC;
  if (!solveFrame(f.PerMapU, f.PerMapV, f.PerDepth, lightOutVC, rate) ||
    !solveFrame(f.PerMapU, f.PerMapV, f.PerDepth, offset, lift))
  {
    return 0.0; // no relief here: the base's own normal has decided
  }
  float depthStart = hit.Relief + lift.z;
  if (!(depthStart > 0.0))
  {
    return 0.0;
  }
  if (!(-rate.z * MESO_MAX_TILES > abs(rate.x) + abs(rate.y)))
  {
    return 1.0; // the light does not rise out of the tangent plane
  }
  float depthEnd = max(0.0, hit.Relief + rate.z * lightDistance); // the light may be inside
  return occludedLinear(hit.MapCoord + lift.xy, rate.xy / -rate.z, depthStart, depthEnd,
    MESO_LINEAR_STEPS, fetches);
#else
  return 0.0;
#endif
}

// Relief mapping in the tangent plane: Policarpo2005, as reviewed in
// Oliveira2005, section 2.1 (Documentation/Techniques/References.md).
// Model: around the fragment the base is its tangent plane with constant dp/du, dp/dv and n, so the
// view ray is straight in (u, v, depth). Stands on Common/ReliefSurface and Kernels/HeightField,
// LinearBinarySearch.
//   MESO_LINEAR_STEPS, MESO_BINARY_STEPS  the search's steps

// Normal of q = p + (h - 1) D n for dh/du, dh/dv = gradient, with dp/du, dp/dv, n held constant:
// q_u x q_v with q_u = p_u + h_u D n.
vec3 reliefNormal(MesoFragment f, vec2 gradient)
{
  return normalOfCross(f, vec3(gradient, 1.0));
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
  if (!directionInTS(f, f.ViewVC, rate) || !(rate.z * MESO_MAX_TILES > abs(rate.x) + abs(rate.y)))
  {
    return hit;
  }
  HeightHit found = searchLinearBinary(
    straightPath(f.MapCoord, rate.xy / rate.z, 0.0, 1.0), MESO_LINEAR_STEPS, MESO_BINARY_STEPS);
  if (!found.Hit)
  {
    return hit; // a number that is not finite
  }
  hit.RayLength = found.RayDepth / rate.z;
  takeSearch(found, hit);
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
  if (!directionInTS(f, lightOutVC, rate) || !shadowOffset(f, hit, lift))
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
  // The light may be inside the relief.
  float depthEnd = min(depthStart, max(0.0, hit.Relief + rate.z * lightDistance));
  return occludedLinear(straightPath(hit.MapCoord + lift.xy, rate.xy / rate.z, depthStart, depthEnd),
    MESO_LINEAR_STEPS, fetches);
#else
  return 0.0;
#endif
}

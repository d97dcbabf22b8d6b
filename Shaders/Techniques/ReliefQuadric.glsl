// Relief mapping with outlines: the height field bent over a quadric, Oliveira2005, sections 3.2 to
// 3.5 (Documentation/Techniques/References.md).
// Model: around the fragment the base is the quadric z(u, v) below its tangent plane, and depth is
// counted from it along the fragment's normal (equation 7). A straight ray of rates (u, v, z)' is
// then z' t - quadric(u', v') t^2 deep: it either meets the bottom or comes back to depth 0 and
// misses. Stands on Common/ReliefSurface and Kernels/Quadric, HeightField, LinearBinarySearch.
//   MESO_LINEAR_STEPS, MESO_BINARY_STEPS  the search's steps
//   MESO_CURVATURE   the quadric of the vertices is used; without it, it is the tangent plane
//   MESO_SILHOUETTE  rays that come back are not drawn; without it, they draw the base

// Normal of the relief at a hit, over the quadric's own frame there.
vec3 reliefNormal(MesoFragment f, vec2 mapCoord, float relief, vec2 gradient)
{
  return normalOfCross(
    f, displacedCross(f.Quadric, f.Metric, mapCoord - f.MapCoord, relief, gradient));
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
  if (!directionInTS(f, f.ViewVC, rate))
  {
    return hit;
  }
  float bend = quadricDepth(f.Quadric, rate.xy);
  float depthEnd;
  float lengthEnd = leaveShell(0.0, rate.z, bend, depthEnd);
  HeightPath path = bentPath(f.MapCoord, rate.xy, 0.0, depthEnd, bend, lengthEnd);
  if (!(abs(path.MapSpan.x) + abs(path.MapSpan.y) < MESO_MAX_TILES))
  {
    return hit;
  }
  // A ray that leaves at once can only meet what lies at depth 0.
  HeightHit found =
    searchLinearBinary(path, lengthEnd > 0.0 ? MESO_LINEAR_STEPS : 1, MESO_BINARY_STEPS);
  if (!found.Hit)
  {
#ifdef MESO_SILHOUETTE
    hit.Found = depthEnd > 0.0; // only a number that is not finite misses the bottom
#endif
    return hit;
  }
  hit.RayLength = found.Part * lengthEnd;
  takeSearch(found, hit);
#else
  hit.Relief = 1.0 - bilinearHeight(f.MapCoord);
  hit.Fetches = 1;
#endif
  hit.TexelReads = 4 * hit.Fetches;
#ifdef MESO_SHADING
  hit.NormalVC = reliefNormal(f, hit.MapCoord, hit.Relief, heightGradient(hit.MapCoord));
  hit.Fetches += 1;
  hit.TexelReads += 12;
#endif
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV)
  hit.FacetNormalVC = reliefNormal(f, hit.MapCoord, hit.Relief, patchGradient(hit.MapCoord));
#endif
#ifdef MESO_SELF_SHADOW
  hit.Fetches += 1; // the facet's; AOVs alone do not count as cost
  hit.TexelReads += 4;
#endif
  return hit;
}

// The light's ray runs through the same bent shell as the view ray's, from the hit until it comes
// up to depth 0, goes down to the bottom, which blocks it, or reaches the light.
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
  vec2 gradient = quadricGradient(f.Quadric, hit.MapCoord - f.MapCoord);
  float depthStart = hit.Relief + lift.z - dot(gradient, lift.xy);
  if (!(depthStart > 0.0))
  {
    return 0.0;
  }
  float slope = rate.z - dot(gradient, rate.xy);
  float bend = quadricDepth(f.Quadric, rate.xy);
  float depthEnd;
  float lengthEnd = leaveShell(depthStart, slope, bend, depthEnd);
  if (lightDistance < lengthEnd)
  {
    lengthEnd = lightDistance;
    depthEnd = depthStart + lengthEnd * (slope - lengthEnd * bend);
  }
  else if (depthEnd > 0.0)
  {
    return 1.0;
  }
  HeightPath path = bentPath(hit.MapCoord + lift.xy, rate.xy, depthStart, depthEnd, bend, lengthEnd);
  if (!(abs(path.MapSpan.x) + abs(path.MapSpan.y) < MESO_MAX_TILES))
  {
    return 1.0; // the light hardly rises out of the surface
  }
  return occludedLinear(path, MESO_LINEAR_STEPS, fetches);
#else
  return 0.0;
#endif
}

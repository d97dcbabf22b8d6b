// Relief mapping with outlines: the height field bent over a quadric, Oliveira2005, sections 3.2 to
// 3.5 (Documentation/Techniques/References.md).
// Model: around the fragment the base is the quadric z(u, v) below its tangent plane, and depth is
// counted from it along the fragment's normal (equation 7). A straight ray of rates (u, v, z)' is
// then z' t - quadric(u', v') t^2 deep: it either meets the bottom or comes back to depth 0 and
// misses. Stands on Kernels/Quadric. Completes Common/ReliefSurface.
//   MESO_CURVATURE   the quadric of the vertices is used; without it, it is the tangent plane
//   MESO_SILHOUETTE  rays that come back are not drawn; without it, they draw the base

// A path so long that a float no longer tells neighbouring texels apart is not followed.
bool canBeFollowed(HeightPath path)
{
  return abs(path.MapSpan.x) + abs(path.MapSpan.y) < MESO_MAX_TILES;
}

bool followRay(MesoFragment f, inout MesoSurfaceHit hit)
{
  vec3 rate; // of u, v and depth along the view ray
  if (!directionInTS(f, f.ViewVC, rate))
  {
    return false;
  }
  float bend = quadricDepth(f.Quadric, rate.xy);
  float depthEnd;
  float lengthEnd = leaveShell(0.0, rate.z, bend, depthEnd);
  HeightPath path = bentPath(f.MapCoord, rate.xy, 0.0, depthEnd, bend, lengthEnd);
  if (!canBeFollowed(path))
  {
    return false;
  }
  HeightHit found = searchKept(f, path, lengthEnd);
  if (found.Hit)
  {
    hit.RayLength = found.Part * lengthEnd;
    takeSearch(found, hit);
  }
#ifdef MESO_SILHOUETTE
  else
  {
    hit.Found = depthEnd > 0.0; // only a number that is not finite misses the bottom
  }
#endif
  return found.Hit;
}

// Over the quadric's own frame at the hit.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  return normalOfCross(f,
    displacedCross(f.Quadric, f.Metric, hit.MapCoord - f.MapCoord, hit.Relief, gradient));
}

// The light's ray runs through the same bent shell as the view ray's, from the hit until it comes
// up to depth 0, goes down to the bottom, which blocks it, or reaches the light.
float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches)
{
  fetches = 0;
  vec2 gradient = quadricGradient(f.Quadric, hit.MapCoord - f.MapCoord);
  float depthStart = hit.Relief + lift.z - dot(gradient, lift.xy);
  if (!(depthStart > 0.0))
  {
    return 0.0;
  }
  float slope = travel.z - dot(gradient, travel.xy);
  float bend = quadricDepth(f.Quadric, travel.xy);
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
  HeightPath path =
    bentPath(hit.MapCoord + lift.xy, travel.xy, depthStart, depthEnd, bend, lengthEnd);
  // Too long a path: the light hardly rises out of the surface.
  return canBeFollowed(path) ? reliefOccludes(path, fetches) : 1.0;
}

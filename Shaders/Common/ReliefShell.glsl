// What techniques share whose rays have a way through the bent shell in closed form. Completes
// Common/ReliefSurface but for reliefNormal, and declares what the technique itself defines.
//   MESO_CURVATURE   the quadric of the vertices is used; without it, it is the tangent plane
//   MESO_SILHOUETTE  rays that come back are not drawn; without it, they draw the base

// The view ray's way, whose direction is `rate` in texture space, until it comes back to depth 0 or
// gets to the bottom at depth 1.
HeightPath viewWay(MesoFragment f, vec3 rate, out float lengthEnd);
// A light's ray's from a hit on, until it does so or reaches the light.
HeightPath lightWay(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out float lengthEnd);

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
  float lengthEnd;
  HeightPath path = viewWay(f, rate, lengthEnd);
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
    hit.Found = path.DepthEnd > 0.0; // only a number that is not finite misses the bottom
  }
#endif
  return found.Hit;
}

// The light's ray runs through the same bent shell as the view ray's, from the hit until it comes
// up to depth 0, goes down to the bottom, which blocks it, or reaches the light.
float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches)
{
  fetches = 0;
  float lengthEnd;
  HeightPath path = lightWay(f, hit, travel, lift, lightDistance, lengthEnd);
  if (!(path.DepthStart > 0.0))
  {
    return 0.0;
  }
  if (path.DepthEnd >= 1.0)
  {
    return 1.0;
  }
  // Too long a path: the light hardly rises out of the surface.
  return canBeFollowed(path) ? reliefOccludes(path, fetches) : 1.0;
}

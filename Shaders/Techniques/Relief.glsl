// Relief mapping in the tangent plane: Policarpo2005, as reviewed in
// Oliveira2005, section 2.1 (Documentation/Techniques/References.md).
// Model: around the fragment the base is its tangent plane with constant dp/du, dp/dv and n, so the
// view ray is straight in (u, v, depth). Completes Common/ReliefSurface.

bool followRay(MesoFragment f, inout MesoSurfaceHit hit)
{
  vec3 rate; // of u, v and depth along the view ray
  if (!directionInTS(f, f.ViewVC, rate) || !(rate.z * MESO_MAX_TILES > abs(rate.x) + abs(rate.y)))
  {
    return false;
  }
  HeightHit found =
    searchKept(f, straightPath(f.MapCoord, rate.xy / rate.z, 0.0, 1.0), 1.0 / rate.z);
  if (found.Hit) // else a number is not finite
  {
    hit.RayLength = found.RayDepth / rate.z;
    takeSearch(found, hit);
  }
  return found.Hit;
}

// Of q = p + (h - 1) D n with dp/du, dp/dv, n held constant: q_u x q_v with q_u = p_u + h_u D n.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  return normalOfCross(f, vec3(gradient, 1.0));
}

float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches)
{
  fetches = 0;
  float depthStart = hit.Relief + lift.z;
  if (!(depthStart > 0.0))
  {
    return 0.0;
  }
  if (!(-travel.z * MESO_MAX_TILES > abs(travel.x) + abs(travel.y)))
  {
    return 1.0; // the light does not rise out of the tangent plane
  }
  // The light may be inside the relief.
  float depthEnd = min(depthStart, max(0.0, hit.Relief + travel.z * lightDistance));
  return reliefOccludes(
    straightPath(hit.MapCoord + lift.xy, travel.xy / travel.z, depthStart, depthEnd), fetches);
}

// Relief mapping with outlines: the height field bent over a quadric, Oliveira2005, sections 3.2 to
// 3.5 (Documentation/Techniques/References.md).
// Model: around the fragment the base is the quadric z(u, v) below its tangent plane, and depth is
// counted from it along the fragment's normal (equation 7). A straight ray of rates (u, v, z)' is
// then z' t - quadric(u', v') t^2 deep: it either meets the bottom or comes back to depth 0 and
// misses. Stands on Kernels/Quadric. Completes Common/ReliefShell.

HeightPath viewWay(MesoFragment f, vec3 rate, out float lengthEnd)
{
  float bend = quadricDepth(f.Quadric, rate.xy);
  float depthEnd;
  lengthEnd = leaveShell(0.0, rate.z, bend, depthEnd);
  return bentPath(f.MapCoord, rate.xy, 0.0, depthEnd, bend, lengthEnd);
}

HeightPath lightWay(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out float lengthEnd)
{
  vec2 gradient = quadricGradient(f.Quadric, hit.MapCoord - f.MapCoord);
  float depthStart = hit.Relief + lift.z - dot(gradient, lift.xy);
  float slope = travel.z - dot(gradient, travel.xy);
  float bend = quadricDepth(f.Quadric, travel.xy);
  float depthEnd;
  lengthEnd = leaveShell(depthStart, slope, bend, depthEnd);
  if (lightDistance < lengthEnd)
  {
    lengthEnd = lightDistance;
    depthEnd = depthStart + lengthEnd * (slope - lengthEnd * bend);
  }
  return bentPath(hit.MapCoord + lift.xy, travel.xy, depthStart, depthEnd, bend, lengthEnd);
}

// Over the quadric's own frame at the hit.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  return normalOfCross(f,
    displacedCross(f.Quadric, f.Metric, hit.MapCoord - f.MapCoord, hit.Relief, gradient));
}

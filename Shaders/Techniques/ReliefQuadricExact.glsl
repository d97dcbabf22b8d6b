// Relief mapping with outlines as Oliveira2005, section 3.1, prints it
// (Documentation/Techniques/References.md).
// Model: around the fragment the base is the quadric z(u, v) below its tangent plane, and a point's depth
// is its distance to the quadric at right angles to the view ray, in the plane of ray and normal
// (equation 6); where that line passes the quadric, or the ray runs along the normal, its depth along the
// normal (equation 7). The light's ray runs through the same depths: they are those of the surface that
// is seen. Stands on Kernels/QuadricExact and AcrossPath. Completes Common/ReliefShell.

// The report's U, of length D, in texture space; 0 where there is none.
vec3 acrossInTS(MesoFragment f)
{
  vec3 normal = normalize(mesoNormalMCVSOutput);
  vec3 view = normalize(inverse(mesoModelToView) * f.ViewVC);
  vec3 across;
  bool sound = directionInTS(f, mesoModelToView * (mesoScale * acrossView(normal, view)), across);
  return sound ? across : vec3(0.0);
}

HeightPath viewWay(MesoFragment f, vec3 rate, out float lengthEnd)
{
  return acrossPath(
    f.Quadric, acrossInTS(f), f.MapCoord, vec3(0.0), rate, QuadricNever, lengthEnd);
}

HeightPath lightWay(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out float lengthEnd)
{
  vec3 rate;
  directionInTS(f, f.ViewVC, rate); // it was sound where there is a hit
  return acrossPath(f.Quadric, acrossInTS(f), hit.MapCoord + lift.xy, hit.RayLength * rate + lift,
    travel, lightDistance, lengthEnd);
}

// Over the quadric's own frame at the hit.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  return normalOfCross(f,
    displacedCross(f.Quadric, f.Metric, hit.MapCoord - f.MapCoord, hit.Relief, gradient));
}

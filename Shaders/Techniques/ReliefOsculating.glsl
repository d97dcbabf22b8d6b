// Relief mapping over the circle that osculates the base along the view ray.
// Model: in the plane of the ray and the fragment's normal the base is the circle of the base's normal
// curvature along the ray, and depth is counted along the circle's own normals; the map moves along its
// arc. Spheres and cylinders are exact, along any ray that stays in such a plane. Stands on
// Kernels/Quadric and CirclePath. Completes Common/ReliefShell.

// Squared length over the metric, in units of D.
float squaredLength(vec3 metric, vec2 step2)
{
  return metric.x * step2.x * step2.x + 2.0 * metric.y * step2.x * step2.y +
    metric.z * step2.y * step2.y;
}

// The way of a ray from a step over the quadric, where it is depthStart deep.
HeightPath wayOverCircle(MesoFragment f, vec2 moved, vec2 mapStart, float depthStart, vec3 travel,
  float longest, out float lengthEnd)
{
  float root;
  vec3 normal = quadricNormal(f.Quadric, f.Metric, moved, root);
  float down = (travel.z - dot(quadricGradient(f.Quadric, moved), travel.xy)) / root;
  vec2 overMap = travel.xy + down * normal.xy; // the part at right angles to the normal
  float squared =
    max(squaredLength(f.Metric, travel.xy) + travel.z * travel.z - down * down, 0.0);
  float curvature = squared > 0.0 ? 2.0 * quadricDepth(f.Quadric, overMap) / (root * squared) : 0.0;
  return circlePath(
    curvature, mapStart, depthStart, overMap, sqrt(squared), down, longest, lengthEnd);
}

HeightPath viewWay(MesoFragment f, vec3 rate, out float lengthEnd)
{
  return wayOverCircle(f, vec2(0.0), f.MapCoord, 0.0, rate, QuadricNever, lengthEnd);
}

HeightPath lightWay(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out float lengthEnd)
{
  vec2 moved = hit.MapCoord - f.MapCoord;
  float root;
  quadricNormal(f.Quadric, f.Metric, moved, root);
  float rise = (lift.z - dot(quadricGradient(f.Quadric, moved), lift.xy)) / root;
  return wayOverCircle(f, moved, hit.MapCoord + lift.xy, hit.Relief + rise, travel, lightDistance,
    lengthEnd);
}

// Over the quadric's frame, after the step whose normal has turned as far as the circle's after its
// arc: by the arc's angle, and the quadric's by the angle whose tangent is the step's.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  const float steepest = 1.4; // radians
  vec2 moved = hit.MapCoord - f.MapCoord;
  float arc = sqrt(max(squaredLength(f.Metric, moved), 0.0));
  float angle = arc > 0.0 ? min(abs(2.0 * quadricDepth(f.Quadric, moved)) / arc, steepest) : 0.0;
  float longer = angle > 1.0e-3 ? tan(angle) / angle : 1.0;
  return normalOfCross(
    f, displacedCross(f.Quadric, f.Metric, longer * moved, hit.Relief, gradient));
}

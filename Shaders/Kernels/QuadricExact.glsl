// Depth below a quadric, measured across the view ray: Oliveira2005, section 3.1, equations 3 to 7.
//
// Needs Quadric.glsl
//
// Points and directions are in texture space, as in Quadric.glsl. `across` is the report's U: in
// object space the unit vector at right angles to the view ray, in the plane of ray and normal, on
// the normal's side (acrossView); times D and written in texture space, so that distances along it
// count in D and across.z < 0. 0 where the ray runs along the normal, which has no such vector.
// Equations 5 and 6 hold in any affine coordinates, so nothing else is needed of object space.
//
// Numbers up to QuadricNever are taken, whose squares are numbers too.

// Sine of the angle between ray and normal below which the plane that they span is lost in a float's
// rounding: there is no `across`.
const float QuadricLeastSine = 1.0e-5;

// U: the unit vector at right angles to `view`, in the plane of `view` and `normal` (both of length
// 1, one space), with U . normal > 0; 0 where they are parallel. Two cross products: normal - (normal
// . view) view is not at right angles to a ray that runs along the normal but for a thousandth.
vec3 acrossView(vec3 normal, vec3 view)
{
  vec3 axis = cross(normal, view);
  float size = length(axis);
  return size > QuadricLeastSine ? cross(view, axis / size) : vec3(0.0);
}

// The distance s from a point to the quadric along `across`, the one that is nearest above it
// (equation 6); where there is none, the depth along the normal (equation 7):
// - the discriminant is negative: the line along `across` passes the quadric;
// - A is 0 or less and B not above 0: the line meets it behind the point only (the report's formula
//   then returns a negative distance, as if the point lay outside).
// Above the quadric the result is 0 or less. The root is not the report's (-B + sqrt(B^2 - 4 A C)) /
// 2 A but the same over its conjugate, which keeps its digits for A -> 0 and is right for A = 0.
float distanceAcross(vec3 quadric, vec3 across, vec3 point)
{
  float below = distanceToQuadric(quadric, point); // -C
  float curve = quadricDepth(quadric, across.xy);  // A
  float slope = dot(quadricGradient(quadric, point.xy), across.xy) - across.z; // B
  float discriminant = slope * slope + 4.0 * curve * below;
  if (!(discriminant >= 0.0))
  {
    return below;
  }
  float root = sqrt(discriminant);
  float result = below;
  if (slope > 0.0)
  {
    result = 2.0 * below / (slope + root);
  }
  else if (curve > 0.0 && below > 0.0)
  {
    result = (root - slope) / (2.0 * curve);
  }
  return clamp(result, -QuadricNever, QuadricNever);
}

// The times above 0 at which constant + linear t + square t^2 is 0, QuadricNever for each that does
// not exist.
vec2 quadraticTimes(float constant, float linear, float square)
{
  vec2 times = vec2(QuadricNever);
  float discriminant = linear * linear - 4.0 * square * constant;
  if (discriminant >= 0.0)
  {
    float root = sqrt(discriminant);
    float sum = -0.5 * (linear < 0.0 ? linear - root : linear + root);
    float first = square != 0.0 ? sum / square : QuadricNever;
    float second = sum != 0.0 ? constant / sum : QuadricNever;
    times.x = first > 0.0 && first < QuadricNever ? first : QuadricNever;
    times.y = second > 0.0 && second < QuadricNever ? second : QuadricNever;
  }
  return times;
}

// The times above 0 at which a ray from a point meets the quadric.
vec2 quadricTimes(vec3 quadric, vec3 start, vec3 direction)
{
  return quadraticTimes(-distanceToQuadric(quadric, start),
    dot(quadricGradient(quadric, start.xy), direction.xy) - direction.z,
    quadricDepth(quadric, direction.xy));
}

// The lesser of two times that lies after a third.
float earlierTime(float time, float other, float after)
{
  return other > after ? min(time, other) : time;
}

// t_max of section 3.3 for the distance across the ray: the first time at which it leaves [0, 1], and
// the depth there, 0 or 1. QuadricNever where it stays inside for good. The distance is 0 where the
// ray meets the quadric, 1 where the ray moved by `across` does (or, for equation 7, the ray moved
// down by 1), and jumps where the discriminant changes sign: between two such times it does not
// cross 0 or 1, so one probe tells on which side it is.
float leaveAcross(vec3 quadric, vec3 across, vec3 start, vec3 direction, out float depthEnd)
{
  vec2 tops = quadricTimes(quadric, start, direction);
  vec2 bottoms = quadricTimes(quadric, start + across, direction);
  vec2 floors = quadricTimes(quadric, start - vec3(0.0, 0.0, 1.0), direction);
  float curve = quadricDepth(quadric, across.xy);
  float slope = dot(quadricGradient(quadric, start.xy), across.xy) - across.z;
  float slopeRate = dot(quadricGradient(quadric, direction.xy), across.xy);
  float sinkRate = direction.z - dot(quadricGradient(quadric, start.xy), direction.xy);
  vec2 jumps = quadraticTimes(
    slope * slope + 4.0 * curve * distanceToQuadric(quadric, start),
    2.0 * slope * slopeRate + 4.0 * curve * sinkRate,
    slopeRate * slopeRate - 4.0 * curve * quadricDepth(quadric, direction.xy));

  float time = 0.0;
  bool inside = true;
  depthEnd = 1.0;
  for (int i = 0; i < 9 && inside; ++i) // eight times, and what lies beyond the last
  {
    float next = QuadricNever;
    next = earlierTime(earlierTime(next, tops.x, time), tops.y, time);
    next = earlierTime(earlierTime(next, bottoms.x, time), bottoms.y, time);
    next = earlierTime(earlierTime(next, floors.x, time), floors.y, time);
    next = earlierTime(earlierTime(next, jumps.x, time), jumps.y, time);
    float probe = next < QuadricNever ? 0.5 * (time + next) : 2.0 * time + 1.0;
    float depth = distanceAcross(quadric, across, start + probe * direction);
    inside = depth > 0.0 && depth < 1.0;
    if (inside)
    {
      time = next;
    }
    else
    {
      depthEnd = depth > 0.0 ? 1.0 : 0.0;
    }
    inside = inside && time < QuadricNever;
  }
  return time;
}

// A base surface that bends: relief over a quadric (Oliveira2005, section 3).
//
// In the tangent plane of a point the base lies z = a x^2 + b y^2 + c x y below the plane, x and y
// in object units along the axes of vtkMesoQuadricFit, a > 0 where it is convex along x. In texture
// space, where a vector is (map step u, map step v, depth / D), the same surface is (equation 8)
//
//   z = quadric.x u^2 + quadric.y v^2 + quadric.z u v,
//
// and lengths along it are those of the metric, the first fundamental form over D^2:
//
//   |(u, v)|^2 = metric.x u^2 + 2 metric.y u v + metric.z v^2, in units of D.
//
// Equation 8 as printed leaves out b and holds only where dp/du and dp/dv are at right angles;
// these functions take any chart, sheared and mirrored ones as well.

// A metric whose angle between dp/du and dp/dv has a smaller squared sine spans no plane.
const float QuadricLeastArea = 1.0e-8;

// A time that is never reached. Its square is a number too.
const float QuadricNever = 1.0e18;

// (a, b, c) of an object's tangent plane -> the quadric over texture coordinates, in object units
// of depth. tangent, bitangent, normal: unit, object space; scale: |dp/du|, |dp/dv|.
vec3 quadricOverTexture(vec3 abc, vec3 tangent, vec3 bitangent, vec3 normal, vec2 scale)
{
  vec3 x = tangent - dot(tangent, normal) * normal;
  float lengthX = length(x);
  if (!(lengthX > 0.0))
  {
    return vec3(0.0);
  }
  x = x / lengthX;
  float alongX = dot(bitangent, x);
  float alongY = dot(bitangent, cross(normal, x));
  vec3 result;
  result.x = abc.x * scale.x * scale.x;
  result.y =
    (abc.x * alongX * alongX + abc.y * alongY * alongY + abc.z * alongX * alongY) * scale.y * scale.y;
  result.z = (2.0 * abc.x * alongX + abc.z * alongY) * scale.x * scale.y;
  return result;
}

// How far the quadric lies below the tangent plane after a step over the map. For a direction: half
// its second derivative.
float quadricDepth(vec3 quadric, vec2 step2)
{
  return quadric.x * step2.x * step2.x + quadric.y * step2.y * step2.y +
    quadric.z * step2.x * step2.y;
}

// Its derivatives along u and v.
vec2 quadricGradient(vec3 quadric, vec2 step2)
{
  return vec2(2.0 * quadric.x * step2.x + quadric.z * step2.y,
    2.0 * quadric.y * step2.y + quadric.z * step2.x);
}

// Equation 7: the depth below the quadric of a point of texture space, along the point's own
// normal. Of a ray it is the quadratic of leaveShell.
float distanceToQuadric(vec3 quadric, vec3 point)
{
  return point.z - quadricDepth(quadric, point.xy);
}

// t_max of section 3.3: the first t > 0 at which depth + slope t - bend t^2 leaves [0, 1], and the
// depth there, 0 (back at the surface: the outline) or 1 (at the bottom, which stops every ray).
// depth in [0, 1]; at depth 0 a slope that is not positive leaves at once, at depth 1 one that is
// not negative. QuadricNever where it stays inside for good. No root is a difference of near equals:
// each is the sum of two terms of one sign, or over one.
float leaveShell(float depth, float slope, float bend, out float depthEnd)
{
  float toTop = QuadricNever;
  float toBottom = QuadricNever;
  float above = depth;
  float below = 1.0 - depth;
  float ofTop = slope * slope + 4.0 * bend * above;    // discriminants
  float ofBottom = slope * slope - 4.0 * bend * below;
  if (slope > 0.0)
  {
    if (bend > 0.0)
    {
      toTop = (slope + sqrt(max(ofTop, 0.0))) / (2.0 * bend);
    }
    if (ofBottom >= 0.0)
    {
      toBottom = 2.0 * below / (slope + sqrt(ofBottom));
    }
  }
  else
  {
    if (above <= 0.0)
    {
      toTop = 0.0;
    }
    else if (bend > 0.0 || (slope < 0.0 && ofTop >= 0.0))
    {
      toTop = 2.0 * above / (sqrt(max(ofTop, 0.0)) - slope);
    }
    if (below <= 0.0 && slope == 0.0 && bend <= 0.0)
    {
      toBottom = 0.0;
    }
    else if (bend < 0.0)
    {
      toBottom = (sqrt(ofBottom) - slope) / (-2.0 * bend);
    }
  }
  depthEnd = toTop < toBottom ? 0.0 : 1.0;
  return min(min(toTop, toBottom), QuadricNever);
}

// The outward unit normal of the quadric after a step, in texture space, of length D: the surface
// (u, v, z(u, v)) has the tangents (1, 0, z_u) and (0, 1, z_v). lateral: what the metric makes of
// the gradient; root: sqrt(1 + |gradient|^2).
vec3 quadricNormal(vec3 quadric, vec3 metric, vec2 step2, out float root)
{
  vec2 gradient = quadricGradient(quadric, step2);
  float area = metric.x * metric.z - metric.y * metric.y;
  vec2 lateral = vec2(0.0);
  if (area > QuadricLeastArea * metric.x * metric.z)
  {
    lateral.x = (metric.z * gradient.x - metric.y * gradient.y) / area;
    lateral.y = (metric.x * gradient.y - metric.y * gradient.x) / area;
  }
  root = sqrt(1.0 + dot(gradient, lateral));
  return vec3(lateral / root, -1.0 / root);
}

// Derivative of quadricNormal along a direction over the map: the quadric's second derivatives bend
// the normal (Weingarten), the part along the normal taken off so that it stays of length D.
vec3 quadricNormalDerivative(vec3 quadric, vec3 metric, vec2 step2, vec2 direction)
{
  float root;
  vec3 normal = quadricNormal(quadric, metric, step2, root);
  float rate;
  vec3 bend = quadricNormal(quadric, metric, direction, rate);
  // lateral is linear in the step: what it is for the direction is its derivative.
  vec2 lateral = bend.xy * rate;
  float along = dot(quadricGradient(quadric, step2), lateral) / root;
  return (vec3(lateral, 0.0) - along * normal) / root;
}

// q_u x q_v of the displaced surface q = s - d N over the quadric s with normal N (in texture space,
// outward) after a step, all terms: q_u = s_u - d_u N - d N_u (Marschner2008, "normals"). relief: d;
// heightGradient: -(d_u, d_v). The result counts v x depth, depth x u and u x v.
vec3 displacedCross(vec3 quadric, vec3 metric, vec2 step2, float relief, vec2 heightGradient)
{
  float root;
  vec3 normal = quadricNormal(quadric, metric, step2, root);
  vec2 gradient = quadricGradient(quadric, step2);
  vec3 alongU = vec3(1.0, 0.0, gradient.x) + heightGradient.x * normal -
    relief * quadricNormalDerivative(quadric, metric, step2, vec2(1.0, 0.0));
  vec3 alongV = vec3(0.0, 1.0, gradient.y) + heightGradient.y * normal -
    relief * quadricNormalDerivative(quadric, metric, step2, vec2(0.0, 1.0));
  return cross(alongU, alongV);
}

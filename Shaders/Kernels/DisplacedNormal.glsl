// The normal of a displaced surface q = p + (h - r) D n: Blinn1978, Marschner2008
// (Documentation/Techniques/References.md). All vectors in one space; derivatives are by map coordinate.

// Derivatives of a linear function that grows by a and b along two edges over the map. False, with 0,
// where the edges span no more than `least`.
bool perMapCoord(
  vec2 edgeA, vec2 edgeB, float least, vec3 a, vec3 b, out vec3 perU, out vec3 perV)
{
  float area = edgeA.x * edgeB.y - edgeA.y * edgeB.x;
  perU = vec3(0.0);
  perV = vec3(0.0);
  if (!(abs(area) > least)) // NaN counts as none
  {
    return false;
  }
  perU = a * (edgeB.y / area) - b * (edgeA.y / area);
  perV = b * (edgeA.x / area) - a * (edgeB.x / area);
  return true;
}

// What is left of v across a unit direction.
vec3 across(vec3 v, vec3 direction)
{
  return v - dot(v, direction) * direction;
}

// q_u x q_v, unit, on the side of the base's unit normal where heights are even:
//   q_u = P p_u + D (h_u n + (h - r) n_u),   P p_u = p_u - n (n . p_u)
// perU, perV: p_u and p_v; gradient: (h_u, h_v); turnU, turnV: how the interpolated normal changes, over
// its length; offset: h - r. With both turns 0 the term of the base's curvature is left out. The normal
// itself where the map has no area or the sum no direction.
vec3 displacedNormal(vec3 perU, vec3 perV, vec3 normal, vec3 turnU, vec3 turnV, vec2 gradient,
  float offset, float scale)
{
  vec3 flatU = across(perU, normal);
  vec3 flatV = across(perV, normal);
  vec3 alongU = flatU + scale * (gradient.x * normal + offset * across(turnU, normal));
  vec3 alongV = flatV + scale * (gradient.y * normal + offset * across(turnV, normal));
  vec3 sum = cross(alongU, alongV);
  float size = length(sum);
  float side = dot(cross(flatU, flatV), normal);
  if (!(size > 0.0) || !(size < 1.0e30) || !(abs(side) > 0.0))
  {
    return normal;
  }
  return (side > 0.0 ? 1.0 : -1.0) / size * sum;
}

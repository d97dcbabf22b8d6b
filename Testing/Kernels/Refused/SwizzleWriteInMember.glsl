struct Ray
{
  vec3 Origin[2];
};

void moved(inout Ray ray, vec2 by)
{
  ray.Origin[1].xy = by; // Refused: write to the swizzle .xy
  (ray.Origin[0].yz) -= by; // Refused: assignment to an expression in parentheses
}

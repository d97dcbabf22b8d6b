void both(vec2 from, out vec2 to, inout vec2 over)
{
  to = from;
  over += from;
}

vec3 moved(vec3 v, vec3 w)
{
  vec2 to;
  both(v.xy, to, v.yz); // Refused: swizzle .yz passed as out to both
  both(w.xy + v.xy, v.xz, to); // Refused: swizzle .xz passed as out to both
  return v;
}

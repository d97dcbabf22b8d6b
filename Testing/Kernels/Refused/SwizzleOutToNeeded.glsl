// Needs AcceptedNeeded.glsl

vec3 moved(vec3 v)
{
  acceptedSplit(v.xy, v.yz); // Refused: swizzle .yz passed as out to acceptedSplit
  return v;
}

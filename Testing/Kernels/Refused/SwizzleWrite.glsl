vec3 moved(vec3 v, vec2 by)
{
  v.xy = by; // Refused: write to the swizzle .xy
  v.z = 1.0;
  v.xz += by; // Refused: write to the swizzle .xz
  v.xy[0] = 1.0; // Refused: write to the swizzle .xy
  v.rg *= 2.0; // Refused: write to the swizzle .rg
  --v.yz; // Refused: write to the swizzle .yz
  v.st++; // Refused: write to the swizzle .st
  return v;
}

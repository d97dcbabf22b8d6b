// Each pixel's hit as numbers. Targets: 1 normal and coverage, 2 depth, texcoord and relief,
// 3 object, fetches, texel reads and iterations, 4 and on four lights' shadow each.
//   MESO_SURFACE   the mapper is one of Meso's: everything is known
//   MESO_LIGHTING  Meso's own lighting is in the shader, with each light's blocked fraction
uniform mat3 mesoViewToWorld;
uniform vec4 mesoDepthOfZ; // rows of the projection that give z and w
uniform float mesoObject;

// Distance from the camera along its axis for a depth buffer value: solves
// z/w = (a Z + b) / (c Z + d) for the view coordinate Z.
float viewDistance(float depth)
{
  float z = 2.0 * depth - 1.0;
  return -(z * mesoDepthOfZ.w - mesoDepthOfZ.y) / (mesoDepthOfZ.x - z * mesoDepthOfZ.z);
}

#if defined(MESO_SURFACE) && defined(MESO_LIGHTING)
// Blocked fractions of four lights from the first on.
vec4 blockedFrom(int first)
{
  vec4 blocked = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    if (first + i < MESO_LIGHT_COUNT)
    {
      blocked[i] = mesoBlocked[first + i];
    }
  }
  return blocked;
}
#endif

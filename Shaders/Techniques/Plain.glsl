// The base mesh, nothing else: the floor that every other technique is measured against.

MesoSurfaceHit traceSurface(MesoFragment f)
{
  return baseSurface(f);
}

float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
  return 0.0;
}

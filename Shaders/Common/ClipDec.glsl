// Clipping planes, met where the ray hits. They keep a convex part of space, and so one stretch of
// each ray.
//   MESO_CLIPPED  these chunks are in the shader
uniform int mesoClipPlaneCount;
uniform vec4 mesoClipPlanes[6]; // VC, positive where kept

// The stretch of a ray that is kept, from x to y along a unit direction; nothing where x > y.
vec2 keptStretch(vec3 fromVC, vec3 directionVC)
{
  vec2 kept = vec2(-1.0e30, 1.0e30);
  for (int i = 0; i < mesoClipPlaneCount; ++i)
  {
    float above = dot(mesoClipPlanes[i], vec4(fromVC, 1.0));
    float rise = dot(mesoClipPlanes[i].xyz, directionVC);
    if (rise > 0.0)
    {
      kept.x = max(kept.x, -above / rise);
    }
    else if (rise < 0.0)
    {
      kept.y = min(kept.y, -above / rise);
    }
    else if (above < 0.0)
    {
      kept.y = -1.0e30;
    }
  }
  return kept;
}

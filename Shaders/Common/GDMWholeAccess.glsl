// The only function that knows the texture of a whole table; the kernel GDMWhole stands on it.
uniform sampler3D mesoGDMDistances; // azimuths x W across, polars x H upwards, levels deep
uniform float mesoGDMLargest;       // what 1 of the texture stands for, tile widths

float fetchGDM(ivec3 point, ivec2 direction)
{
  ivec3 size = gdmSize();
  return mesoGDMLargest *
    texelFetch(mesoGDMDistances,
      ivec3(direction.x * size.x + point.x, direction.y * size.y + point.y, point.z),
      0)
      .r;
}

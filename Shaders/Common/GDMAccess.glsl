// The size of a generalized displacement map; the kernel GDMTable stands on these.
uniform vec3 mesoGDMSize; // whole numbers
uniform ivec2 mesoGDMDirections;
uniform int mesoGDMEven;

ivec3 gdmSize()
{
  return ivec3(mesoGDMSize);
}

ivec2 gdmDirections()
{
  return mesoGDMDirections;
}

bool gdmEven()
{
  return mesoGDMEven != 0;
}

// The only functions that know the textures of a table's factors; the kernel GDMFactors stands on these.
//   MESO_GDM_GROUPS  fours of products
uniform sampler3D mesoGDMWeights;   // of each group the azimuths, and the first of them again
uniform sampler2D mesoGDMFunctions; // polars across, of each group the levels upwards
// What 0 and 1 of the weights stand for: the least and the span.
uniform vec4 mesoGDMLeast[MESO_GDM_GROUPS];
uniform vec4 mesoGDMSpan[MESO_GDM_GROUPS];

int gdmGroups()
{
  return MESO_GDM_GROUPS;
}

vec4 gdmWeights(int group, vec2 tile, float azimuth)
{
  float slices = float(mesoGDMDirections.x + 1);
  float slice = (float(group) * slices + azimuth + 0.5) / (float(MESO_GDM_GROUPS) * slices);
  return mesoGDMLeast[group] +
    mesoGDMSpan[group] * textureLod(mesoGDMWeights, vec3(tile, slice), 0.0);
}

vec4 gdmFunctions(int group, float polar, float level)
{
  float levels = mesoGDMSize.z;
  return textureLod(mesoGDMFunctions,
    vec2((polar + 0.5) / float(mesoGDMDirections.y),
      (float(group) * levels + level + 0.5) / (float(MESO_GDM_GROUPS) * levels)),
    0.0);
}

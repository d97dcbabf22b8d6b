// Colours of matter in texture space, over the volume's own samples. Stands on Common/PrismMatter.
uniform sampler3D mesoVolumeColors;

vec3 colorOfMatter()
{
  return textureLod(mesoVolumeColors, chartPlace(mesoChart, mesoPlace), 0.0).rgb;
}

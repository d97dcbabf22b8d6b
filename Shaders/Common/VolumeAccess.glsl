// The only functions that know the sampler of a volume of signed distances; Kernels/Volume stands on
// these.
uniform sampler3D mesoVolume;
uniform float mesoVolumeDepth; // tile widths

float fetchVolume(ivec3 voxel)
{
  return texelFetch(mesoVolume, voxel, 0).r;
}

float sampleVolume(vec3 place)
{
  return textureLod(mesoVolume, place, 0.0).r;
}

ivec3 volumeSize()
{
  return textureSize(mesoVolume, 0);
}

// Mesostructure in a shell of prisms, its signed distance followed by steps as long as it says. Stands on
// Common/PrismShell and Kernels/Volume.
//   MESO_LEAST_STEP  shortest step, in voxels
//   MESO_MOST_STEPS  of a piece of the way

VolumeHit meetMatter(vec3 from, vec3 span)
{
  return bracketInVolume(
    from, span, mesoVolumeDepth, MESO_LEAST_STEP * voxelSide(mesoVolumeDepth), MESO_MOST_STEPS, false);
}

VolumeHit refineMeeting(vec3 from, vec3 span, VolumeHit hit)
{
  return exactHit(from, span, hit);
}

vec3 matterGradient(vec3 place)
{
  return volumeGradient(place);
}

vec3 facetGradient(vec3 place)
{
  return voxelGradient(place);
}

bool matterBlocks(vec3 from, vec3 span, out int fetches)
{
  VolumeHit found = bracketInVolume(
    from, span, mesoVolumeDepth, MESO_LEAST_STEP * voxelSide(mesoVolumeDepth), MESO_MOST_STEPS, true);
  fetches = found.Fetches;
  return found.Found;
}

// Normals of matter that a slice cuts, and what light it blocks. Stands on Common/PrismMatter and
// Kernels/Volume.
//   MESO_LEAST_STEP, MESO_MOST_STEPS  of shadows, as in Techniques/ShellSDF

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
  // A slice cuts into matter: light is followed from its surface.
  vec3 start = liftedOff(from, mesoVolumeDepth, 0.5);
  fetches = 8;
  if (start.z <= 0.0 || start.z >= 1.0)
  {
    return false;
  }
  VolumeHit found = bracketInVolume(start, wayInShell(start, span), mesoVolumeDepth,
    MESO_LEAST_STEP * voxelSide(mesoVolumeDepth), MESO_MOST_STEPS, false);
  fetches += found.Fetches;
  return found.Found;
}

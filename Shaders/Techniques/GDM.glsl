// Mesostructure in a shell of prisms by its generalized displacement map: one look-up says how far matter is
// along a ray (Wang2004, section 3.2). Stands on Common/PrismShell, Kernels/Volume and one of
// Kernels/GDMFactors, GDMWhole.
//
// The table holds, for a ray that meets nothing, how far the shell's bottom or top is (section 4.1). So
// what the volume's own distance is at the end of the look-up tells whether there is matter.

//   MESO_CORRECTIONS  steps of the volume's own distance after a look-up, against the table's error

// What the volume's distance is at most at the end of a look-up that met matter, in voxels.
const float MESO_SURFACE_VOXELS = MESO_CORRECTIONS > 0 ? 0.5 : 1.5;
// A light's way starts this many voxels off the surface, beyond the zeros that points in matter have.
const float MESO_LIFT_VOXELS = 1.5;

vec3 inTileWidths(vec3 way)
{
  return way * vec3(1.0, 1.0, mesoVolumeDepth);
}

// Whether the table says that matter is met before a way's end; part: of the way.
bool lookUp(vec3 from, vec3 span, out float part)
{
  vec3 way = inTileWidths(span);
  float size = length(way);
  part = 0.0;
  if (!(size > 0.0))
  {
    return false;
  }
  part = gdmDistance(from, way / size) / size;
  for (int i = 0; i < MESO_CORRECTIONS && part < 1.0; ++i)
  {
    part = max(part + sampleVolume(from + part * span) / size, 0.0);
  }
  return part < 1.0 &&
    sampleVolume(from + part * span) < MESO_SURFACE_VOXELS * voxelSide(mesoVolumeDepth);
}

VolumeHit meetMatter(vec3 from, vec3 span)
{
  VolumeHit hit;
  hit.Part = 0.0;
  hit.Steps = 1 + MESO_CORRECTIONS;
  hit.Fetches = 1;
  hit.Outside = 0.0;
  hit.DistanceOutside = 0.0;
  hit.DistanceAt = sampleVolume(from);
  hit.Found = hit.DistanceAt <= 0.0;
  if (!hit.Found)
  {
    hit.Found = lookUp(from, span, hit.Part);
    hit.Fetches = 3 + MESO_CORRECTIONS;
  }
  return hit;
}

VolumeHit refineMeeting(vec3 from, vec3 span, VolumeHit hit)
{
  return hit;
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
  vec3 start = liftedOff(from, mesoVolumeDepth, MESO_LIFT_VOXELS);
  fetches = 10 + MESO_CORRECTIONS;
  float part;
  return start.z > 0.0 && start.z < 1.0 &&
    (sampleVolume(start) <= 0.0 || lookUp(start, wayInShell(start, span), part));
}

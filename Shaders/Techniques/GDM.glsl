// Mesostructure in a shell of prisms by its generalized displacement map: one look-up says how far matter is
// along a ray (Wang2004, section 3.2). Stands on Common/PrismShell, Kernels/Volume and one of
// Kernels/GDMFactors, GDMWhole.
//
// The table holds, for a ray that meets nothing, how far the shell's bottom or top is (section 4.1). So
// what the volume's own distance is at the end of the look-up tells whether there is matter.

//   MESO_CORRECTIONS  steps of the volume's own distance after a look-up, against the table's error

// What the volume's distance is at most at the end of a look-up that met matter, in voxels; of a light's way more,
// since no other look-up comes nearer.
const float MESO_SURFACE_VOXELS = MESO_CORRECTIONS > 0 ? 0.25 : 1.5;
const float MESO_BLOCKER_VOXELS = MESO_CORRECTIONS > 0 ? 0.5 : 1.5;
// Look-ups of an eye's way at most. Where one ends at nothing - before matter that the corrections do not reach, as
// where a ray runs along it, or beside matter that it passes - the next begins. Without corrections the one says
// all; so does it of a light's way, which others would find blocked by the surface that it leaves.
const int MESO_LOOKUPS = MESO_CORRECTIONS > 0 ? 8 : 1;
// A light's way starts this many voxels off the surface, beyond the zeros that points in matter have.
const float MESO_LIFT_VOXELS = 1.5;

vec3 inTileWidths(vec3 way)
{
  return way * vec3(1.0, 1.0, mesoVolumeDepth);
}

// Whether the table says that matter is met before a way's end, in so many look-ups at most and as near as so many
// voxels; part: of the way.
bool lookUp(vec3 from, vec3 span, int most, float voxels, out float part, out int fetches)
{
  vec3 way = inTileWidths(span);
  float size = length(way);
  part = 0.0;
  fetches = 0;
  if (!(size > 0.0))
  {
    return false;
  }
  float surface = voxels * voxelSide(mesoVolumeDepth);
  bool found = false;
  for (int look = 0; look < most && part < 1.0 && !found; ++look)
  {
    part += gdmDistance(from + part * span, way / size) / size;
    float above = sampleVolume(from + part * span);
    for (int i = 0; i < MESO_CORRECTIONS && part < 1.0; ++i)
    {
      part = max(part + above / size, 0.0);
      above = sampleVolume(from + part * span);
    }
    found = part < 1.0 && above < surface;
    fetches += 2 + MESO_CORRECTIONS;
  }
  return found;
}

VolumeHit meetMatter(vec3 from, vec3 span)
{
  VolumeHit hit;
  hit.Part = 0.0;
  hit.Steps = 1;
  hit.Fetches = 1;
  hit.Outside = 0.0;
  hit.DistanceOutside = 0.0;
  hit.DistanceAt = sampleVolume(from);
  hit.Found = hit.DistanceAt <= 0.0;
  if (!hit.Found)
  {
    int fetches;
    hit.Found = lookUp(from, span, MESO_LOOKUPS, MESO_SURFACE_VOXELS, hit.Part, fetches);
    hit.Fetches += fetches;
    hit.Steps = fetches;
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
  fetches = 8;
  if (start.z <= 0.0 || start.z >= 1.0)
  {
    return false;
  }
  float part;
  int looked = 0;
  bool blocks = sampleVolume(start) <= 0.0 ||
    lookUp(start, wayInShell(start, span), 1, MESO_BLOCKER_VOXELS, part, looked);
  fetches += looked;
  return blocks;
}

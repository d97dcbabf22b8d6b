// Signed distance to mesostructure in texture space, and the first meeting of a straight way with it.
//
// Texture space: x, y in tiles, z in [0, 1] through the shell. Distances are in tile widths, with z times
// `depth`, the volume's depth in tile widths; negative inside. Between the centres of voxels they are
// trilinear; x and y repeat, z goes on as it ends.
// Stands on accessors: fetchVolume(ivec3), one voxel; sampleVolume(vec3), as the device interpolates;
// volumeSize().

struct VolumeHit
{
  bool Found;
  float Part;  // of the way
  int Fetches; // filtered samples
  int Steps;
  float Outside;         // the last part before Part that is known to be outside
  float DistanceOutside; // and the distances at both
  float DistanceAt;
};

// The shortest side of a voxel, in tile widths.
float voxelSide(float depth)
{
  vec3 side = vec3(1.0, 1.0, depth) / vec3(volumeSize());
  return min(side.x, min(side.y, side.z));
}

int wrapVoxel(int i, int size)
{
  // Devices have floats divided faster than whole numbers.
  float turns = floor((float(i) + 0.5) / float(size));
  return i - int(turns) * size;
}

// The eight distances around a place, lower and upper four (x running first), and the place among them.
void fetchCell(vec3 place, out vec4 lower, out vec4 upper, out vec3 weight)
{
  ivec3 size = volumeSize();
  vec3 at = place * vec3(size) - 0.5;
  vec3 low = floor(at);
  weight = at - low;
  int x0 = wrapVoxel(int(low.x), size.x);
  int x1 = wrapVoxel(int(low.x) + 1, size.x);
  int y0 = wrapVoxel(int(low.y), size.y);
  int y1 = wrapVoxel(int(low.y) + 1, size.y);
  int z0 = clamp(int(low.z), 0, size.z - 1);
  int z1 = clamp(int(low.z) + 1, 0, size.z - 1);
  lower = vec4(fetchVolume(ivec3(x0, y0, z0)), fetchVolume(ivec3(x1, y0, z0)),
    fetchVolume(ivec3(x0, y1, z0)), fetchVolume(ivec3(x1, y1, z0)));
  upper = vec4(fetchVolume(ivec3(x0, y0, z1)), fetchVolume(ivec3(x1, y0, z1)),
    fetchVolume(ivec3(x0, y1, z1)), fetchVolume(ivec3(x1, y1, z1)));
}

// The distance with weights that are the same on every device.
float exactDistance(vec3 place)
{
  vec4 lower;
  vec4 upper;
  vec3 w;
  fetchCell(place, lower, upper, w);
  vec4 cell = mix(lower, upper, w.z);
  return mix(mix(cell.x, cell.y, w.x), mix(cell.z, cell.w, w.x), w.y);
}

// Change of the distance with x, y and z within its cell of eight voxels: jumps from cell to cell.
vec3 voxelGradient(vec3 place)
{
  vec4 lower;
  vec4 upper;
  vec3 w;
  fetchCell(place, lower, upper, w);
  vec4 cell = mix(lower, upper, w.z);
  vec4 rise = upper - lower;
  return vec3(volumeSize()) *
    vec3(mix(cell.y - cell.x, cell.w - cell.z, w.y), mix(cell.z - cell.x, cell.w - cell.y, w.x),
      mix(mix(rise.x, rise.y, w.x), mix(rise.z, rise.w, w.x), w.y));
}

// Change of the distance with x, y and z: central differences of one voxel.
vec3 volumeGradient(vec3 place)
{
  vec3 size = vec3(volumeSize());
  vec3 voxel = 1.0 / size;
  vec3 dx = vec3(voxel.x, 0.0, 0.0);
  vec3 dy = vec3(0.0, voxel.y, 0.0);
  vec3 dz = vec3(0.0, 0.0, voxel.z);
  return 0.5 * size *
    vec3(exactDistance(place + dx) - exactDistance(place - dx),
      exactDistance(place + dy) - exactDistance(place - dy),
      exactDistance(place + dz) - exactDistance(place - dz));
}

// A place in or on matter moved out of it, along its normal, by `voxels` beyond its surface.
vec3 liftedOff(vec3 place, float depth, float voxels)
{
  vec3 metric = vec3(1.0, 1.0, depth);
  vec3 away = volumeGradient(place) / metric; // per tile width
  float size = length(away);
  if (!(size > 0.0))
  {
    return place;
  }
  float inside = max(-exactDistance(place), 0.0);
  return place + (inside + voxels * voxelSide(depth)) / size * away / metric;
}

// The part of a way from a place that lies in the shell.
vec3 wayInShell(vec3 from, vec3 span)
{
  if (span.z == 0.0)
  {
    return span;
  }
  return span * clamp(((span.z > 0.0 ? 1.0 : 0.0) - from.z) / span.z, 0.0, 1.0);
}

// The first meeting of the way from + part span, part in [0, 1], by steps as long as the distance says
// (Hart1996), but at least `leastStep` (tile widths): matter thinner than that may be passed by where a ray
// grazes it. `startsOutside`: what the distance says at the start is not believed. Part is that of the first
// step's end that is inside; exactHit says where it comes in. (Apart, since devices that run several
// pixels as one do what one of them does in a loop for all.)
VolumeHit bracketInVolume(
  vec3 from, vec3 span, float depth, float leastStep, int mostSteps, bool startsOutside)
{
  VolumeHit hit;
  float d = sampleVolume(from);
  hit.Found = d <= 0.0 && !startsOutside;
  hit.Part = 0.0;
  hit.Fetches = 1;
  hit.Steps = 0;
  hit.Outside = 0.0;
  hit.DistanceOutside = 0.0;
  hit.DistanceAt = d;
  float way = length(span * vec3(1.0, 1.0, depth));
  if (hit.Found || !(way > 0.0))
  {
    return hit;
  }
  float part = 0.0;
  for (int i = 0; i < mostSteps && part < 1.0 && !hit.Found; ++i)
  {
    hit.Outside = part;
    hit.DistanceOutside = max(d, 0.0);
    part = min(part + max(d, leastStep) / way, 1.0);
    d = sampleVolume(from + part * span);
    hit.Found = d <= 0.0;
    hit.Steps += 1;
  }
  hit.Fetches += hit.Steps;
  hit.Part = part;
  hit.DistanceAt = d;
  return hit;
}

// What bracketInVolume found, with Part where the way comes in.
VolumeHit exactHit(vec3 from, vec3 span, VolumeHit bracket)
{
  VolumeHit hit = bracket;
  if (!(hit.Found && hit.Part > 0.0))
  {
    return hit;
  }
  float before = hit.Outside;
  float after = hit.Part;
  float dBefore = hit.DistanceOutside;
  float dAfter = hit.DistanceAt;
  for (int i = 0; i < 6; ++i)
  {
    // The secant, kept from the ends so that each step narrows the bracket.
    float share = clamp(dBefore / max(dBefore - dAfter, 1.0e-30), 0.05, 0.95);
    float part = mix(before, after, share);
    float d = exactDistance(from + part * span);
    bool outside = d > 0.0;
    before = outside ? part : before;
    dBefore = outside ? d : dBefore;
    after = outside ? after : part;
    dAfter = outside ? dAfter : d;
  }
  hit.Fetches += 6;
  hit.Part = mix(before, after, clamp(dBefore / max(dBefore - dAfter, 1.0e-30), 0.0, 1.0));
  return hit;
}

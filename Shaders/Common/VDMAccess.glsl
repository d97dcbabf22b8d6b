// The only functions that know a VDM table's samplers. What they give is interpolated over all axes: map
// coordinate, direction, and the place among the table's curvatures, from 0 to their number - 1.
//   MESO_VDM_AZIMUTHS, MESO_VDM_POLARS, MESO_VDM_CURVATURES   the table's size
//   MESO_VDM_STORES, MESO_VDM_NODES   as the constants of Kernels/VDMTable
//   MESO_VDM_GROUPS, MESO_MVM_GROUPS  fours of factors, 1 to 3; undefined: the table itself

uniform float mesoVDMDepth;      // of the relief, in tiles
uniform float mesoVDMRange;      // what the stored number 1 stands for, in tiles
uniform float mesoVDMError;      // root mean square error of what is interpolated between angles, in tiles
uniform vec2 mesoVDMCurvatures;  // the first and the last
uniform vec2 mesoVDMTexels;      // of the table, a tile

VDMLayout vdmTable()
{
  VDMLayout table;
  table.Stores = MESO_VDM_STORES;
  table.Nodes = MESO_VDM_NODES;
  table.Polars = MESO_VDM_POLARS;
  table.Curvatures = MESO_VDM_CURVATURES;
  table.FirstCurvature = mesoVDMCurvatures.x;
  table.LastCurvature = mesoVDMCurvatures.y;
  table.Depth = mesoVDMDepth;
  table.Range = mesoVDMRange;
  return table;
}

#ifdef MESO_VDM_GROUPS
// Four factors a texture. A weight is the texture's number and what it is shifted by; the functions are
// scaled to that, and lie over the tangent of half the polar angle.
uniform sampler3D mesoVDMWeights0;
uniform sampler2D mesoVDMFunctions0;
uniform sampler2D mesoMVMFunctions0;
uniform vec4 mesoVDMShift0;
#if MESO_VDM_GROUPS > 1 || MESO_MVM_GROUPS > 1
uniform sampler3D mesoVDMWeights1;
uniform sampler2D mesoVDMFunctions1;
uniform sampler2D mesoMVMFunctions1;
uniform vec4 mesoVDMShift1;
#endif
#if MESO_VDM_GROUPS > 2 || MESO_MVM_GROUPS > 2
uniform sampler3D mesoVDMWeights2;
uniform sampler2D mesoVDMFunctions2;
uniform sampler2D mesoMVMFunctions2;
uniform vec4 mesoVDMShift2;
#endif

vec3 weightPlace(vec2 mapCoord, float turns)
{
  return vec3(mapCoord, turns + 0.5 / float(MESO_VDM_AZIMUTHS));
}

vec2 functionPlace(float halfTangent, float curvature)
{
  return vec2(halfTangent, (curvature + 0.5) / float(MESO_VDM_CURVATURES));
}

vec2 angleFunctionPlace(float curvature)
{
  return vec2((curvature + 0.5) / float(MESO_VDM_CURVATURES), 0.5);
}

float sampleVDM(vec2 mapCoord, VDMDirection ray, float curvature, inout int fetches)
{
  vec3 weight = weightPlace(mapCoord, ray.Turns);
  vec2 place = functionPlace(ray.HalfTangent, curvature);
  float stored = dot(textureLod(mesoVDMWeights0, weight, 0.0) + mesoVDMShift0,
    textureLod(mesoVDMFunctions0, place, 0.0));
#if MESO_VDM_GROUPS > 1
  stored += dot(textureLod(mesoVDMWeights1, weight, 0.0) + mesoVDMShift1,
    textureLod(mesoVDMFunctions1, place, 0.0));
#endif
#if MESO_VDM_GROUPS > 2
  stored += dot(textureLod(mesoVDMWeights2, weight, 0.0) + mesoVDMShift2,
    textureLod(mesoVDMFunctions2, place, 0.0));
#endif
  fetches += 2 * MESO_VDM_GROUPS;
  return clamp(stored, 0.0, 1.0);
}

// The largest polar angle, of 90 degrees; factors sum to what it leaves. The weights of sampleVDM at the same place serve again.
float sampleMVM(vec2 mapCoord, float turns, float curvature, inout int fetches)
{
  vec3 weight = weightPlace(mapCoord, turns);
  vec2 place = angleFunctionPlace(curvature);
  float angle = dot(textureLod(mesoVDMWeights0, weight, 0.0) + mesoVDMShift0,
    textureLod(mesoMVMFunctions0, place, 0.0));
#if MESO_MVM_GROUPS > 1
  angle += dot(textureLod(mesoVDMWeights1, weight, 0.0) + mesoVDMShift1,
    textureLod(mesoMVMFunctions1, place, 0.0));
#endif
#if MESO_MVM_GROUPS > 2
  angle += dot(textureLod(mesoVDMWeights2, weight, 0.0) + mesoVDMShift2,
    textureLod(mesoMVMFunctions2, place, 0.0));
#endif
  fetches += MESO_MVM_GROUPS + max(MESO_MVM_GROUPS - MESO_VDM_GROUPS, 0);
  return clamp(1.0 - angle, 0.0, 1.0);
}
#else
// Slices of azimuths, the first again behind the last; of each curvature and four polar angles in the
// one, of each four curvatures in the other.
uniform sampler3D mesoVDMTable;
uniform sampler3D mesoVDMAngles;
const int MESO_VDM_FOURS = (MESO_VDM_POLARS + 3) / 4;
const int MESO_MVM_FOURS = (MESO_VDM_CURVATURES + 3) / 4;

vec4 sampleSlices(sampler3D slices, vec2 mapCoord, float turns, int block)
{
  float slice = float(block * (MESO_VDM_AZIMUTHS + 1)) + turns * float(MESO_VDM_AZIMUTHS) + 0.5;
  return textureLod(slices, vec3(mapCoord, slice / float(textureSize(slices, 0).z)), 0.0);
}

// Of numbers in fours, `first` the block of the first four: between the one before a place and the next.
float sampleFours(sampler3D slices, vec2 mapCoord, float turns, int first, float place, int count,
  inout int fetches)
{
  int low = min(int(place), max(count - 2, 0));
  int high = min(low + 1, count - 1);
  vec4 four = sampleSlices(slices, mapCoord, turns, first + low / 4);
  fetches += 1;
  float before = four[low - low / 4 * 4];
  if (high / 4 != low / 4)
  {
    four = sampleSlices(slices, mapCoord, turns, first + high / 4);
    fetches += 1;
  }
  return mix(before, four[high - high / 4 * 4], place - float(low));
}

float sampleVDM(vec2 mapCoord, VDMDirection ray, float curvature, inout int fetches)
{
  float polar = vdmPolarPlace(vdmTable(), 2.0 * atan(ray.HalfTangent));
  int low = min(int(curvature), max(MESO_VDM_CURVATURES - 2, 0));
  int high = min(low + 1, MESO_VDM_CURVATURES - 1);
  return mix(sampleFours(mesoVDMTable, mapCoord, ray.Turns, low * MESO_VDM_FOURS, polar, MESO_VDM_POLARS,
               fetches),
    sampleFours(mesoVDMTable, mapCoord, ray.Turns, high * MESO_VDM_FOURS, polar, MESO_VDM_POLARS,
      fetches),
    curvature - float(low));
}

float sampleMVM(vec2 mapCoord, float turns, float curvature, inout int fetches)
{
  return sampleFours(
    mesoVDMAngles, mapCoord, turns, 0, curvature, MESO_VDM_CURVATURES, fetches);
}
#endif

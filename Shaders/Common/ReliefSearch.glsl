// The search that was chosen, for techniques that follow a path through a height map.
//   MESO_SEARCH  which: as MesoSearch counts
//   MESO_LINEAR_STEPS, MESO_REFINING_STEPS  its steps
//   MESO_FILTER  where texels are smaller than pixels, the surface is that of a level of the map's pyramid,
//                by equal steps, two to a texel of the level
//   MESO_CONE_LEVELS  levels have cones, and are searched as the map is

#if defined(MESO_FILTER) && !defined(MESO_CONE_LEVELS)
#define MESO_STEPS_OF_LEVEL
int stepsOfLevel(HeightPath path)
{
  vec2 span = abs(pathMap(path, 1.0) - pathMap(path, 0.0)) * vec2(mapSize()) * exp2(-mesoLevel);
  float steps = clamp(2.0 * (span.x + span.y) + 4.0, 4.0, float(MESO_LINEAR_STEPS));
  return pathSteps(path, int(steps));
}
#endif

// First meeting of the path with the relief.
HeightHit searchRelief(HeightPath path)
{
#ifdef MESO_STEPS_OF_LEVEL
  if (mesoLevel > 0.0)
  {
    return searchLinearBinary(path, stepsOfLevel(path), MESO_REFINING_STEPS);
  }
#endif
#if MESO_SEARCH == 3
  return searchCertified(path);
#elif MESO_SEARCH == 2
  return searchCone(path, pathSteps(path, MESO_LINEAR_STEPS), MESO_REFINING_STEPS);
#elif MESO_SEARCH == 1
  return searchLinearSecant(path, pathSteps(path, MESO_LINEAR_STEPS), MESO_REFINING_STEPS);
#else
  return searchLinearBinary(path, pathSteps(path, MESO_LINEAR_STEPS), MESO_REFINING_STEPS);
#endif
}

// The same on the stretch of the view ray that clipping planes keep; rayLength is that of the whole
// path. A ray that comes in below the surface, through a cut, sees nothing until it is outside.
HeightHit searchKept(MesoFragment f, HeightPath path, float rayLength)
{
#ifdef MESO_CLIPPED
  if (f.RayStart > 0.0)
  {
    HeightHit found = noHit();
    int fetches = 0;
    float start = 1.0;
    if (f.RayStart < rayLength && pathIsSound(path))
    {
      start = partOutside(path, f.RayStart / rayLength, MESO_LINEAR_STEPS, fetches);
    }
    if (start < 1.0)
    {
      found = searchRelief(restOfPath(path, start));
      found.Part = start + (1.0 - start) * found.Part;
    }
    found.Fetches += fetches;
    found.TexelReads += 4 * fetches;
    return found;
  }
#endif
  return searchRelief(path);
}

// 1.0 where the relief blocks a path out of it, else 0.0.
float reliefOccludes(HeightPath path, out int fetches)
{
#ifdef MESO_STEPS_OF_LEVEL
  if (mesoLevel > 0.0)
  {
    return occludedLinear(path, stepsOfLevel(path), fetches);
  }
#endif
#if MESO_SEARCH == 3
  return occludedCertified(path, fetches);
#elif MESO_SEARCH == 2
  return occludedCone(path, pathSteps(path, MESO_LINEAR_STEPS), fetches);
#else
  return occludedLinear(path, pathSteps(path, MESO_LINEAR_STEPS), fetches);
#endif
}

// What the search found; hit.RayLength is the caller's.
void takeSearch(HeightHit found, inout MesoSurfaceHit hit)
{
  hit.MapCoord = found.MapCoord;
  hit.Relief = found.Relief;
  hit.Fetches = found.Fetches;
  hit.TexelReads = found.TexelReads;
  hit.Iterations = found.Iterations;
}

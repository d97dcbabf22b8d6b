// The search that was chosen, for techniques that follow a path through a height map.
//   MESO_SEARCH  which: as MesoSearch counts
//   MESO_LINEAR_STEPS, MESO_REFINING_STEPS  its steps
//   MESO_FILTER  where texels are smaller than pixels, the surface is that of a level of the map's pyramid,
//                by no more steps than two a texel of the level

// Steps of a search over the level that is looked for.
int searchSteps(HeightPath path)
{
  int most = MESO_LINEAR_STEPS;
#ifdef MESO_FILTER
  vec2 span = abs(pathMap(path, 1.0) - pathMap(path, 0.0)) * vec2(mapSize() >> mesoSearchedLevel);
  float ofLevel = clamp(2.0 * (span.x + span.y) + 4.0, 4.0, float(MESO_LINEAR_STEPS));
  most = mesoSearchedLevel > 0 ? int(ofLevel) : most;
#endif
  return pathSteps(path, most);
}

// First meeting of the path with the relief.
HeightHit searchRelief(HeightPath path)
{
#if MESO_SEARCH == 3
  return searchCertified(path);
#elif MESO_SEARCH == 2
  return searchCone(path, searchSteps(path), MESO_REFINING_STEPS);
#elif MESO_SEARCH == 1
  return searchLinearSecant(path, searchSteps(path), MESO_REFINING_STEPS);
#else
  return searchLinearBinary(path, searchSteps(path), MESO_REFINING_STEPS);
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
#if MESO_SEARCH == 3
  return occludedCertified(path, fetches);
#elif MESO_SEARCH == 2
  return occludedCone(path, searchSteps(path), fetches);
#else
  return occludedLinear(path, searchSteps(path), fetches);
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

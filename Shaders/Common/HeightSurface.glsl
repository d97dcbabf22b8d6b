// The surface that the relief techniques draw of a height map. Stands on Kernels/HeightBilinear or
// Kernels/HeightBicubic and, with MESO_FILTER, on Common/HeightLevels.
//   MESO_FILTER   where texels are smaller than pixels it is that of a level of the map's pyramid; from
//                 the map itself to its first level it goes over step by step
//   MESO_CONE_LEVELS   the levels are those of Kernels/HeightLevels, exactly

// What searches look for.
float surfaceHeight(vec2 uv)
{
#ifdef MESO_CONE_LEVELS
  return heightAtLevel(uv, mesoLevel);
#endif
#ifdef MESO_FILTER
  if (mesoLevel >= 1.0)
  {
    return filteredHeight(uv, mesoLevel);
  }
  if (mesoLevel > 0.0)
  {
    return mix(mapHeight(uv), filteredHeight(uv, 1.0), mesoLevel);
  }
#endif
  return mapHeight(uv);
}

// dh/du, dh/dv: of the surface itself, or of the shading normal.
vec2 surfaceSlope(vec2 uv, bool ofFacet)
{
#ifdef MESO_FILTER
  if (mesoLevel >= 1.0)
  {
    return gradientOfLevel(uv, mesoLevel);
  }
#endif
  vec2 slope = ofFacet ? mapFacet(uv) : mapGradient(uv);
#ifdef MESO_FILTER
  if (mesoLevel > 0.0)
  {
    slope = mix(slope, gradientOfLevel(uv, 1.0), mesoLevel);
  }
#endif
  return slope;
}

vec2 surfaceGradient(vec2 uv)
{
  return surfaceSlope(uv, false);
}

vec2 surfaceFacet(vec2 uv)
{
  return surfaceSlope(uv, true);
}

#ifdef MESO_FILTER
uniform vec2 mesoRootMeanSquareSlope; // of the map, along u and v: height per map coordinate

// How far a relief may be averaged, 1 to 0: of steep walls one sees the front and not the back, so that
// their mean is another picture.
float gentleness(MesoFragment f)
{
  vec2 slopes = length(f.PerDepth) * mesoRootMeanSquareSlope /
    max(vec2(length(f.PerMapU), length(f.PerMapV)), 1.0e-30);
  return 1.0 - smoothstep(0.75, 1.5, length(slopes));
}

// The level to draw, for the steps of the base mesh's map coordinate from a pixel to its neighbours: that
// whose texels are half as large as pixels, by their areas; 0 where the map's own are larger than that.
float levelOfPixel(MesoFragment f, vec2 mapDx, vec2 mapDy)
{
  vec2 size = vec2(mapSize());
  float texels = abs(mapDx.x * mapDy.y - mapDx.y * mapDy.x) * size.x * size.y;
  float level = gentleness(f) * (0.5 * log2(max(texels, 4.0)) - 1.0);
#ifdef MESO_CONE_LEVELS
  level = min(level, float(mesoLastLevel));
#endif
  return level < 30.0 ? level : 0.0; // else not a number: there is no map
}
#endif

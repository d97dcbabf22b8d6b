// The surface that the relief techniques draw of a height map. Stands on Kernels/HeightBilinear or
// Kernels/HeightBicubic and, with MESO_FILTER, on Common/HeightLevels, Kernels/LevelChoice and
// Kernels/RoughRelief.
//   MESO_FILTER   where texels are smaller than pixels, rays meet the heights of a level of the map's pyramid,
//                 and the slopes of a level are shaded, which need not be the same one; what that lacks shades as
//                 a rough surface
//   MESO_CONE_LEVELS   the levels that rays meet are those of Kernels/HeightLevels, exactly

// What searches look for.
float surfaceHeight(vec2 uv)
{
#if defined(MESO_CONE_LEVELS)
  return heightOfLevel(uv, mesoSearchedLevel);
#elif defined(MESO_FILTER)
  // All at once, as a branch costs both sides on some devices; the map is read at its corner where it does not
  // count.
  bool isMap = mesoSearchedLevel == 0;
  float ofMap = mapHeight(isMap ? uv : vec2(0.0));
  float ofLevel = filteredHeight(uv, float(max(mesoSearchedLevel, 1)));
  return isMap ? ofMap : ofLevel;
#else
  return mapHeight(uv);
#endif
}

// dh/du, dh/dv of what searches look for.
vec2 searchedSlope(vec2 uv)
{
#ifdef MESO_FILTER
  bool isMap = mesoSearchedLevel == 0;
  vec2 ofMap = mapFacet(isMap ? uv : vec2(0.0));
  vec2 ofLevel = gradientOfLevel(uv, float(max(mesoSearchedLevel, 1)));
  return isMap ? ofMap : ofLevel;
#else
  return mapFacet(uv);
#endif
}

// A texel of it, in map coordinates.
vec2 searchedTexel()
{
#ifdef MESO_FILTER
  return 1.0 / vec2(mapSize() >> mesoSearchedLevel);
#else
  return 1.0 / vec2(mapSize());
#endif
}

// dh/du, dh/dv that are shaded: of the facet, or of the shading normal.
vec2 surfaceSlope(vec2 uv, bool ofFacet)
{
#ifdef MESO_FILTER
  vec2 place = mesoShadedLevel < 1.0 ? uv : vec2(0.0);
  vec2 ofMap = ofFacet ? mapFacet(place) : mapGradient(place);
  return mix(ofMap, gradientOfLevel(uv, max(mesoShadedLevel, 1.0)), min(mesoShadedLevel, 1.0));
#else
  return ofFacet ? mapFacet(uv) : mapGradient(uv);
#endif
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
uniform vec2 mesoSlopesLost[ComparedLevels]; // as Kernels/LevelChoice has them
uniform vec2 mesoRoughnessOfLevels[ComparedLevels];
uniform int mesoLastLevel; // of the pyramid
vec2 mesoRoughness;        // variances of the slopes along u and v, object space, that shade as a rough surface
float mesoRoughShare;      // how much that is of what the shaded level lacks

void forgetRoughness()
{
  mesoRoughness = vec2(0.0);
  mesoRoughShare = 0.0;
}

// For the steps of the base mesh's map coordinate from a pixel to its neighbours.
void chooseLevels(MesoFragment f, vec2 mapDx, vec2 mapDy)
{
  vec2 size = vec2(mapSize());
  vec2 perLength = dot(f.PerDepth, f.PerDepth) /
    max(vec2(dot(f.PerMapU, f.PerMapU), dot(f.PerMapV, f.PerMapV)), 1.0e-30);
  PixelLevels levels =
    levelsOfPixel(mapDx * size, mapDy * size, mesoSlopesLost, perLength, mesoLastLevel);
  mesoSearchedLevel = levels.Searched;
  mesoShadedLevel = levels.Shaded;
  forgetRoughness();
  if (length(cross(f.PerDepth, f.PerMapU)) > 0.0) // else the frame below has no axes
  {
    mesoRoughness =
      roughnessOfLevel(levels.Shaded, mesoSlopesLost, mesoRoughnessOfLevels, perLength);
    float lacking = dot(betweenLevels(levels.Shaded, mesoSlopesLost), perLength);
    mesoRoughShare = min((mesoRoughness.x + mesoRoughness.y) / max(lacking, 1.0e-20), 1.0);
  }
}

// A direction in the frame of the base: along u, across it, along its normal.
vec3 directionOverBase(MesoFragment f, vec3 directionVC)
{
  vec3 normal = normalize(-f.PerDepth);
  vec3 along = normalize(f.PerMapU - dot(normal, f.PerMapU) * normal);
  return vec3(
    dot(along, directionVC), dot(cross(normal, along), directionVC), dot(normal, directionVC));
}

bool isAveraged()
{
  return mesoRoughness.x + mesoRoughness.y > 0.0;
}

// The slope over the base of what has this normal.
vec2 slopeOfNormal(MesoFragment f, vec3 normalVC)
{
  vec3 normal = directionOverBase(f, normalVC);
  return -normal.xy / max(normal.z, 1.0e-3);
}

// What a light gives to the relief, of which normalVC is the mean.
float averagedCosine(vec3 normalVC, vec3 lightOutVC)
{
#ifdef MESO_SHADING
  if (isAveraged())
  {
    return meanCosine(directionOverBase(mesoFragment, -mesoFragment.ViewVC),
      directionOverBase(mesoFragment, lightOutVC), slopeOfNormal(mesoFragment, normalVC),
      mesoRoughness);
  }
#endif
  return dot(normalVC, lightOutVC);
}

// Whether some of what has been averaged away looks to a light that its mean does not look to.
bool averagedFaces(vec3 lightOutVC)
{
  return isAveraged() && dot(mesoFragment.NormalVC, lightOutVC) > 0.0;
}

// The share of a light that what has been averaged away does not block.
float averagedShare(MesoFragment f, vec3 normalVC, vec3 lightOutVC)
{
  return isAveraged() ? litShare(directionOverBase(f, -f.ViewVC),
                          directionOverBase(f, lightOutVC), slopeOfNormal(f, normalVC),
                          mesoRoughness)
                      : 1.0;
}
#endif

// What techniques that draw matter in prisms share once they have met it: its normals, and what light it
// blocks (Wang2004, section 3.2). Stands on Common/PrismAccess. The technique itself defines the functions
// that are declared here.
//   MESO_SHELL_ENDS  the shell has edges, where light leaves it by a side

// Change of the distance to matter over texture space, for shading, and that of the very voxel.
vec3 matterGradient(vec3 place);
vec3 facetGradient(vec3 place);
// Whether matter lies on the straight way from a place on its surface.
bool matterBlocks(vec3 from, vec3 span, out int fetches);

// Light that runs further than this many tiles along the shell before it leaves it is not followed on: the
// straight way in texture space stands for the curved one only near by. What blocks it from there on is in the
// shadow map.
const float MESO_MAX_SHADOW_TILES = 4.0;

Prism mesoPrism;
PrismChart mesoChart;
vec3 mesoPlace; // (b1, b2, z) of the hit
bool mesoAtCut; // the hit lies where the shell ends

// Normals of matter's own surface at the hit.
void takeMatterNormals(MesoFragment f, inout MesoSurfaceHit hit)
{
  vec3 place = chartPlace(mesoChart, mesoPlace);
  hit.NormalVC = viewNormal(prismNormal(mesoPrism, mesoPlace, vec3(0.0, 0.0, 1.0)), f.ViewVC);
  hit.FacetNormalVC = hit.NormalVC;
#ifdef MESO_SHADING
  hit.NormalVC = viewNormal(
    prismNormal(mesoPrism, mesoPlace, chartGradient(mesoChart, matterGradient(place))), f.ViewVC);
  hit.Fetches += 6;
  hit.TexelReads += 48;
#endif
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV) || defined(MESO_DIFFERENTIAL)
  hit.FacetNormalVC = viewNormal(
    prismNormal(mesoPrism, mesoPlace, chartGradient(mesoChart, facetGradient(place))), f.ViewVC);
#endif
#ifdef MESO_SELF_SHADOW
  hit.Fetches += 1;
  hit.TexelReads += 8;
#endif
}

#ifdef MESO_SHELL_ENDS
// Prisms that light is followed through to find that it leaves the shell.
const int MESO_MOST_LIT_PRISMS = 64;

// Where light from the hit leaves the shell by a side, at most `reach`.
float reachInShell(vec3 lightOutVC, float reach)
{
  vec3 origin = modelPointOf(mesoHitVC);
  vec3 direction = mesoViewToModel * lightOutVC;
  Prism prism = mesoPrism;
  PrismChart chart = mesoChart;
  float at = 0.0;
  for (int i = 0; i < MESO_MOST_LIT_PRISMS && at < reach; ++i)
  {
    PrismSpan span = prismSpan(prism, origin, direction, at);
    at = max(at, span.Leave);
    if (span.Exit < 2)
    {
      return reach;
    }
    if (((prism.Flags >> (span.Exit + 1)) & 1) != 0)
    {
      return min(at, reach);
    }
    int beyond = chart.Beyond[span.Exit - 2];
    if (beyond < 0)
    {
      return reach;
    }
    prism = fetchPrism(beyond, chart);
  }
  return reach;
}
#endif

// How far light is followed from the hit, and its way in texture space per length: straight, as over a flat
// base (Wang2004, section 3.2).
float lengthFollowed(vec3 lightOutVC, float lightDistance, out vec3 way)
{
  way = chartWay(mesoChart, prismRates(mesoPrism, mesoPlace, mesoViewToModel * lightOutVC));
  if (mesoAtCut)
  {
    return 0.0; // light leaves the shell here
  }
  float reach = lightDistance;
  if (way.z != 0.0)
  {
    reach = min(reach, ((way.z > 0.0 ? 1.0 : 0.0) - mesoPlace.z) / way.z);
  }
  float along = length(way.xy);
  if (along * reach > MESO_MAX_SHADOW_TILES)
  {
    reach = MESO_MAX_SHADOW_TILES / along;
  }
#ifdef MESO_SHELL_ENDS
  reach = reachInShell(lightOutVC, reach);
#endif
  return max(reach, 0.0);
}

float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
#ifdef MESO_SELF_SHADOW
  vec3 way;
  float reach = lengthFollowed(lightOutVC, lightDistance, way);
  if (reach > 0.0 && matterBlocks(chartPlace(mesoChart, mesoPlace), reach * way, fetches))
  {
    return 1.0;
  }
#endif
  return 0.0;
}

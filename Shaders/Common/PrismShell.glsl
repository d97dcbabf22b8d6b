// The contract of a technique for those that draw a shell of prisms: one fragment for each stretch of the
// ray in a prism, its entry where the prism's face looks to the eye. The way through the prism is taken
// as straight in texture space, or cut into several straight pieces (Wang2004, section 3.2). Stands on
// Common/PrismAccess. The technique itself defines the functions that are declared here.
//   MESO_SEGMENTS  straight pieces of a ray's way through a prism

// The first meeting with matter of a straight way in texture space, part in [0, 1]; at part 0 where it
// starts in matter.
VolumeHit meetMatter(vec3 from, vec3 span);
// Change of the distance to matter over texture space, for shading, and that of the very voxel.
vec3 matterGradient(vec3 place);
vec3 facetGradient(vec3 place);
// Whether matter lies on the straight way from a place on its surface.
bool matterBlocks(vec3 from, vec3 span, out int fetches);

// Light that runs further than this many tiles along the shell before it leaves it is not followed on: the
// straight way in texture space stands for the curved one only near by.
const float MESO_MAX_SHADOW_TILES = 4.0;

Prism mesoPrism;
PrismChart mesoChart;
vec3 mesoPlace; // (b1, b2, z) of the hit

// The stretch of the fragment's ray that it answers for; Leave < Enter where it answers for none.
PrismSpan stretchOfFragment(MesoFragment f, bool frontFacing)
{
  PrismSpan span =
    prismSpan(mesoPrism, modelPointOf(f.PositionVC), mesoViewToModel * f.ViewVC, 0.0);
  float nearest = (-mesoNearVC - f.PositionVC.z) / min(f.ViewVC.z, -1.0e-6);
  // Where the eye is inside the prism no face looks to it; then the ray's exit answers.
  bool eyeInside = span.Enter < nearest;
  if (!frontFacing && !eyeInside)
  {
    span.Leave = span.Enter - 1.0;
  }
  if (eyeInside)
  {
    span.Enter = nearest;
    span.Face = -1;
  }
  return span;
}

// Whether the shell is cut open where the ray came in: matter that is met there shows its cut.
bool entersByCut(PrismSpan span)
{
  return span.Face >= 0 && (span.Face < 2 || ((mesoPrism.Flags >> (span.Face + 1)) & 1) != 0);
}

void takeNormals(MesoFragment f, PrismSpan span, bool atStart, inout MesoSurfaceHit hit)
{
  vec3 place = chartPlace(mesoChart, mesoPlace);
  if (atStart && span.Face < 0)
  {
    hit.NormalVC = -f.ViewVC;
    hit.FacetNormalVC = -f.ViewVC;
    return;
  }
  if (atStart && entersByCut(span))
  {
    hit.NormalVC = viewNormal(prismFaceNormal(mesoPrism, span.Face, mesoPlace), f.ViewVC);
    hit.FacetNormalVC = hit.NormalVC;
    return;
  }
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

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  hit.Found = false;
  mesoPrism = fetchPrism(int(mesoPrismVSOutput + 0.5), mesoChart);
  PrismSpan span = stretchOfFragment(f, gl_FrontFacing);
  if (span.Leave < span.Enter)
  {
    return hit;
  }
  vec3 origin = modelPointOf(f.PositionVC);
  vec3 direction = mesoViewToModel * f.ViewVC;
  float start = span.Enter;
  vec3 before =
    prismPlace(mesoPrism, origin + start * direction, vec3(1.0 / 3.0, 1.0 / 3.0, 0.5));
  for (int i = 1; i <= MESO_SEGMENTS; ++i)
  {
    float end = mix(span.Enter, span.Leave, float(i) / float(MESO_SEGMENTS));
    vec3 after = prismPlace(mesoPrism, origin + end * direction, before);
    vec3 from = chartPlace(mesoChart, before);
    VolumeHit found = meetMatter(from, chartWay(mesoChart, after - before));
    hit.Fetches += found.Fetches;
    hit.TexelReads += 8 * found.Fetches;
    hit.Iterations += found.Steps;
    if (found.Found)
    {
      hit.Found = true;
      hit.RayLength = mix(start, end, found.Part);
      mesoPlace = mix(before, after, found.Part);
      hit.MapCoord = chartPlace(mesoChart, mesoPlace).xy;
      hit.Relief = clamp(1.0 - mesoPlace.z, 0.0, 1.0);
      takeNormals(f, span, i == 1 && found.Part == 0.0, hit);
      return hit;
    }
    start = end;
    before = after;
  }
  return hit;
}

// The way of light in texture space is taken as straight, as over a flat base (Wang2004, section 3.2).
float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
  if (!(dot(hit.FacetNormalVC, lightOutVC) > 0.0))
  {
    return 1.0;
  }
#ifdef MESO_SELF_SHADOW
  vec3 way = chartWay(mesoChart, prismRates(mesoPrism, mesoPlace, mesoViewToModel * lightOutVC));
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
  if (reach > 0.0 && matterBlocks(chartPlace(mesoChart, mesoPlace), reach * way, fetches))
  {
    return 1.0;
  }
#endif
  return 0.0;
}

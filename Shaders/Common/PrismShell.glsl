// The contract of a technique for those that draw a shell of prisms: one fragment for each stretch of the
// ray in a prism, its entry where the prism's face looks to the eye. The way through the prism is taken
// as straight in texture space, or cut into several straight pieces (Wang2004, section 3.2). Stands on
// Common/PrismMatter. The technique itself defines the function that is declared here.
//   MESO_SEGMENTS  straight pieces of a ray's way through a prism

// The first meeting with matter of a straight way in texture space, part in [0, 1]; at part 0 where it
// starts in matter.
VolumeHit meetMatter(vec3 from, vec3 span);

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
  mesoAtCut = atStart && entersByCut(span);
  if (mesoAtCut)
  {
    hit.NormalVC = viewNormal(prismFaceNormal(mesoPrism, span.Face, mesoPlace), f.ViewVC);
    hit.FacetNormalVC = hit.NormalVC;
  }
  else if (atStart && span.Face < 0)
  {
    hit.NormalVC = -f.ViewVC;
    hit.FacetNormalVC = -f.ViewVC;
  }
  else
  {
    takeMatterNormals(f, hit);
  }
}

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  hit.Found = false;
  mesoAtCut = false;
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

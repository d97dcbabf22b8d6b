// Mesostructure in a shell as a stack of slices along each prism (Meyer1998): a fragment lies on a slice, and is
// drawn where the volume is matter there. Between slices there is nothing: rays along them see through, and what
// is met is off by up to a slice. Stands on Common/SliceMatter.

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  mesoPrism = fetchPrism(int(mesoPrismVSOutput + 0.5), mesoChart);
  mesoAtCut = false;
  mesoPlace = prismPlace(mesoPrism, modelPointOf(f.PositionVC), vec3(1.0 / 3.0, 1.0 / 3.0, 0.5));
  vec3 place = chartPlace(mesoChart, mesoPlace);
  hit.Found = sampleVolume(place) <= 0.0;
  hit.Fetches = 1;
  hit.TexelReads = 8;
  hit.Iterations = 1;
  if (hit.Found)
  {
    hit.MapCoord = place.xy;
    hit.Relief = clamp(1.0 - mesoPlace.z, 0.0, 1.0);
    takeMatterNormals(f, hit);
  }
  return hit;
}

// Rays through a shell of prisms from prism to prism: only the outside of the shell is drawn, and a ray is
// followed from where it comes in through the prisms that lie beyond each other's fins. Stands on
// Common/PrismShell.

// Takes the prism in mesoPrism beyond the face by which a ray leaves (`onward`) or comes in; false where
// there is none. Both prisms have the planes of their fin to the last bit.
bool passFin(vec3 origin, vec3 direction, bool onward, inout PrismSpan span)
{
  int face = onward ? span.Exit : span.Face;
  int beyond = face < 2 ? -1 : mesoChart.Beyond[face - 2];
  if (beyond < 0)
  {
    return false;
  }
  float at = onward ? max(span.Enter, span.Leave) : min(span.Enter, span.Leave);
  mesoPrism = fetchPrism(beyond, mesoChart);
  span = prismSpan(mesoPrism, origin, direction, at);
  if (onward)
  {
    span.Enter = at;
  }
  else
  {
    span.Leave = at;
  }
  return true;
}

bool nextStretch(vec3 origin, vec3 direction, inout PrismSpan span)
{
  return passFin(origin, direction, true, span);
}

// Rays that come out of the shell by the back of a face are followed back to the near plane.
bool beginStretch(MesoFragment f, bool frontFacing, vec3 origin, vec3 direction,
  out PrismSpan span, inout vec3 place)
{
  mesoPrism = fetchPrism(int(mesoPrismVSOutput + 0.5), mesoChart);
  span = prismSpan(mesoPrism, origin, direction, 0.0);
  if (frontFacing)
  {
    return true;
  }
  float nearest = (-mesoNearVC - f.PositionVC.z) / min(f.ViewVC.z, -1.0e-6);
  for (int i = 0; i < MESO_MOST_PRISMS && span.Enter >= nearest; ++i)
  {
    if (!passFin(origin, direction, false, span))
    {
      return false;
    }
  }
  span.Enter = nearest;
  span.Face = -1;
  return span.Enter <= span.Leave;
}

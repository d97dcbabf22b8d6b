// Rays through a shell of prisms by each prism for itself: all faces are drawn, and where a ray leaves
// its prism comes out of the distances that the vertices have to the planes of its faces, interpolated over the
// face that is drawn (Wang2004, sections 3.2 and 4.2). Stands on Common/PrismShell.

bool nextStretch(vec3 origin, vec3 direction, inout PrismSpan span)
{
  return false;
}

// Vertices say nothing of a ray that begins in the prism: there its exact stretch is taken.
bool beginStretch(MesoFragment f, bool frontFacing, vec3 origin, vec3 direction,
  out PrismSpan span, inout vec3 place)
{
  mesoPrism = fetchPrism(int(mesoPrismVSOutput + 0.5), mesoChart);
  if (!frontFacing)
  {
    float nearest = (-mesoNearVC - f.PositionVC.z) / min(f.ViewVC.z, -1.0e-6);
    span = prismSpan(mesoPrism, origin, direction, 0.0);
    bool begins = span.Enter < nearest;
    span.Enter = nearest;
    span.Face = -1;
    return begins;
  }
  place = prismPlace(mesoPrism, origin, place);
  span.Enter = 0.0;
  span.Leave = leaveByExits(mesoPrism, mesoLowerExitsVSOutput, mesoUpperExitsVSOutput);
  span.Face = nearestFace(place);
  span.Exit = 0;
  return true;
}

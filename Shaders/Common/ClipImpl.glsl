  vec2 mesoKept = keptStretch(mesoFragment.PositionVC, mesoFragment.ViewVC);
  if (mesoHit.RayLength < mesoKept.x || mesoHit.RayLength > mesoKept.y)
  {
    discard;
  }

#ifdef MESO_CASTER
  // Light that comes in from behind an open mesh leaves the shell here: it is followed back.
  mesoFragment = makeFragment(cameraParallel != 0, true);
  mesoFragment.ViewVC *= gl_FrontFacing ? 1.0 : -1.0;
#else
  mesoFragment = makeFragment(cameraParallel != 0, gl_FrontFacing);
#endif
#ifdef MESO_CLIPPED
  vec2 mesoKept = keptStretch(mesoFragment.PositionVC, mesoFragment.ViewVC);
  mesoFragment.RayStart = max(mesoKept.x, 0.0);
#endif
#if defined(MESO_CAST_SHADOW) && !defined(MESO_PRISMS)
  // Its derivatives are undefined once a miss has discarded a fragment.
  mesoFacetVC = facetOf(mesoFragment.PositionVC, mesoFragment.NormalVC);
#endif
#ifdef MESO_FILTER
  chooseLevels(mesoFragment, dFdx(mesoFragment.MapCoord), dFdy(mesoFragment.MapCoord));
#endif
  mesoHit = traceSurface(mesoFragment);
#ifdef MESO_DIFFERENTIAL
  setStepsOverMap();
#endif
#ifdef MESO_NORMAL_MAP
  mapNormal(mesoFragment, mesoHit); // has derivatives: before anything is discarded
#endif
#ifdef MESO_CLIPPED
  mesoHit.Found =
    mesoHit.Found && mesoHit.RayLength >= mesoKept.x && mesoHit.RayLength <= mesoKept.y;
#endif
  if (!mesoHit.Found)
  {
    discard;
  }
  mesoHitVC = mesoFragment.PositionVC + mesoHit.RayLength * mesoFragment.ViewVC;
#ifdef MESO_LIT
  vertexVC = vec4(mesoHitVC, 1.0);
#endif

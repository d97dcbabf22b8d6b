  mesoFragment = makeFragment(cameraParallel != 0, gl_FrontFacing);
  mesoHit = traceSurface(mesoFragment);
  if (!mesoHit.Found)
  {
    discard;
  }
  mesoHitVC = mesoFragment.PositionVC + mesoHit.RayLength * mesoFragment.ViewVC;
#ifdef MESO_LIT
  vertexVC = vec4(mesoHitVC, 1.0);
#endif

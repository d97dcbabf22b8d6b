  mesoRaysAreParallel = cameraParallel != 0;
  mesoPositionDx = dFdx(mesoPositionVCVSOutput);
  mesoPositionDy = dFdy(mesoPositionVCVSOutput);
  mesoMapDx = dFdx(mesoTCoordVSOutput) * mesoTiles;
  mesoMapDy = dFdy(mesoTCoordVSOutput) * mesoTiles;
#ifdef MESO_DISPLACED
  mesoReliefPerPixel = vec2(dFdx(mesoReliefVSOutput), dFdy(mesoReliefVSOutput));
#endif

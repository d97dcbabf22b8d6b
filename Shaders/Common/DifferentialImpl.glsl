  mesoRaysAreParallel = cameraParallel != 0;
  mesoPositionDx = dFdx(mesoPositionVCVSOutput);
  mesoPositionDy = dFdy(mesoPositionVCVSOutput);
#ifdef MESO_DISPLACED
  mesoReliefPerPixel = vec2(dFdx(mesoReliefVSOutput), dFdy(mesoReliefVSOutput));
#endif

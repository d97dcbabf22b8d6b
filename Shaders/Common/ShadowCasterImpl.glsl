#ifdef MESO_SURFACE
  float mesoCasterDepth = -mesoHitVC.z;
#else
  float mesoCasterDepth = cameraParallel != 0
    ? mix(mesoCasterRange.x, mesoCasterRange.y, gl_FragCoord.z)
    : 1.0 / gl_FragCoord.w;
#endif
  gl_FragData[0] = vec4(mesoCasterDepth, mesoCaster, 0.0, 0.0);

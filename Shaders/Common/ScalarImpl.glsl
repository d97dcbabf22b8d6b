#ifdef MESO_SCALAR_TEXTURE
  setScalarSlope(vec4(dFdx(tcoordVCVSOutput.s)), vec4(dFdy(tcoordVCVSOutput.s)));
#else
  setScalarSlope(dFdx(vertexColorVSOutput), dFdy(vertexColorVSOutput));
#endif

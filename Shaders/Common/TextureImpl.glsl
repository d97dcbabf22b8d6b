  mesoTextureDx = dFdx(tcoordVCVSOutput);
  mesoTextureDy = dFdy(tcoordVCVSOutput);

  mesoPositionVCVSOutput = (mesoMCVCMatrix * vertexMC).xyz;
  mesoTCoordVSOutput = mesoTCoord;
  mesoNormalVCVSOutput = mesoNormalMatrix * mesoNormal;
#ifdef MESO_DISPLACED
  mesoReliefVSOutput = mesoRelief;
#endif
#ifdef MESO_FRAME
  mesoNormalMCVSOutput = mesoNormal;
  mesoPerTCoordUVSOutput = mesoModelToView * (mesoTileScale.x * mesoTangent);
  mesoPerTCoordVVSOutput = mesoModelToView * (mesoTileScale.y * mesoBitangent);
#endif

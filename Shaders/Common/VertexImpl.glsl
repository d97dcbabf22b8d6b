  mesoPositionVCVSOutput = (mesoMCVCMatrix * vertexMC).xyz;
  mesoTCoordVSOutput = mesoTCoord;
  mesoNormalVCVSOutput = mesoNormalMatrix * mesoNormal;
#ifdef MESO_DISPLACED
  mesoReliefVSOutput = mesoRelief;
#endif
#ifdef MESO_PRISMS
  mesoPrismVSOutput = mesoPrism;
#ifdef MESO_EXITS
  PrismChart mesoChart;
  Prism mesoOwnPrism = fetchPrism(int(mesoPrism + 0.5), mesoChart);
  vec3 mesoViewVC =
    cameraParallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(mesoPositionVCVSOutput);
  prismExits(mesoOwnPrism, modelPointOf(mesoPositionVCVSOutput), mesoViewToModel * mesoViewVC,
    mesoLowerExitsVSOutput, mesoUpperExitsVSOutput);
#endif
#endif
#ifdef MESO_FRAME
#ifdef MESO_DICED
  mesoNormalMCVSOutput = mesoBaseNormal;
#else
  mesoNormalMCVSOutput = mesoNormal;
#endif
  mesoPerTCoordUVSOutput = mesoModelToView * (mesoTileScale.x * mesoTangent);
  mesoPerTCoordVVSOutput = mesoModelToView * (mesoTileScale.y * mesoBitangent);
#endif
#ifdef MESO_NORMAL_TANGENT
  mesoTileScaleVSOutput = mesoTileScale;
#endif
#ifdef MESO_CURVATURE
  mesoQuadricVSOutput =
    quadricOverTexture(mesoQuadric, mesoTangent, mesoBitangent, mesoNormal, mesoTileScale);
  mesoMetricVSOutput = vec3(mesoTileScale.x * mesoTileScale.x,
    mesoTileScale.x * mesoTileScale.y * dot(mesoTangent, mesoBitangent),
    mesoTileScale.y * mesoTileScale.y);
#ifdef MESO_CURVATURE_AT_VERTEX
  mesoViewCurvatureVSOutput =
    viewCurvature(mesoPositionVCVSOutput, mesoPerTCoordUVSOutput, mesoPerTCoordVVSOutput,
      mesoModelToView * (-mesoScale * normalize(mesoNormal)), mesoQuadricVSOutput);
#endif
#endif

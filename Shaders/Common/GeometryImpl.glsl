#ifdef MESO_DICED
    mesoCellGSOutput = mesoCellVSOutput[i];
#endif
#ifdef MESO_SURFACE
    mesoPositionVCGSOutput = mesoPositionVCVSOutput[i];
    mesoTCoordGSOutput = mesoTCoordVSOutput[i];
    mesoNormalVCGSOutput = mesoNormalVCVSOutput[i];
#ifdef MESO_DISPLACED
    mesoReliefGSOutput = mesoReliefVSOutput[i];
#endif
#ifdef MESO_PRISMS
    mesoPrismGSOutput = mesoPrismVSOutput[i];
#ifdef MESO_EXITS
    mesoLowerExitsGSOutput = mesoLowerExitsVSOutput[i];
    mesoUpperExitsGSOutput = mesoUpperExitsVSOutput[i];
#endif
#endif
#ifdef MESO_FRAME
    mesoNormalMCGSOutput = mesoNormalMCVSOutput[i];
    mesoPerTCoordUGSOutput = mesoPerTCoordUVSOutput[i];
    mesoPerTCoordVGSOutput = mesoPerTCoordVVSOutput[i];
#endif
#ifdef MESO_NORMAL_TANGENT
    mesoTileScaleGSOutput = mesoTileScaleVSOutput[i];
#endif
#ifdef MESO_CURVATURE
    mesoQuadricGSOutput = mesoQuadricVSOutput[i];
    mesoMetricGSOutput = mesoMetricVSOutput[i];
#ifdef MESO_CURVATURE_AT_VERTEX
    mesoViewCurvatureGSOutput = mesoViewCurvatureVSOutput[i];
#endif
#endif
#endif

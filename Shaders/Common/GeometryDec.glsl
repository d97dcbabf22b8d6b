// Geometry stage (edges, wide lines): hands the vertices' outputs on.
#ifdef MESO_DICED
flat in int mesoCellVSOutput[];
flat out int mesoCellGSOutput;
#endif
#ifdef MESO_SURFACE
in vec3 mesoPositionVCVSOutput[];
in vec2 mesoTCoordVSOutput[];
in vec3 mesoNormalVCVSOutput[];
out vec3 mesoPositionVCGSOutput;
out vec2 mesoTCoordGSOutput;
out vec3 mesoNormalVCGSOutput;
#ifdef MESO_DISPLACED
in float mesoReliefVSOutput[];
out float mesoReliefGSOutput;
#endif
#ifdef MESO_PRISMS
flat in float mesoPrismVSOutput[];
flat out float mesoPrismGSOutput;
#ifdef MESO_EXITS
in vec4 mesoLowerExitsVSOutput[];
in vec4 mesoUpperExitsVSOutput[];
out vec4 mesoLowerExitsGSOutput;
out vec4 mesoUpperExitsGSOutput;
#endif
#endif
#ifdef MESO_FRAME
in vec3 mesoNormalMCVSOutput[];
in vec3 mesoPerTCoordUVSOutput[];
in vec3 mesoPerTCoordVVSOutput[];
out vec3 mesoNormalMCGSOutput;
out vec3 mesoPerTCoordUGSOutput;
out vec3 mesoPerTCoordVGSOutput;
#endif
#ifdef MESO_NORMAL_TANGENT
in vec2 mesoTileScaleVSOutput[];
out vec2 mesoTileScaleGSOutput;
#endif
#ifdef MESO_CURVATURE
in vec3 mesoQuadricVSOutput[];
in vec3 mesoMetricVSOutput[];
out vec3 mesoQuadricGSOutput;
out vec3 mesoMetricGSOutput;
#ifdef MESO_CURVATURE_AT_VERTEX
in float mesoViewCurvatureVSOutput[];
out float mesoViewCurvatureGSOutput;
#endif
#endif
#endif

// Vertex stage: what the fragments need, in view coordinates (VC).
//   MESO_FRAME      the technique uses the tangent frame of the vertex
//   MESO_CURVATURE  and its quadric
//   MESO_DISPLACED  the mesh itself is the detail
//   MESO_PRISMS     the mesh is a shell of prisms
//   MESO_EXITS      and a vertex finds how far the planes of its prism are
//   MESO_DICED      the technique places the vertices: what else are attributes are its variables
#ifndef MESO_DICED
in vec2 mesoTCoord;
in vec3 mesoNormal;
#ifdef MESO_DISPLACED
in float mesoRelief; // depth in [0,1]
#endif
#ifdef MESO_FRAME
in vec3 mesoTangent;
in vec3 mesoBitangent;
in vec2 mesoTileScale;
#endif
#endif
uniform mat4 mesoMCVCMatrix;
uniform mat3 mesoNormalMatrix;
out vec3 mesoPositionVCVSOutput;
out vec2 mesoTCoordVSOutput;
out vec3 mesoNormalVCVSOutput;
#ifdef MESO_DISPLACED
out float mesoReliefVSOutput;
#endif
#ifdef MESO_PRISMS
in float mesoPrism; // number of the prism
flat out float mesoPrismVSOutput;
#ifdef MESO_EXITS
out vec4 mesoLowerExitsVSOutput; // Kernels/Prism, prismExits
out vec4 mesoUpperExitsVSOutput;
#endif
#endif
#ifdef MESO_FRAME
uniform mat3 mesoModelToView; // linear part of model to view, without the buffer's own scale
out vec3 mesoNormalMCVSOutput;
out vec3 mesoPerTCoordUVSOutput; // dp/du and dp/dv in VC, per unit of the mesh's own coordinate
out vec3 mesoPerTCoordVVSOutput;
#endif
#ifdef MESO_NORMAL_TANGENT
out vec2 mesoTileScaleVSOutput;
#endif
#ifdef MESO_CURVATURE
in vec3 mesoQuadric;
out vec3 mesoQuadricVSOutput; // over the mesh's own coordinate, object units: Kernels/Quadric
out vec3 mesoMetricVSOutput;  // |dp/du|^2, dp/du . dp/dv, |dp/dv|^2, object units
#endif

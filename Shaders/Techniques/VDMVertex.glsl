// View-dependent displacement mapping, the vertex stage: curvatures along the vertices' own view rays, as in
// the paper (Wang2003, section 3.2). Stands on Kernels/Frame and Kernels/Quadric.
uniform int cameraParallel;
uniform vec2 mesoTiles;
uniform float mesoScale;    // D in object units
uniform float mesoVDMDepth; // of the relief, in tiles
out float mesoViewCurvatureVSOutput; // 1 / tile

// As Techniques/VDM has it at a pixel. perTCoordU, perTCoordV, perDepth: the frame in view coordinates, over
// the mesh's own coordinate, and the relief's way down; quadric: over that coordinate, in object units.
// Along the normal, where there is no direction, 0.
float viewCurvature(vec3 positionVC, vec3 perTCoordU, vec3 perTCoordV, vec3 perDepth, vec3 quadric)
{
  vec3 viewVC = cameraParallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(positionVC);
  vec3 rate;
  if (!solveFrame(perTCoordU / mesoTiles.x, perTCoordV / mesoTiles.y, perDepth, viewVC, rate))
  {
    return 0.0;
  }
  float over = length(rate.xy);
  if (!(over > 1.0e-6 * abs(rate.z)))
  {
    return 0.0;
  }
  return 2.0 * mesoVDMDepth * quadricDepth(quadric, rate.xy / over / mesoTiles) / mesoScale;
}

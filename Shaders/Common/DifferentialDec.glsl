// How the hit moves from a pixel to the next, from the surface that was hit: the rays of the
// neighbouring pixels meet the plane of its facet. Differences between the hits of neighbours would
// jump wherever one of them sees another part of the relief.
//   MESO_DIFFERENTIAL  these chunks are in the shader
//   MESO_DISPLACED     the mesh itself is the detail: its own derivatives are continuous
//   MESO_SURFACE_HEIGHTS, MESO_OCCLUSION  the hit lies on a relief, else on or near the base mesh, whose own
//                      derivatives are continuous

// A facet seen flatter than this sine is taken as this steep: its numbers would have no end.
const float MESO_LEAST_SLANT = 0.02;

bool mesoRaysAreParallel;
vec3 mesoPositionDx; // of the fragment, VC
vec3 mesoPositionDy;
#ifdef MESO_DISPLACED
vec2 mesoReliefPerPixel; // change of depth to the right and up
#endif

#if defined(MESO_SURFACE_HEIGHTS) && defined(MESO_OCCLUSION)
// Step on the facet's plane from the hit to where the ray of the neighbouring pixel meets it, for
// the step on the base mesh between the two pixels' fragments.
vec3 stepOnFacet(vec3 baseStepVC)
{
  vec3 view = mesoFragment.ViewVC;
  // Parallel rays move aside as their fragments do, others by their share of the distance.
  vec3 across = baseStepVC - dot(baseStepVC, view) * view;
  float fragmentDistance = length(mesoFragment.PositionVC);
  if (!mesoRaysAreParallel && fragmentDistance > 0.0)
  {
    across = across * (1.0 + mesoHit.RayLength / fragmentDistance);
  }
  vec3 normal = mesoHit.FacetNormalVC;
  float slant = min(dot(normal, view), -MESO_LEAST_SLANT);
  return across - dot(normal, across) / slant * view;
}

// The same step over the map; 0 where the relief has no frame.
vec2 stepOverMap(vec3 baseStepVC)
{
  vec3 stepTS;
  solveFrame(mesoFragment.PerMapU, mesoFragment.PerMapV, mesoFragment.PerDepth,
    stepOnFacet(baseStepVC), stepTS);
  return stepTS.xy;
}
#endif

// To be called once the hit is known; until then they are the base mesh's own.
void setStepsOverMap()
{
#if defined(MESO_SURFACE_HEIGHTS) && defined(MESO_OCCLUSION)
  mesoMapDx = stepOverMap(mesoPositionDx);
  mesoMapDy = stepOverMap(mesoPositionDy);
#endif
}

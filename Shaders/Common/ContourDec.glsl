// Contour lines of the height where the ray hit. Stands on Common/DifferentialDec and
// Kernels/Contour.
//   MESO_CONTOUR_HEIGHTS  number of lines given one by one; these chunks are in the shader
uniform vec3 mesoContourColor;
uniform float mesoContourWidth;   // pixels
uniform float mesoContourSpacing; // 0: only those given one by one
uniform float mesoContourOffset;
#if MESO_CONTOUR_HEIGHTS > 0
uniform float mesoContourHeights[MESO_CONTOUR_HEIGHTS];
#endif

// Change of the height over a pixel, across the contour lines.
float heightPerPixel()
{
#ifdef MESO_DISPLACED
  return length(mesoReliefPerPixel);
#else
  if (dot(mesoFragment.PerDepth, mesoFragment.NormalVC) > 0.0)
  {
    return 0.0; // seen from behind: the base mesh
  }
#ifdef MESO_SURFACE_HEIGHTS
  vec2 gradient = surfaceFacet(mesoHit.MapCoord);
#else
  vec2 gradient = patchGradient(mesoHit.MapCoord);
#endif
  return length(vec2(dot(gradient, mesoMapDx), dot(gradient, mesoMapDy)));
#endif
}

float contoursAtHit()
{
  float height = 1.0 - mesoHit.Relief;
  float perPixel = heightPerPixel();
  float covered = 0.0;
  if (mesoContourSpacing > 0.0)
  {
    covered =
      evenContours(height, perPixel, mesoContourSpacing, mesoContourOffset, mesoContourWidth);
  }
#if MESO_CONTOUR_HEIGHTS > 0
  for (int i = 0; i < MESO_CONTOUR_HEIGHTS; ++i)
  {
    covered = max(covered, oneContour(height, perPixel, mesoContourHeights[i], mesoContourWidth));
  }
#endif
  return covered;
}

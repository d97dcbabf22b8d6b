// Bump mapping: Blinn1978, as reviewed in Marschner2008 (Documentation/Techniques/References.md). What is
// drawn is the base mesh, and only its normal is that of the detail above each point. The slopes are
// central differences over one texel, or over one texel of the level of the map's pyramid whose texels
// are as large as pixels. Stands on Common/ReliefFrame.
//   MESO_HEIGHTS      there is a height map: Common/HeightAccess, Common/HeightLevels, Kernels/HeightField
// What blocks light: Common/HorizonLight.

#ifdef MESO_HEIGHTS
// The level whose texels are as large as this pixel's longer side on the map; 0 where they are larger.
float pixelLevel(vec2 mapCoord)
{
#ifdef MESO_AOV
  return 0.0; // numbers are those of the map itself
#else
  vec2 alongX = dFdx(mapCoord) * vec2(mapSize());
  vec2 alongY = dFdy(mapCoord) * vec2(mapSize());
  return max(0.0, 0.5 * log2(max(dot(alongX, alongX), dot(alongY, alongY))));
#endif
}

// (dh/du, dh/dv) at a level. Level 0 has weights of our own; the two agree there, since differences of
// bilinear heights one texel apart are the differences at the texels, interpolated.
vec2 filteredGradient(vec2 mapCoord, float level)
{
  if (!(level > 0.0))
  {
    return heightGradient(mapCoord);
  }
  return gradientOfLevel(mapCoord, level);
}
#endif

#ifdef MESO_OCCLUSION
void shiftByParallax(MesoFragment f, inout MesoSurfaceHit hit);
#endif
MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
#ifdef MESO_HEIGHTS
  float level = pixelLevel(f.MapCoord); // has derivatives: before anything branches
  if (seenFromBehind(f))
  {
    return hit;
  }
#ifdef MESO_OCCLUSION
  shiftByParallax(f, hit);
#endif
#if defined(MESO_AOV) || defined(MESO_HEIGHT_COLORS) || defined(MESO_CONTOUR_HEIGHTS)
  hit.Relief = 1.0 - bilinearHeight(hit.MapCoord); // known to nobody else, and no cost of the technique
#endif
#ifdef MESO_SHADING
  hit.NormalVC = normalOfCross(f, vec3(filteredGradient(hit.MapCoord, level), 1.0));
  hit.Fetches += 1;
  hit.TexelReads += 12;
#endif
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV)
  hit.FacetNormalVC = normalOfCross(f, vec3(patchGradient(hit.MapCoord), 1.0));
#endif
#ifdef MESO_SELF_SHADOW
  hit.Fetches += 1; // the facet's; AOVs alone do not count as cost
  hit.TexelReads += 4;
#endif
#endif
  return hit;
}

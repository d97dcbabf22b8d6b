// View-dependent displacement mapping: Wang2003 (Documentation/Techniques/References.md).
// Model: around the fragment the base is a circle in the plane of ray and normal, and a table tells where
// the ray meets the relief over it. Stands on Kernels/VDMTable, Kernels/Quadric, Common/VDMAccess.
// Completes Common/ReliefSurface.
//   MESO_CURVATURE       the base has the curvature of the vertices; without it, it is flat
//   MESO_SILHOUETTE      rays beyond the largest polar angle at which there is relief are not drawn
//   MESO_VDM_FLAT_SHADOW light comes out of a flat base, as in the paper
//   MESO_CURVATURE_AT_VERTEX  the view ray's has been found at the vertices, as in the paper
//   MESO_VDM_NEAREST     the largest angle is that of the nearest texel, as in the paper
//   MESO_FILTER          where texels are smaller than pixels, normals are those of a level of the map, and what that
//                        lacks shades as a rough surface, whose shadows take the place of the table's

#ifdef MESO_CURVATURE_AT_VERTEX
in float mesoViewCurvatureVSOutput; // Techniques/VDMVertex
#endif

// 1 / tile, of the base along a direction over the map: quadric z = c rho^2 / 2, in units of the depth.
float tableCurvature(MesoFragment f, VDMLayout table, vec2 over)
{
#ifdef MESO_CURVATURE
  return clamp(2.0 * table.Depth * quadricDepth(f.Quadric, over), table.FirstCurvature,
    table.LastCurvature);
#else
  return clamp(0.0, table.FirstCurvature, table.LastCurvature);
#endif
}

// The map's, whatever its level that is drawn: what is looked up is not averaged. A table's interpolation
// asks for no more than a sampler's.
float mapRelief(vec2 mapCoord)
{
  return 1.0 - filteredHeight(mapCoord, 0.0);
}

// What the table stores for a ray. Steeper ones than its first are between that and the normal, along which
// the map itself is the table.
float lookUp(VDMLayout table, vec2 mapCoord, VDMDirection ray, float curvature, inout int fetches)
{
  float stored = sampleVDM(mapCoord, ray, vdmCurvaturePlace(table, curvature), fetches);
  float steeper = vdmSteeper(table, ray.HalfTangent);
  if (steeper > 0.0)
  {
    VDMPoint below;
    below.Offset = 0.0;
    below.Depth = mapRelief(mapCoord) * table.Depth;
    below.RayLength = below.Depth;
    stored = mix(stored, vdmNumber(table, 0.0, 1.0, curvature, below) / table.Range, steeper);
    fetches += 1;
  }
  return stored;
}

// Is the ray flatter than all that meet the relief? Where the base is not convex none is.
bool missesRelief(
  MesoFragment f, VDMLayout table, VDMDirection ray, float curvature, inout int fetches)
{
  if (!(curvature > 0.0))
  {
    return false;
  }
#ifdef MESO_VDM_NEAREST
  vec2 mapCoord = (floor(f.MapCoord * mesoVDMTexels) + 0.5) / mesoVDMTexels;
#else
  vec2 mapCoord = f.MapCoord;
#endif
  float largest = VDMRightAngle *
    sampleMVM(mapCoord, ray.Turns, vdmCurvaturePlace(table, curvature), fetches);
  return ray.Cosine < cos(largest);
}

bool followRay(MesoFragment f, inout MesoSurfaceHit hit)
{
  VDMLayout table = vdmTable();
  vec3 rate; // of u, v and depth along the view ray
  if (!directionInTS(f, f.ViewVC, rate))
  {
    return false;
  }
  // Where the mesh's normal already looks away the ray is taken as one in the plane: the relief may rise to
  // the base itself.
  VDMDirection ray;
  float least = VDMLeastCosine * length(rate.xy) / table.Depth;
  if (!vdmDirection(vec3(rate.xy, max(rate.z, least)), table.Depth, ray))
  {
#ifdef MESO_SILHOUETTE
    hit.Found = false;
#endif
    return false;
  }
#ifdef MESO_CURVATURE_AT_VERTEX
  float curvature =
    clamp(mesoViewCurvatureVSOutput, table.FirstCurvature, table.LastCurvature);
#else
  float curvature = tableCurvature(f, table, ray.Over);
#endif
  float stored = lookUp(table, f.MapCoord, ray, curvature, hit.Fetches);
#ifdef MESO_SILHOUETTE
  if (missesRelief(f, table, ray, curvature, hit.Fetches))
  {
    hit.Found = false;
    return false;
  }
#endif
  VDMPoint point = vdmPoint(table, ray.Sine, ray.Cosine, curvature, stored);
  hit.RayLength = point.RayLength / ray.Length;
  hit.MapCoord = f.MapCoord + point.Offset * ray.Over;
  // As the map has it there, from where light is followed.
  hit.Relief = mapRelief(hit.MapCoord);
  hit.TexelReads = 8 * hit.Fetches + 4;
  hit.Fetches += 1;
  return true;
}

// Over the quadric's own frame at the hit.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  return normalOfCross(f,
    displacedCross(f.Quadric, f.Metric, hit.MapCoord - f.MapCoord, hit.Relief, gradient));
}

// How far along a ray, at least, what the table holds of the hit may lie before it, for a table of the
// facet's plane: rays are known to half a texel, linear between angles, and its numbers to twice their root
// mean square error.
float shadowTolerance(MesoFragment f, MesoSurfaceHit hit, VDMLayout table, VDMDirection into)
{
  vec2 slope = -table.Depth * patchGradient(hit.MapCoord); // of the facet's depth
  float along = dot(slope, into.Over);
  float across = into.Over.x * slope.y - into.Over.y * slope.x;
  // Depth that ray and facet gain on each other, a depth of the ray.
  float secant = 1.0 / into.Cosine;
  float tangent = into.Sine * secant;
  float closing = 1.0 / max(1.0 - along * tangent, 0.01); // the inverse
  float depth = hit.Relief * table.Depth;
  // Second derivatives of the ray's depth at the facet, of polar angle and azimuth.
  float ofPolar = abs(along) * closing * secant * secant;
  float ofAzimuth = across * tangent * closing;
  float polarBend = 2.0 * ofPolar * (tangent + ofPolar);
  float azimuthBend = abs(along) * tangent * closing + 2.0 * ofAzimuth * ofAzimuth;
  float polarStep = VDMRightAngle / float(table.Polars);
  float azimuthStep = VDMTurn / float(MESO_VDM_AZIMUTHS);
  float bent = 0.125 * depth *
    (polarStep * polarStep * polarBend + azimuthStep * azimuthStep * azimuthBend);
  float aside = dot(abs(slope), 0.5 / mesoVDMTexels) * closing;
  return (bent + aside + 2.0 * mesoVDMError) * secant;
}

// Light is looked up as a ray that comes in where it leaves the base, and is blocked where that ray meets
// the relief before the hit.
float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches)
{
  fetches = 0;
  VDMLayout table = vdmTable();
  float depth = max(hit.Relief + lift.z, 0.0) * table.Depth;
  vec2 start = hit.MapCoord + lift.xy;
#ifdef MESO_VDM_FLAT_SHADOW
  float slope = travel.z;
  float curvature = clamp(0.0, table.FirstCurvature, table.LastCurvature);
#else
  // In the frame of the base below the hit, which has turned since the fragment.
  float slope = travel.z - dot(quadricGradient(f.Quadric, hit.MapCoord - f.MapCoord), travel.xy);
  float curvature = tableCurvature(f, table, normalize(travel.xy + vec2(1.0e-20, 0.0)));
#endif
  float over = length(travel.xy);
  float rise = -slope * table.Depth;
  if (!(rise > 0.0) && !(curvature > 0.0 && over > 0.0))
  {
    return 1.0; // the light does not come out of the base
  }
  float size = length(vec2(over, rise));
  float sineOut;
  float cosineOut;
  VDMPoint way = vdmWayOut(curvature, depth, over / size, rise / size, sineOut, cosineOut);
  VDMDirection into; // from where it comes out
  if (!vdmDirection(vec3(-travel.xy / max(over, 1.0e-20) * sineOut, cosineOut), 1.0, into))
  {
    return 0.0;
  }
  float stored = lookUp(table, start - way.Offset * into.Over, into, curvature, fetches);
  float reached = vdmPoint(table, into.Sine, into.Cosine, curvature, stored).RayLength;
  float blocked = reached < way.RayLength - shadowTolerance(f, hit, table, into) ? 1.0 : 0.0;
#ifdef MESO_FILTER
  // The table knows what has been averaged away, which blocks light but once.
  blocked *= rise > 0.0 ? 1.0 - mesoRoughShare : 1.0;
#endif
  return blocked;
}

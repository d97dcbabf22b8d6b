// The contract between a technique and everything written once around it. All vectors are in view
// coordinates (VC), whose unit is the world's; map coordinates are the mesh's uv times tiles.
//   MESO_FRAME        the technique uses the tangent frame
//   MESO_QUADRIC      the technique bends its relief over a quadric
//   MESO_CURVATURE    the quadric is that of the vertices, else the tangent plane
//   MESO_DISPLACED    the mesh itself is the detail
//   MESO_PRISMS       the mesh is a shell of prisms
//   MESO_EXITS        whose vertices know how far the planes of its faces are along the view ray
//   MESO_OCCLUSION, MESO_SHADING, MESO_SELF_SHADOW, MESO_DEPTH   effects that are compiled in
//   MESO_CLIPPED      clipping planes cut the surface
//   MESO_NORMAL_MAP   a normal map gives the shading normal: Common/NormalMap
//   MESO_SURFACE_HEIGHTS  the technique draws the height map's surface: Common/HeightSurface
//   MESO_AOV          every pixel's hit is written out as numbers
//   MESO_DIFFERENTIAL how the hit moves from pixel to pixel is known: Common/DifferentialDec
//   MESO_FILTER       heights are averaged over what a pixel covers: Common/HeightSurface. Numbers and
//                     shadow maps are of the map itself
#if defined(MESO_AOV) || defined(MESO_CASTER)
#undef MESO_FILTER
#undef MESO_CONE_LEVELS
#endif
//   MESO_LIGHT_COUNT  number of lights that are on

// What the rasteriser knows of the base mesh at this fragment.
struct MesoFragment
{
  vec3 PositionVC;
  vec3 ViewVC;     // unit, from the eye into the scene
  vec3 NormalVC;   // unit, of the base mesh
  vec2 MapCoord;
  vec3 PerMapU;    // dp/du per unit of map coordinate
  vec3 PerMapV;    // dp/dv
  vec3 PerDepth;   // -D n: from depth 0 (the mesh) to depth 1 (the deepest point)
#ifdef MESO_CLIPPED
  float RayStart;  // length along the view ray up to which all is cut away, at least 0
#endif
#ifdef MESO_QUADRIC
  vec3 Quadric;    // the base below its tangent plane, depth over map coordinates: Kernels/Quadric
  vec3 Metric;     // its lengths there, in units of D
#endif
};

// What a technique found along the view ray.
struct MesoSurfaceHit
{
  bool Found;           // false: the ray misses the detail
  float RayLength;      // along the view ray from the fragment, so that the hit is on the pixel's ray
  vec2 MapCoord;
  float Relief;         // depth in [0,1]
  vec3 NormalVC;        // unit, for shading
  vec3 FacetNormalVC;   // unit, of the bilinear patch itself: which way the surface really faces
  int Fetches;          // filtered samples of the map
  int TexelReads;       // texels behind them
  int Iterations;       // steps of the view search
};

in vec3 mesoPositionVCVSOutput;
in vec2 mesoTCoordVSOutput;
in vec3 mesoNormalVCVSOutput;
uniform vec2 mesoTiles;
uniform mat3 mesoModelToView;  // of directions
uniform mat3 mesoNormalMatrix; // of normals, likewise
#ifdef MESO_DISPLACED
in float mesoReliefVSOutput;
#endif
#ifdef MESO_PRISMS
flat in float mesoPrismVSOutput;
#ifdef MESO_EXITS
in vec4 mesoLowerExitsVSOutput;
in vec4 mesoUpperExitsVSOutput;
#endif
#endif
#ifdef MESO_FRAME
in vec3 mesoNormalMCVSOutput;
in vec3 mesoPerTCoordUVSOutput;
in vec3 mesoPerTCoordVVSOutput;
uniform float mesoScale; // D in object units
#endif
#ifdef MESO_CURVATURE
in vec3 mesoQuadricVSOutput;
in vec3 mesoMetricVSOutput;
#endif

MesoFragment mesoFragment;
MesoSurfaceHit mesoHit;
vec3 mesoHitVC; // where the drawn surface is: on the relief with MESO_OCCLUSION
#ifdef MESO_DIFFERENTIAL
vec2 mesoMapDx; // step over the map from the hit to that of the pixel on the right, and above
vec2 mesoMapDy;
#endif

MesoFragment makeFragment(bool parallelProjection, bool frontFacing)
{
  MesoFragment f;
  f.PositionVC = mesoPositionVCVSOutput;
  f.ViewVC = parallelProjection ? vec3(0.0, 0.0, -1.0) : normalize(mesoPositionVCVSOutput);
  f.NormalVC = normalize(mesoNormalVCVSOutput);
  if (!frontFacing)
  {
    f.NormalVC = -f.NormalVC;
  }
  f.MapCoord = mesoTCoordVSOutput * mesoTiles;
  f.PerMapU = vec3(0.0);
  f.PerMapV = vec3(0.0);
  f.PerDepth = vec3(0.0);
#ifdef MESO_FRAME
  f.PerMapU = mesoPerTCoordUVSOutput / mesoTiles.x;
  f.PerMapV = mesoPerTCoordVVSOutput / mesoTiles.y;
  f.PerDepth = mesoModelToView * (-mesoScale * normalize(mesoNormalMCVSOutput));
#endif
#ifdef MESO_QUADRIC
  f.Quadric = vec3(0.0);
  f.Metric = vec3(0.0);
#ifdef MESO_CURVATURE
  if (mesoScale > 0.0)
  {
    vec2 perMap = 1.0 / mesoTiles;
    f.Quadric = mesoQuadricVSOutput * perMap.xyx * perMap.xyy / mesoScale;
    f.Metric = mesoMetricVSOutput * perMap.xxy * perMap.xyy / mesoScale / mesoScale;
  }
#endif
#endif
  return f;
}

// The base mesh itself as the hit: what is drawn where there is no relief to find.
MesoSurfaceHit baseSurface(MesoFragment f)
{
  MesoSurfaceHit hit;
  hit.Found = true;
  hit.RayLength = 0.0;
  hit.MapCoord = f.MapCoord;
  hit.Relief = 0.0;
  hit.NormalVC = f.NormalVC;
  hit.FacetNormalVC = f.NormalVC;
  hit.Fetches = 0;
  hit.TexelReads = 0;
  hit.Iterations = 0;
  return hit;
}

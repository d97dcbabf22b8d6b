#ifndef MesoOptions_h
#define MesoOptions_h

/**
 * @file MesoOptions.h
 * @brief The words that users choose from: techniques, qualities, effects, wraps.
 *
 * One struct of plain values, MesoMesostructureOptions, is what the scene file, the command line
 * and the mappers share. Every enumeration has its name as the scene file spells it, and back.
 */

#include "mesoCommonCoreModule.h" // for export macro

#include <array>   // for option values
#include <cstdint> // for the effect set
#include <optional>
#include <string>
#include <vector>

enum class MesoTechnique
{
  Plain,              ///< the base mesh, shaded
  Bump,               ///< the normal tilted by the map's slope (Blinn1978)
  Normal,             ///< a normal map in tangent space
  NormalObject,       ///< a normal map in object space
  Parallax,           ///< the map read aside by the view's slope, or by a march of few steps
  Horizon,            ///< bump with self-shadow from a horizon map (Max1988)
  Relief,             ///< relief mapping in the tangent plane (Oliveira2005, section 2.1)
  ReliefQuadric,      ///< over a quadric at each vertex, with outlines (Oliveira2005, section 3.2)
  ReliefQuadricExact, ///< the same by the distance to the quadric (Oliveira2005, section 3.1)
  VDM,                ///< a table of distances over view and curvature (Wang2003)
  GDM,                ///< a table of distances through a volume, in prisms (Wang2004)
  Slices,             ///< a stack of textured slices in each prism (Meyer1998)
  ShellSDF,           ///< sphere tracing of a volume's signed distance, in prisms
  Displacement,       ///< vertices of instanced grids moved in the vertex stage
  GeometryImage,      ///< the mesh as an image of positions, drawn as a regular grid
  Tessellated         ///< the mesh, diced and displaced: ordinary triangles
};

/// How finely a technique searches or dices; see MesoStepsOfQuality() and MesoFacetsPerTexel().
enum class MesoQuality
{
  Draft,
  Low,
  Medium,
  High,
  Certified, ///< a search that misses nothing of the technique's own model
  Full       ///< a table as it was baked, without the loss of its factors
};

/// How a ray's first meeting with a height map is looked for.
enum class MesoSearch
{
  LinearBinary, ///< equal steps, then halving (Oliveira2005, section 2.1)
  LinearSecant, ///< equal steps, then the secant through the bracket
  Cone,         ///< steps as far as a cone that is free of relief allows, then halving
  Certified     ///< through the maxima of the map, cell by cell, to the exact root
};

/// What a curved relief's base is taken for around a fragment.
enum class MesoCurvedKind
{
  Quadric,    ///< the vertices' quadric
  Bent,       ///< the surface's own frame, looked up again at each step (Chen2008)
  Osculating, ///< the circle of the ray's normal curvature
  Surface     ///< the mesh itself, looked up in an image of it over its texture coordinates
};

/// How `parallax` finds where in the map to read.
enum class MesoParallaxKind
{
  Occlusion, ///< equal steps along the view ray, then the straight line between the last two
  Offset     ///< a few steps along the view ray, each as far as the plane of the slope there
};

/// How a height map's surface runs between its texels.
enum class MesoInterpolation
{
  Bilinear, ///< through the texels, with an edge along each line of them
  Bicubic   ///< near the texels: their uniform cubic B-spline, smooth to its second derivatives
};

/// What is drawn of a relief whose texels are smaller than pixels.
enum class MesoFilter
{
  Auto, ///< heights averaged over what a pixel covers; numbers (AOVs) are of the map itself
  None  ///< the map itself: some texel of those that a pixel covers
};

/// Where `vdm` takes the curvature along a ray.
enum class MesoCurvatureAt
{
  Pixel, ///< of the vertices' quadrics, interpolated to the pixel
  Vertex ///< at the vertices, along their own rays, interpolated as a number (Wang2003)
};

/// Where a ray of the techniques in prisms leaves a prism.
enum class MesoExits
{
  Exact,       ///< computed for each pixel
  Interpolated ///< from distances to the faces' planes at the vertices, interpolated (Wang2004)
};

/// How the slices of `slices` lie.
enum class MesoStack
{
  Prism, ///< in each prism, parallel to its bottom and top (Meyer1998)
  Screen ///< parallel to the projection plane (Meyer1998)
};

/// What lies outside the map's [0,1] x [0,1].
enum class MesoWrap
{
  Repeat,
  Clamp,
  Mirror
};

/// The quadric z = a x^2 + b y^2 + c x y that `relief-quadric` bends its relief over.
enum class MesoQuadricKind
{
  Full,    ///< all three coefficients
  Diagonal ///< c = 0, fitted to one ring by the normal equations, as in Oliveira2005
};

/// What a technique can show. A set of them is a MesoEffects.
enum class MesoEffect : std::uint32_t
{
  Shading = 1u << 0,       ///< the fine normal is used
  Occlusion = 1u << 1,     ///< near detail hides far detail
  SelfShadow = 1u << 2,    ///< detail shades detail, for each light
  Depth = 1u << 3,         ///< the depth buffer is that of the detail
  Silhouette = 1u << 4,    ///< the outline shows the detail
  Curvature = 1u << 5,     ///< the ray is bent with the surface
  CastShadow = 1u << 6,    ///< detail casts shadows on other objects and takes theirs
  OpenBoundary = 1u << 7,  ///< detail is right at an open edge of the mesh
  NonHeightField = 1u << 8 ///< overhangs, holes, weaves, chains
};

/// A set of effects.
class MESOCOMMONCORE_EXPORT MesoEffects
{
public:
  MesoEffects() = default;
  MesoEffects(std::initializer_list<MesoEffect> effects);

  bool Has(MesoEffect effect) const { return (this->Bits & std::uint32_t(effect)) != 0; }
  void Set(MesoEffect effect, bool on);
  bool Empty() const { return this->Bits == 0; }
  bool operator==(const MesoEffects& other) const { return this->Bits == other.Bits; }
  bool operator!=(const MesoEffects& other) const { return this->Bits != other.Bits; }
  /// Those of this set that are not in `other`.
  MesoEffects Without(const MesoEffects& other) const;
  /// The names, in the order of the enumeration.
  std::vector<std::string> Names() const;

private:
  std::uint32_t Bits = 0;
};

/// Number of linear and of refining steps of a search: halvings, or half as many secants, rounded up.
struct MesoSearchSteps
{
  int Linear;
  int Binary;
};

///@{
/// The name as the scene file spells it, and back (empty where there is no such name).
MESOCOMMONCORE_EXPORT const char* MesoName(MesoTechnique value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoQuality value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoSearch value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoWrap value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoEffect value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoQuadricKind value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoCurvedKind value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoParallaxKind value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoInterpolation value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoFilter value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoCurvatureAt value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoExits value);
MESOCOMMONCORE_EXPORT const char* MesoName(MesoStack value);
MESOCOMMONCORE_EXPORT std::optional<MesoTechnique> MesoTechniqueFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoQuality> MesoQualityFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoSearch> MesoSearchFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoWrap> MesoWrapFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoEffect> MesoEffectFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoQuadricKind> MesoQuadricKindFromName(
  const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoCurvedKind> MesoCurvedKindFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoParallaxKind> MesoParallaxKindFromName(
  const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoInterpolation> MesoInterpolationFromName(
  const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoFilter> MesoFilterFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoCurvatureAt> MesoCurvatureAtFromName(
  const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoExits> MesoExitsFromName(const std::string& name);
MESOCOMMONCORE_EXPORT std::optional<MesoStack> MesoStackFromName(const std::string& name);
///@}

///@{
/// All names of a kind, for messages and help.
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoTechniqueNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoQualityNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoSearchNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoWrapNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoEffectNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoQuadricKindNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoCurvedKindNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoParallaxKindNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoInterpolationNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoFilterNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoCurvatureAtNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoExitsNames();
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoStackNames();
///@}

/// Steps of linear and binary search of a quality.
MESOCOMMONCORE_EXPORT MesoSearchSteps MesoStepsOfQuality(MesoQuality quality);

/// Steps of `parallax` along the view ray: those of kind Occlusion at a grazing view (a quarter of them
/// along the normal), and those of kind Offset.
struct MesoParallaxSteps
{
  int Occlusion;
  int Offset;
};

/// Steps of `parallax` of a quality: 8 and 1, 16 and 2, 32 and 3, 64 and 4.
MESOCOMMONCORE_EXPORT MesoParallaxSteps MesoParallaxStepsOfQuality(MesoQuality quality);

/// Directions around each texel that `horizon` has a horizon for: 8, 16, 32, 64.
MESOCOMMONCORE_EXPORT int MesoAzimuthsOfQuality(MesoQuality quality);

/// Whether qualities of a technique differ at all.
MESOCOMMONCORE_EXPORT bool MesoHasQualities(MesoTechnique technique);

/// Whether a technique draws a height map; the others have no use for one.
MESOCOMMONCORE_EXPORT bool MesoUsesHeightMap(MesoTechnique technique);

/// Whether a technique draws a volume of mesostructure; the others have no use for one.
MESOCOMMONCORE_EXPORT bool MesoUsesVolume(MesoTechnique technique);

/// Straight pieces that a ray's way through a prism may be cut into, at most.
constexpr int MesoMostSegments = 64;

/// Whether a technique's rays can look for the height map by each MesoSearch. The others have neither
/// the option Search nor the quality Certified.
MESOCOMMONCORE_EXPORT bool MesoHasSearches(MesoTechnique technique);

/// Whether a technique bends its relief over a quadric: ReliefQuadric and ReliefQuadricExact.
MESOCOMMONCORE_EXPORT bool MesoBendsRelief(MesoTechnique technique);

/// Facets along a texel's side, for techniques that dice: 1/4, 1/2, 1, 2.
MESOCOMMONCORE_EXPORT double MesoFacetsPerTexel(MesoQuality quality);

/// Pixels along a facet's side, for techniques that dice for the picture: 4, 2, 1, 1/2.
MESOCOMMONCORE_EXPORT double MesoFacetPixels(MesoQuality quality);

/// The effects that a technique can show.
MESOCOMMONCORE_EXPORT MesoEffects MesoEffectsOfTechnique(MesoTechnique technique);

/// "auto" (all that the technique provides), or exactly the set named.
struct MesoEffectChoice
{
  bool Auto = true;
  MesoEffects Named;
};

/**
 * How one actor's fine relief is drawn. Lengths are in object units (before the node's matrix).
 */
struct MesoMesostructureOptions
{
  MesoTechnique Technique = MesoTechnique::Plain;
  MesoQuality Quality = MesoQuality::Medium;
  MesoEffectChoice Effects;
  double Scale = 0.0;     ///< D: height of the relief, deepest point to highest, object units, >= 0
  double Reference = 1.0; ///< r, the height in [0,1] that lies on the mesh: 1 inward, 0 outward
  std::array<double, 2> Tiles = { 1., 1. }; ///< map coordinate = texture coordinate x Tiles
  MesoWrap Wrap = MesoWrap::Repeat;
  MesoQuadricKind Quadric = MesoQuadricKind::Full; ///< for the techniques that bend their relief
  MesoCurvedKind Curved = MesoCurvedKind::Quadric; ///< of ReliefQuadric
  std::optional<MesoSearch> Search;                ///< default: what the quality stands for
  MesoInterpolation Interpolation = MesoInterpolation::Bilinear; ///< of techniques with searches
  MesoFilter Filter = MesoFilter::Auto;                          ///< of techniques with searches
  MesoParallaxKind Parallax = MesoParallaxKind::Occlusion;
  /// Of `horizon`: degrees of the light's elevation over which the shadow's edge fades, >= 0.
  double Penumbra = 2.0;
  /// Factors that a table is summed from, for distances and for silhouettes; default: the quality's.
  std::optional<std::array<int, 2>> Rank;
  int Segments = 1; ///< straight pieces that a ray's way through a prism is cut into, >= 1
  MesoCurvatureAt CurvatureAt = MesoCurvatureAt::Pixel; ///< of VDM
  MesoExits Exits = MesoExits::Exact;                   ///< of GDM and ShellSDF
  MesoStack Stack = MesoStack::Prism;                   ///< of Slices
  /// Of techniques that dice on the GPU: pixels along a facet's side, >= 0; 0: texels alone decide;
  /// default: what the quality stands for.
  std::optional<double> FacetPixels;
};

/// Whether the relief's base is looked up in an image of the mesh (vtkMesoBaseImage).
MESOCOMMONCORE_EXPORT bool MesoNeedsBaseImage(const MesoMesostructureOptions& options);

/// The effects that are on: what is chosen, where "auto" means what the technique provides.
MESOCOMMONCORE_EXPORT MesoEffects MesoEffectsOn(const MesoMesostructureOptions& options);

/// The search that is used: what is named, else Certified at the quality Certified, else
/// LinearBinary.
MESOCOMMONCORE_EXPORT MesoSearch MesoSearchOf(const MesoMesostructureOptions& options);

/// Why technique, quality, search and interpolation do not go together; empty where they do. The quality
/// Certified is a search, so it takes no other beside it; the search Certified goes with each quality,
/// whose steps it has no use for.
MESOCOMMONCORE_EXPORT std::string MesoSearchProblem(const MesoMesostructureOptions& options);

#endif

#include "MesoOptions.h"

namespace
{
template <typename T>
struct Entry
{
  T Value;
  const char* Name;
};

constexpr Entry<MesoTechnique> Techniques[] = { { MesoTechnique::Plain, "plain" },
  { MesoTechnique::Bump, "bump" }, { MesoTechnique::Normal, "normal" },
  { MesoTechnique::NormalObject, "normal-object" }, { MesoTechnique::Parallax, "parallax" },
  { MesoTechnique::Horizon, "horizon" }, { MesoTechnique::Relief, "relief" },
  { MesoTechnique::ReliefQuadric, "relief-quadric" },
  { MesoTechnique::ReliefQuadricExact, "relief-quadric-exact" }, { MesoTechnique::VDM, "vdm" },
  { MesoTechnique::GDM, "gdm" }, { MesoTechnique::Slices, "slices" },
  { MesoTechnique::ShellSDF, "shell-sdf" }, { MesoTechnique::Displacement, "displacement" },
  { MesoTechnique::GeometryImage, "geometry-image" },
  { MesoTechnique::Tessellated, "tessellated" } };
constexpr Entry<MesoQuality> Qualities[] = { { MesoQuality::Draft, "draft" },
  { MesoQuality::Low, "low" }, { MesoQuality::Medium, "medium" }, { MesoQuality::High, "high" },
  { MesoQuality::Certified, "certified" }, { MesoQuality::Full, "full" } };
constexpr Entry<MesoSearch> Searches[] = { { MesoSearch::LinearBinary, "linear-binary" },
  { MesoSearch::LinearSecant, "linear-secant" }, { MesoSearch::Cone, "cone" },
  { MesoSearch::Certified, "certified" } };
constexpr Entry<MesoWrap> Wraps[] = { { MesoWrap::Repeat, "repeat" }, { MesoWrap::Clamp, "clamp" },
  { MesoWrap::Mirror, "mirror" } };
constexpr Entry<MesoEffect> EffectTable[] = { { MesoEffect::Shading, "shading" },
  { MesoEffect::Occlusion, "occlusion" }, { MesoEffect::SelfShadow, "self_shadow" },
  { MesoEffect::Depth, "depth" }, { MesoEffect::Silhouette, "silhouette" },
  { MesoEffect::Curvature, "curvature" }, { MesoEffect::CastShadow, "cast_shadow" },
  { MesoEffect::OpenBoundary, "open_boundary" },
  { MesoEffect::NonHeightField, "non_height_field" } };
constexpr Entry<MesoQuadricKind> QuadricKinds[] = { { MesoQuadricKind::Full, "full" },
  { MesoQuadricKind::Diagonal, "diagonal" } };
constexpr Entry<MesoCurvedKind> CurvedKinds[] = { { MesoCurvedKind::Quadric, "quadric" },
  { MesoCurvedKind::Bent, "bent" }, { MesoCurvedKind::Osculating, "osculating" },
  { MesoCurvedKind::Surface, "surface" } };
constexpr Entry<MesoParallaxKind> ParallaxKinds[] = { { MesoParallaxKind::Occlusion, "occlusion" },
  { MesoParallaxKind::Offset, "offset" } };
constexpr Entry<MesoInterpolation> Interpolations[] = { { MesoInterpolation::Bilinear, "bilinear" },
  { MesoInterpolation::Bicubic, "bicubic" } };
constexpr Entry<MesoFilter> Filters[] = { { MesoFilter::Auto, "auto" },
  { MesoFilter::None, "none" } };
constexpr Entry<MesoCurvatureAt> CurvaturePlaces[] = { { MesoCurvatureAt::Pixel, "pixel" },
  { MesoCurvatureAt::Vertex, "vertex" } };
constexpr Entry<MesoExits> ExitKinds[] = { { MesoExits::Exact, "exact" },
  { MesoExits::Interpolated, "interpolated" } };
constexpr Entry<MesoStack> Stacks[] = { { MesoStack::Prism, "prism" },
  { MesoStack::Screen, "screen" } };

template <typename T, std::size_t N>
const char* NameOf(const Entry<T> (&table)[N], T value)
{
  for (const auto& entry : table)
  {
    if (entry.Value == value)
    {
      return entry.Name;
    }
  }
  return "";
}

template <typename T, std::size_t N>
std::optional<T> FromName(const Entry<T> (&table)[N], const std::string& name)
{
  for (const auto& entry : table)
  {
    if (name == entry.Name)
    {
      return entry.Value;
    }
  }
  return {};
}

template <typename T, std::size_t N>
std::vector<std::string> AllNames(const Entry<T> (&table)[N])
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}
}

const char* MesoName(MesoTechnique value)
{
  return NameOf(Techniques, value);
}

const char* MesoName(MesoQuality value)
{
  return NameOf(Qualities, value);
}

const char* MesoName(MesoSearch value)
{
  return NameOf(Searches, value);
}

const char* MesoName(MesoWrap value)
{
  return NameOf(Wraps, value);
}

const char* MesoName(MesoEffect value)
{
  return NameOf(EffectTable, value);
}

const char* MesoName(MesoQuadricKind value)
{
  return NameOf(QuadricKinds, value);
}

const char* MesoName(MesoCurvedKind value)
{
  return NameOf(CurvedKinds, value);
}

const char* MesoName(MesoParallaxKind value)
{
  return NameOf(ParallaxKinds, value);
}

const char* MesoName(MesoInterpolation value)
{
  return NameOf(Interpolations, value);
}

const char* MesoName(MesoFilter value)
{
  return NameOf(Filters, value);
}

const char* MesoName(MesoCurvatureAt value)
{
  return NameOf(CurvaturePlaces, value);
}

const char* MesoName(MesoExits value)
{
  return NameOf(ExitKinds, value);
}

const char* MesoName(MesoStack value)
{
  return NameOf(Stacks, value);
}

std::optional<MesoTechnique> MesoTechniqueFromName(const std::string& name)
{
  return FromName(Techniques, name);
}

std::optional<MesoQuality> MesoQualityFromName(const std::string& name)
{
  return FromName(Qualities, name);
}

std::optional<MesoSearch> MesoSearchFromName(const std::string& name)
{
  return FromName(Searches, name);
}

std::optional<MesoWrap> MesoWrapFromName(const std::string& name)
{
  return FromName(Wraps, name);
}

std::optional<MesoEffect> MesoEffectFromName(const std::string& name)
{
  return FromName(EffectTable, name);
}

std::optional<MesoQuadricKind> MesoQuadricKindFromName(const std::string& name)
{
  return FromName(QuadricKinds, name);
}

std::optional<MesoCurvedKind> MesoCurvedKindFromName(const std::string& name)
{
  return FromName(CurvedKinds, name);
}

std::optional<MesoParallaxKind> MesoParallaxKindFromName(const std::string& name)
{
  return FromName(ParallaxKinds, name);
}

std::optional<MesoInterpolation> MesoInterpolationFromName(const std::string& name)
{
  return FromName(Interpolations, name);
}

std::optional<MesoFilter> MesoFilterFromName(const std::string& name)
{
  return FromName(Filters, name);
}

std::optional<MesoCurvatureAt> MesoCurvatureAtFromName(const std::string& name)
{
  return FromName(CurvaturePlaces, name);
}

std::optional<MesoExits> MesoExitsFromName(const std::string& name)
{
  return FromName(ExitKinds, name);
}

std::optional<MesoStack> MesoStackFromName(const std::string& name)
{
  return FromName(Stacks, name);
}

std::vector<std::string> MesoTechniqueNames()
{
  return AllNames(Techniques);
}

std::vector<std::string> MesoQualityNames()
{
  return AllNames(Qualities);
}

std::vector<std::string> MesoSearchNames()
{
  return AllNames(Searches);
}

std::vector<std::string> MesoWrapNames()
{
  return AllNames(Wraps);
}

std::vector<std::string> MesoEffectNames()
{
  return AllNames(EffectTable);
}

std::vector<std::string> MesoQuadricKindNames()
{
  return AllNames(QuadricKinds);
}

std::vector<std::string> MesoCurvedKindNames()
{
  return AllNames(CurvedKinds);
}

std::vector<std::string> MesoParallaxKindNames()
{
  return AllNames(ParallaxKinds);
}

std::vector<std::string> MesoInterpolationNames()
{
  return AllNames(Interpolations);
}

std::vector<std::string> MesoFilterNames()
{
  return AllNames(Filters);
}

std::vector<std::string> MesoCurvatureAtNames()
{
  return AllNames(CurvaturePlaces);
}

std::vector<std::string> MesoExitsNames()
{
  return AllNames(ExitKinds);
}

std::vector<std::string> MesoStackNames()
{
  return AllNames(Stacks);
}

MesoEffects::MesoEffects(std::initializer_list<MesoEffect> effects)
{
  for (MesoEffect effect : effects)
  {
    this->Set(effect, true);
  }
}

void MesoEffects::Set(MesoEffect effect, bool on)
{
  const auto bit = static_cast<std::uint32_t>(effect);
  this->Bits = on ? this->Bits | bit : this->Bits & ~bit;
}

MesoEffects MesoEffects::Without(const MesoEffects& other) const
{
  MesoEffects result;
  result.Bits = this->Bits & ~other.Bits;
  return result;
}

std::vector<std::string> MesoEffects::Names() const
{
  std::vector<std::string> names;
  for (const auto& entry : EffectTable)
  {
    if (this->Has(entry.Value))
    {
      names.emplace_back(entry.Name);
    }
  }
  return names;
}

MesoSearchSteps MesoStepsOfQuality(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
      return { 16, 5 };
    case MesoQuality::Low:
      return { 32, 6 };
    case MesoQuality::Medium:
      return { 64, 7 };
    case MesoQuality::High:
    case MesoQuality::Certified:
    case MesoQuality::Full:
      return { 128, 8 };
  }
  return { 64, 7 };
}

MesoParallaxSteps MesoParallaxStepsOfQuality(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
      return { 8, 1 };
    case MesoQuality::Low:
      return { 16, 2 };
    case MesoQuality::Medium:
      return { 32, 3 };
    case MesoQuality::High:
    case MesoQuality::Certified:
    case MesoQuality::Full:
      return { 64, 4 };
  }
  return { 32, 3 };
}

int MesoAzimuthsOfQuality(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
      return 8;
    case MesoQuality::Low:
      return 16;
    case MesoQuality::Medium:
      return 32;
    case MesoQuality::High:
    case MesoQuality::Certified:
    case MesoQuality::Full:
      return 64;
  }
  return 32;
}

bool MesoHasQualities(MesoTechnique technique)
{
  return technique != MesoTechnique::Plain && technique != MesoTechnique::Bump &&
    technique != MesoTechnique::Normal && technique != MesoTechnique::NormalObject;
}

bool MesoUsesHeightMap(MesoTechnique technique)
{
  return technique != MesoTechnique::Plain && technique != MesoTechnique::GeometryImage &&
    !MesoUsesVolume(technique);
}

bool MesoUsesVolume(MesoTechnique technique)
{
  return technique == MesoTechnique::GDM || technique == MesoTechnique::Slices ||
    technique == MesoTechnique::ShellSDF;
}

bool MesoHasSearches(MesoTechnique technique)
{
  return technique == MesoTechnique::Relief || MesoBendsRelief(technique);
}

bool MesoBendsRelief(MesoTechnique technique)
{
  return technique == MesoTechnique::ReliefQuadric ||
    technique == MesoTechnique::ReliefQuadricExact;
}

double MesoFacetsPerTexel(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
      return 0.25;
    case MesoQuality::Low:
      return 0.5;
    case MesoQuality::Medium:
      return 1.;
    case MesoQuality::High:
    case MesoQuality::Certified:
    case MesoQuality::Full:
      return 2.;
  }
  return 1.;
}

double MesoFacetPixels(MesoQuality quality)
{
  return 1. / MesoFacetsPerTexel(quality);
}

MesoEffects MesoEffectsOfTechnique(MesoTechnique technique)
{
  switch (technique)
  {
    case MesoTechnique::Plain:
      return { MesoEffect::CastShadow };
    case MesoTechnique::Bump:
    case MesoTechnique::Normal:
    case MesoTechnique::NormalObject:
      return { MesoEffect::Shading, MesoEffect::CastShadow };
    case MesoTechnique::Parallax:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::CastShadow };
    case MesoTechnique::Horizon:
      return { MesoEffect::Shading, MesoEffect::SelfShadow, MesoEffect::CastShadow };
    case MesoTechnique::Relief:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow,
        MesoEffect::Depth, MesoEffect::CastShadow };
    case MesoTechnique::ReliefQuadric:
    case MesoTechnique::ReliefQuadricExact:
    case MesoTechnique::VDM:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow,
        MesoEffect::Depth, MesoEffect::Silhouette, MesoEffect::Curvature, MesoEffect::CastShadow };
    case MesoTechnique::GDM:
    case MesoTechnique::Slices:
    case MesoTechnique::ShellSDF:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow,
        MesoEffect::Depth, MesoEffect::Silhouette, MesoEffect::Curvature, MesoEffect::CastShadow,
        MesoEffect::OpenBoundary, MesoEffect::NonHeightField };
    case MesoTechnique::Displacement:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow,
        MesoEffect::Depth, MesoEffect::Silhouette, MesoEffect::Curvature, MesoEffect::CastShadow };
    case MesoTechnique::GeometryImage:
      return { MesoEffect::Shading, MesoEffect::CastShadow };
    case MesoTechnique::Tessellated:
      return { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::Depth,
        MesoEffect::Silhouette, MesoEffect::CastShadow };
    default:
      return {};
  }
}

bool MesoNeedsBaseImage(const MesoMesostructureOptions& options)
{
  return options.Technique == MesoTechnique::ReliefQuadric &&
    MesoEffectsOn(options).Has(MesoEffect::Curvature) &&
    (options.Curved == MesoCurvedKind::Bent || options.Curved == MesoCurvedKind::Surface);
}

MesoEffects MesoEffectsOn(const MesoMesostructureOptions& options)
{
  return options.Effects.Auto ? MesoEffectsOfTechnique(options.Technique) : options.Effects.Named;
}

MesoSearch MesoSearchOf(const MesoMesostructureOptions& options)
{
  const MesoSearch ofQuality =
    options.Quality == MesoQuality::Certified ? MesoSearch::Certified : MesoSearch::LinearBinary;
  return options.Search.value_or(ofQuality);
}

std::string MesoSearchProblem(const MesoMesostructureOptions& options)
{
  const bool certified = options.Quality == MesoQuality::Certified;
  if (options.Quality == MesoQuality::Full && options.Technique != MesoTechnique::VDM &&
    options.Technique != MesoTechnique::GDM)
  {
    return std::string("technique ") + MesoName(options.Technique) +
      " has no quality full: it has no table";
  }
  if (!MesoHasSearches(options.Technique))
  {
    const std::string technique = std::string("technique ") + MesoName(options.Technique);
    if (options.Search)
    {
      return technique + " has no search";
    }
    return certified ? technique + " has no quality certified" : "";
  }
  if (certified && MesoSearchOf(options) != MesoSearch::Certified)
  {
    return std::string("quality certified is the search certified, not ") +
      MesoName(*options.Search) + "; name another quality, or no search";
  }
  // These bound the relief along a way whose depth is a parabola.
  const bool bounds =
    MesoSearchOf(options) == MesoSearch::Certified || MesoSearchOf(options) == MesoSearch::Cone;
  if (bounds && options.Technique == MesoTechnique::ReliefQuadricExact)
  {
    return "technique relief-quadric-exact has no bounds for the searches cone and certified: its "
           "ray's depth is no parabola; linear-binary and linear-secant find their way";
  }
  // Over the mesh itself the ray is cut into cubics, which cones bound but no patch solves.
  const bool cubic = options.Technique == MesoTechnique::ReliefQuadric &&
    options.Curved == MesoCurvedKind::Surface && MesoSearchOf(options) == MesoSearch::Cone;
  if (bounds && !cubic && options.Technique == MesoTechnique::ReliefQuadric &&
    options.Curved != MesoCurvedKind::Quadric)
  {
    return std::string("the curved base ") + MesoName(options.Curved) +
      " has no bounds for the search " + MesoName(MesoSearchOf(options)) +
      ": its ray's depth is no parabola; " +
      (options.Curved == MesoCurvedKind::Surface ? "cone, " : "") +
      "linear-binary and linear-secant find their way";
  }
  if (bounds && options.Interpolation == MesoInterpolation::Bicubic)
  {
    return "interpolation bicubic has no bounds for the searches cone and certified, which are of "
           "bilinear patches; linear-binary and linear-secant find their way";
  }
  return "";
}

#ifndef BenchTruth_h
#define BenchTruth_h

#include "MesoImageError.h"
#include "MesoScene.h"

#include <array>

/// Which surface lies under the relief of a truth; see MesoReference::Surface.
enum class BenchSurface
{
  Mesh,
  Smooth
};

/// "mesh" or "smooth".
const char* MesoName(BenchSurface surface);

/// Whether a scene has a smooth surface other than its meshes: all meshes are whole built-in shapes
/// without volumes, and one of them is curved.
bool HasSmoothSurface(const MesoScene& scene);

/// Whether a scene holds what a technique draws: a map, a volume, or a node of its own. Techniques of volumes
/// draw maps too: where the scene itself has them drawn so, or `mapsAsVolumes`.
bool CanDraw(const MesoScene& scene, MesoTechnique technique, bool mapsAsVolumes);

/// The scene with every node that holds what a technique draws drawn by it, with all its effects, and by
/// this search.
MesoScene WithTechnique(const MesoScene& scene, MesoTechnique technique,
  std::optional<MesoQuality> quality, std::optional<MesoSearch> search = {});

/**
 * Ray trace a scene, whatever its techniques, and write `<stem>.png` and `<stem>.aov.exr`. Throws
 * MesoInputError where the scene has no truth.
 */
void WriteTruth(const MesoScene& scene, BenchSurface surface, const std::array<int, 2>& size,
  const std::string& stem);

/// What a technique's own model says of each pixel, solved exactly; nothing where the technique has no
/// model other than the truth's (MesoTechniqueModel). Judged by it, a rendering shows its solver's
/// error alone.
std::optional<MesoAOVs> SolveModel(
  const MesoScene& scene, MesoTechnique technique, const std::array<int, 2>& size);

/// Read what WriteTruth() wrote.
MesoRendering ReadTruth(const std::string& stem);

#endif

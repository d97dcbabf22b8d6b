#ifndef MesoVolumePattern_h
#define MesoVolumePattern_h

/**
 * @file MesoVolumePattern.h
 * @brief The built-in volumes: mesostructure that is no height field.
 *
 * A pattern is a function of (x, y, z), negative inside its solid and about the distance to the
 * solid's surface elsewhere, in widths of a tile. One tile is 1 x 1; z runs through the shell, 0 at
 * the bottom, 1 at the top, over `depth` tile widths. It is periodic with period 1 in x and y. The
 * same seed gives the same bytes, whatever the number of threads.
 *
 * All patterns have the key depth (in tile widths).
 *
 * - weave: threads over and under each other, with holes between. Keys: threads (4, even, each way),
 *   width (0.8, of a thread, in threads), thickness (0.9, of the cloth, of the depth).
 * - chain: rows of links along x, each through the next. Keys: links (4, even, in a row), rows (4),
 *   wire (0.14, radius, in a link's pitch), width (0.4, of a link to each side, in its pitch).
 * - grid: bars crossing in one plane, free above and below. Keys: bars (4, each way), width (0.35, in
 *   the bars' spacing), thickness (0.5, of the depth), rounding (0.5, of edges: 1 is a round bar).
 * - scales: overlapping plates over a ground, their ends towards -y free. Keys: rows (4, even),
 *   columns (4), overlap (0.6, with the next row, in rows), thickness (0.1, of a plate, of the depth),
 *   ground (0.1, of the depth), variation (0.15, of the tilt).
 * - bark: plates between cracks that are wider below. Keys: columns (5), rows (2), crack (0.12, half
 *   its width at the top, in columns), undercut (0.9, by how much it is wider at the ground),
 *   roughness (0.35).
 * - foam: a block full of bubbles that open into each other. Keys: bubbles (4, along a side), radius
 *   (0.6, in their spacing), jitter (0.6), variation (0.3, of radii).
 *
 * `weave`, `chain` and `grid` do not depend on the seed.
 */

#include "MesoPattern.h"

/// weave, chain, grid, scales, bark, foam.
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoVolumePatternNames();

/// The keys of a volume pattern; empty where there is no such pattern.
MESOCOMMONCORE_EXPORT std::vector<MesoParameter> MesoVolumePatternParameters(
  const std::string& pattern);

/// What is wrong with this pattern and these values, naming it, or an empty string.
MESOCOMMONCORE_EXPORT std::string MesoVolumePatternProblem(
  const std::string& pattern, const MesoPatternValues& values = {});

/// Voxels a side that a volume may have: 2 to this.
constexpr int MesoVolumeMaximumSize = 512;

/// The periodic function of (x, y, z).
class MESOCOMMONCORE_EXPORT MesoVolumePattern
{
public:
  /// Throws std::invalid_argument with the text of MesoVolumePatternProblem().
  explicit MesoVolumePattern(
    const std::string& pattern, std::uint32_t seed = 0, const MesoPatternValues& values = {});

  /// Thickness of the shell in tile widths.
  double GetDepth() const { return this->Depth; }

  /// About the distance to the surface in tile widths, negative inside; any finite x and y, z in [0,1].
  double At(double x, double y, double z) const;

  /// Writes the values at the voxel centres of slices [first, last) of a volume of this size.
  void Slices(std::array<int, 3> size, int first, int last, float* values) const;

  /// The function behind a pattern; one class each, in the source files.
  class Field;

private:
  std::shared_ptr<const Field> Function;
  double Depth = 0.;
};

#endif

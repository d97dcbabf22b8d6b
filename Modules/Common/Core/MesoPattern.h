#ifndef MesoPattern_h
#define MesoPattern_h

/**
 * @file MesoPattern.h
 * @brief Makes the built-in height maps.
 *
 * A pattern is a function of (s, t), periodic with period 1 in both, with values in [0,1]. A map
 * of any size samples it at its texel centres ((i + 0.5) / width, (j + 0.5) / height), row 0 at the
 * bottom (t = 0), so that maps tile exactly, and maps of different sizes show the same surface. The
 * same seed gives the same bytes, whatever the number of threads.
 *
 * - brick: masonry in running bond, rounded bricks over a hollow, sandy joint. Keys: rows (8, even
 *   unless offset is 0), columns (3), mortar (0.14, width of a joint), bevel (0.1, width of a brick's
 *   rounded edge), offset (0.5, shift of every second row in bricks), variation (0.25, of height,
 *   size and tilt from brick to brick), roughness (0.35, of faces, edges and joints).
 * - smooth: sum of all cosines cos(2 pi (m s + n t) + phase), 0 < m^2 + n^2 <= frequency^2, with
 *   amplitudes (m^2 + n^2)^(-falloff/2) and seeded phases. Keys: frequency (3), falloff (1).
 * - noise: sum of octaves of gradient noise (Perlin2002) on a lattice that wraps. Keys: frequency
 *   (4, cells a tile of the first octave), octaves (5), gain (0.5, amplitude from octave to octave).
 * - step: 1 where s < position, else low. Keys: position (0.5), low (0).
 *
 * - weave: threads over and under each other, up to the ground between them. Keys: threads (8, even,
 *   each way), width (0.85, of a thread, in threads), strands (0.5, depth of its plies' grooves),
 *   variation (0.2, of widths).
 * - stone: cobbles, cells around points shifted from a square lattice. Keys: cells (6, a side), jitter
 *   (0.8, how far points are shifted), joint (0.08, width, in cells), bevel (0.25, width of the rounded
 *   edge, in cells), variation (0.5, of heights), roughness (0.35).
 * - spikes: a cone in each square cell, (1 - distance / radius)^power high. Keys: count (8, a side),
 *   radius (0.4, in cells), power (1; less than 1: blunt, more: needles), variation (0, of heights).
 * - checkerboard: squares at 1 and low, the lower left one at 1, with upright walls. Keys: squares (8,
 *   even, a side; as many as texels: the finest map there is), low (0).
 * - pits: hollows in a flat ground, lower halves of ellipsoids with upright walls. Keys: count (8, a
 *   side), radius (0.4, in cells), variation (0.5, of places, sizes and depths).
 * - terrain: hills and ridges. Keys: frequency (3, cells a tile of the first octave), octaves (8), gain
 *   (0.5), ridges (0.6; 0: rounded hills, 1: ridges alone), warp (0.25, how far noise bends it, in cells
 *   of the first octave).
 * - waves: water, a sum of travelling sines, at a time. Keys: time (0; a wave of one period a tile takes 1
 *   for it), waves (16), frequency (8, periods a tile of the finest), direction (30 degrees, that they
 *   travel to, from +s to +t), spread (50 degrees, to each side), steepness (0.4, of crests).
 *
 * The brick's widths `mortar` and `bevel` are fractions of a row's height. `smooth` stays inside [0,1]
 * without clamping: its extremes are found on a fixed lattice and widened by what the function can
 * rise between the lattice's points. `noise` and `terrain` are scaled by
 * their extremes on a fixed lattice and clamped; `waves` by the same numbers at all times. `step` of width w has texels i < w * position - 1/2 at 1 and the others at low; read
 * bilinearly it is a ramp one texel wide, centred at s = position where w * position is whole, and
 * since the tile wraps there is a second ramp, upward, centred at s = 0.
 */

#include "MesoParameter.h"
#include "mesoCommonCoreModule.h" // for export macro

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// Values by key; keys left out have their defaults.
using MesoPatternValues = std::map<std::string, double>;

/// brick, smooth, noise, step, weave, stone, spikes, checkerboard, pits, terrain, waves.
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoPatternNames();

/// The keys of a pattern; empty where there is no such pattern.
MESOCOMMONCORE_EXPORT std::vector<MesoParameter> MesoPatternParameters(const std::string& pattern);

/// What is wrong with this pattern and these values (unknown pattern or key, wrong value, values
/// that do not go together), naming it, or an empty string.
MESOCOMMONCORE_EXPORT std::string MesoPatternProblem(
  const std::string& pattern, const MesoPatternValues& values = {});

/// Texels a side that a map may have: 1 to this.
constexpr int MesoPatternMaximumSize = 16384;

/// The periodic function of (s, t).
class MESOCOMMONCORE_EXPORT MesoPattern
{
public:
  /// Throws std::invalid_argument with the text of MesoPatternProblem().
  explicit MesoPattern(
    const std::string& pattern, std::uint32_t seed = 0, const MesoPatternValues& values = {});

  /// Height in [0,1]; any finite s and t.
  double At(double s, double t) const;

  /// Writes the heights of rows [first, last) of a map of this size to `rows`, width floats a row.
  void Rows(std::array<int, 2> size, int first, int last, float* rows) const;

  /// The function behind a pattern; one class each, in the source file.
  class Field;

private:
  std::shared_ptr<const Field> Function;
};

/// A whole map, width * height floats, row 0 at t = 0. Throws std::invalid_argument for a size
/// outside 1 to MesoPatternMaximumSize and for what MesoPatternProblem() names.
MESOCOMMONCORE_EXPORT std::vector<float> MesoMakePattern(const std::string& pattern,
  std::array<int, 2> size, std::uint32_t seed = 0, const MesoPatternValues& parameters = {});

#endif

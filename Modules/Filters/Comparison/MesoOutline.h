#ifndef MesoOutline_h
#define MesoOutline_h

/**
 * @file MesoOutline.h
 * @brief Outlines of what a picture covers, and distances to them.
 *
 * An outline is the set of the sides that a covered pixel shares with one that is not, each standing
 * for its middle. The picture's own edge is no outline: what lies beyond is not known. Lengths are in
 * pixels.
 */

#include "mesoFiltersComparisonModule.h" // for export macro

#include <vector>

/// Outline of a coverage, with the distance of every place to it (exact, Felzenszwalb2012).
class MESOFILTERSCOMPARISON_EXPORT MesoOutline
{
public:
  /// `covered` has width * height values, row by row.
  MesoOutline(const std::vector<bool>& covered, int width, int height);

  bool Empty() const { return this->Sides.empty(); }

  /// Distance of a pixel's centre to the nearest side's middle; infinite where the outline is empty.
  double DistanceOfPixel(int column, int row) const;

  struct Distance
  {
    double Mean;
    double Maximum;
  };
  /// Distances from each side of one outline to the nearest of the other, over the sides of both.
  /// 0 where both are empty, not a number where one is.
  static Distance Between(const MesoOutline& a, const MesoOutline& b);

private:
  /// Places are on a grid of half pixels: a pixel's centre has odd numbers, a side's middle one odd
  /// and one even.
  std::vector<std::size_t> Sides;
  std::vector<double> SquaredDistance; ///< of every place to the nearest side, in half pixels
  int GridWidth;
  int GridHeight;
};

/**
 * Number of the pixels of `set` in 8-connected parts of it that `reaches` nowhere; `marks`, where
 * given, is set for these pixels.
 */
MESOFILTERSCOMPARISON_EXPORT std::size_t MesoCountUnreached(const std::vector<bool>& set,
  const std::vector<bool>& reaches, int width, int height, std::vector<bool>* marks = nullptr);

#endif

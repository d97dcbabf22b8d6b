#ifndef MesoSplineCell_h
#define MesoSplineCell_h

#include "MesoCellSolver.h"

#include <array>
#include <vector>

/**
 * @class MesoSplineCell
 * @brief One cell of a height map whose heights are the uniform cubic B-spline of its texels.
 *
 * Along each axis the spline is the four control points h times the basis
 *   (1 - 3 a + 3 a^2 - a^3, 4 - 6 a^2 + 3 a^3, 1 + 3 a + 3 a^2 - 3 a^3, a^3) / 6,  a in [0,1].
 * Where the map ends (wrap clamp) all beyond half a texel from the outermost centres is level, so that the
 * outermost cells are of two parts. Written apart from Shaders/Kernels/HeightBicubic.glsl.
 */
class MesoSplineCell
{
public:
  /// The cell (column, row) of tile 0 of a map, whose lower corner lies at (x0, y0).
  MesoSplineCell(const MesoHeightPyramid& map, int column, int row, double x0, double y0);

  /// A rectangle of the cell in parts over which the height is one polynomial.
  std::vector<MesoRect> Parts(const MesoRect& rect) const;
  /// The polynomial over one of the parts.
  MesoHeightCell Over(const MesoRect& part) const;

  /// Height, and its derivatives along x and y, at a texel coordinate of a map.
  static glm::dvec3 At(const MesoHeightPyramid& map, double x, double y);

private:
  struct Side
  {
    double Start; ///< of the cell
    double Least; ///< before and after these it is level
    double Greatest;
  };
  using Weights = std::array<std::array<double, 4>, 4>; ///< of each power, for each control point

  static Weights WeightsOver(const Side& side, double low, double high, bool& level);

  Side X;
  Side Y;
  double Texels[4][4]; ///< rows of columns
};

#endif

#ifndef MesoSeparableFilter_h
#define MesoSeparableFilter_h

#include <vector>

/// What a filter takes for pixels outside the picture.
enum class MesoFilterEdge
{
  Nearest,    ///< the nearest pixel's value
  Renormalise ///< nothing: the weights inside are scaled up to the sum of all
};

/// One value a pixel, row by row.
struct MesoPlane
{
  int Width = 0;
  int Height = 0;
  std::vector<double> Values;

  MesoPlane(int width, int height)
    : Width(width)
    , Height(height)
    , Values(std::size_t(width) * height)
  {
  }
};

/**
 * The plane filtered by the product of two kernels of odd length, each centred:
 * out(x,y) = sum_i sum_j along_x[i] along_y[j] in(x + i - radius_x, y + j - radius_y).
 * Renormalise needs kernels whose sum is not 0. Rows are done in parallel.
 */
MesoPlane MesoFilterSeparably(const MesoPlane& plane, const std::vector<double>& alongX,
  const std::vector<double>& alongY, MesoFilterEdge edge);

#endif

#include "MesoSeparableFilter.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace
{
/// Places `first`, `first + step`, ... of a row or column, and the weights that apply to them.
double FilterAt(const double* first, std::ptrdiff_t step, int length, int place,
  const std::vector<double>& kernel, double kernelSum, MesoFilterEdge edge)
{
  const int radius = static_cast<int>(kernel.size() / 2);
  double sum = 0.;
  double weights = 0.;
  for (int i = 0; i < static_cast<int>(kernel.size()); ++i)
  {
    const int at = place + i - radius;
    const int inside = std::clamp(at, 0, length - 1);
    if (edge == MesoFilterEdge::Nearest || inside == at)
    {
      sum += kernel[i] * first[step * inside];
      weights += kernel[i];
    }
  }
  return edge == MesoFilterEdge::Nearest ? sum : sum * kernelSum / weights;
}
}

MesoPlane MesoFilterSeparably(const MesoPlane& plane, const std::vector<double>& alongX,
  const std::vector<double>& alongY, MesoFilterEdge edge)
{
  const double sumX = std::accumulate(alongX.begin(), alongX.end(), 0.);
  const double sumY = std::accumulate(alongY.begin(), alongY.end(), 0.);
  const int width = plane.Width;
  const int height = plane.Height;
  MesoPlane filteredX(width, height);
  MesoPlane result(width, height);
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          filteredX.Values[row * width + column] =
            FilterAt(&plane.Values[row * width], 1, width, column, alongX, sumX, edge);
        }
      }
    });
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          result.Values[row * width + column] = FilterAt(
            &filteredX.Values[column], width, height, static_cast<int>(row), alongY, sumY, edge);
        }
      }
    });
  return result;
}

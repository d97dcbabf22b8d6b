// Where light leaves a curved base: what a table over (h, theta_L, c_L), which Wang2003 names for it, is off
// by beside the closed form, and what a flat base is. Of random points of a relief .1 tiles deep, light up to
// 85 degrees off the normal, curvatures from -2 to 3: root mean square, 95th percentile and largest error of
// the distance to the way out, over the base, in texels of 128. By itself and without a window.

#include "MesoKernels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace
{
using Kernel = MesoKernels::Double::VDMTable;
const double Steepest = 85. * std::acos(-1.) / 180.;
constexpr double Depth = 0.1;
constexpr double Texels = 128.;

/// h, theta_L, c_L
struct Query
{
  double Depth;
  double Polar;
  double Curvature;
};

double ClosedForm(const Query& query)
{
  double sineOut = 0.;
  double cosineOut = 0.;
  return Kernel()
    .vdmWayOut(query.Curvature, query.Depth, std::sin(query.Polar), std::cos(query.Polar), sineOut,
      cosineOut)
    .Offset;
}

/// `count` samples along each axis, linear between them.
class Table
{
public:
  explicit Table(int count)
    : Count(count)
  {
    for (int i = 0; i < count * count * count; ++i)
    {
      const auto at = [&](int index, double first, double last)
      { return first + (last - first) * index / (count - 1); };
      this->Offsets.push_back(ClosedForm({ at(i % count, 0., Depth),
        at(i / count % count, 0., Steepest), at(i / count / count, -2., 3.) }));
    }
  }

  double Sample(const Query& query) const
  {
    const double places[] = { query.Depth / Depth, query.Polar / Steepest,
      (query.Curvature + 2.) / 5. };
    double sum = 0.;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.;
      int index = 0;
      int stride = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double place = places[axis] * (this->Count - 1);
        const int low = std::min(static_cast<int>(place), this->Count - 2);
        const bool high = (corner >> axis & 1) != 0;
        weight *= high ? place - low : 1. - (place - low);
        index += stride * (low + (high ? 1 : 0));
        stride *= this->Count;
      }
      sum += weight * this->Offsets[index];
    }
    return sum;
  }

private:
  int Count;
  std::vector<double> Offsets;
};

template <typename OffsetOf>
void Measure(const char* name, int count, const OffsetOf& offsetOf)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<double> errors;
  double squares = 0.;
  for (int i = 0; i < 200000; ++i)
  {
    Query query;
    query.Depth = Depth * uniform(random);
    query.Polar = Steepest * uniform(random);
    query.Curvature = 5. * uniform(random) - 2.;
    errors.push_back(Texels * std::abs(offsetOf(query) - ClosedForm(query)));
    squares += errors.back() * errors.back();
  }
  std::sort(errors.begin(), errors.end());
  std::printf("%-10s %3d %8.3f %8.3f %8.2f\n", name, count,
    std::sqrt(squares / double(errors.size())), errors[errors.size() * 95 / 100], errors.back());
}
}

int main()
{
  Measure("flat base", 0, [](const Query& query) { return query.Depth * std::tan(query.Polar); });
  for (const int count : { 8, 16, 32, 64 })
  {
    const Table table(count);
    Measure("table", count, [&](const Query& query) { return table.Sample(query); });
  }
  return 0;
}

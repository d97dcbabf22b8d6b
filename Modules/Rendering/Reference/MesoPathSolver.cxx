#include "MesoPathSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Never = 2.;

/// a + b s + c s^2.
struct Quadratic
{
  double A;
  double B;
  double C;

  double At(double s) const { return this->A + s * (this->B + s * this->C); }
};

/// The least s in [0, end] at which it is 0 or less (or, `strict`, less than 0 after it); Never
/// where there is none.
double FirstBelow(const Quadratic& q, double end, bool strict)
{
  if (strict ? q.A < 0. : q.A <= 0.)
  {
    return 0.;
  }
  // Above 0 at the start: down through the smaller root, or, opening downward, the greater.
  const double discriminant = q.B * q.B - 4. * q.A * q.C;
  if (discriminant < 0. || (strict && discriminant == 0.))
  {
    return Never;
  }
  const double root = std::sqrt(discriminant);
  double first = Never;
  const double sum = -0.5 * (q.B + std::copysign(root, q.B));
  for (const double s : { q.C != 0. ? sum / q.C : Never, sum != 0. ? q.A / sum : Never })
  {
    // A path that only touches the relief, coming up from it, is not below it.
    const bool rises = strict && q.B + 2. * q.C * s >= 0.;
    if (s >= 0. && s <= end && !rises)
    {
      first = std::min(first, s);
    }
  }
  return first;
}

/// Walks the pieces of a path from patch to patch.
class Walk
{
public:
  Walk(const MesoModelField& field, const MesoModelPath& path)
    : Field(field)
    , Path(path)
    , Start(glm::dvec2(field.mapSize()) * (path.MapStart - field.wholeTiles(path.MapStart)) - 0.5)
    , Span(glm::dvec2(field.mapSize()) * path.MapSpan)
  {
  }

  double First(bool strict) const
  {
    double from = 0.;
    for (long patches = 0; patches < MesoMostPatches && from < 1.; ++patches)
    {
      const double to = this->NextLine(from);
      const Quadratic clearance = this->Clearance(from, to);
      const double s = FirstBelow(clearance, to - from, strict);
      if (s <= to - from)
      {
        return from + s;
      }
      from = to;
    }
    return Never;
  }

private:
  /// The next part at which the path crosses a line through texel centres, or its end.
  double NextLine(double from) const
  {
    double next = 1.;
    for (int k = 0; k < 2; ++k)
    {
      if (this->Span[k] == 0.)
      {
        continue;
      }
      const double at = this->Start[k] + from * this->Span[k];
      double line = this->Span[k] > 0. ? std::floor(at) + 1. : std::ceil(at) - 1.;
      double part = (line - this->Start[k]) / this->Span[k];
      if (!(part > from)) // the line that it stands on
      {
        line += this->Span[k] > 0. ? 1. : -1.;
        part = (line - this->Start[k]) / this->Span[k];
      }
      next = part > from ? std::min(next, part) : next;
    }
    return next;
  }

  double Height(std::int64_t column, std::int64_t row) const
  {
    const glm::ivec2 size = this->Field.mapSize();
    const int mode = this->Field.wrapMode();
    return this->Field.fetchHeight({ this->Field.wrapTexel(static_cast<int>(column), size.x, mode),
      this->Field.wrapTexel(static_cast<int>(row), size.y, mode) });
  }

  /// (1 - height) - depth over the part's distance from `from`, on the patch that lies between.
  Quadratic Clearance(double from, double to) const
  {
    const glm::dvec2 middle = this->Start + 0.5 * (from + to) * this->Span;
    const glm::dvec2 corner = glm::floor(middle);
    const auto column = static_cast<std::int64_t>(corner.x);
    const auto row = static_cast<std::int64_t>(corner.y);
    const double h00 = this->Height(column, row);
    const double alongX = this->Height(column + 1, row) - h00;
    const double alongY = this->Height(column, row + 1) - h00;
    const double twist = this->Height(column + 1, row + 1) - h00 - alongX - alongY;
    const glm::dvec2 in = this->Start + from * this->Span - corner;
    const Quadratic height = { h00 + in.x * alongX + in.y * alongY + in.x * in.y * twist,
      this->Span.x * (alongX + in.y * twist) + this->Span.y * (alongY + in.x * twist),
      this->Span.x * this->Span.y * twist };
    const double rise = this->Path.DepthEnd - this->Path.DepthStart + this->Path.Sag;
    const Quadratic depth = { this->Path.DepthStart + from * (rise - this->Path.Sag * from),
      rise - 2. * this->Path.Sag * from, -this->Path.Sag };
    return { 1. - height.A - depth.A, -height.B - depth.B, -height.C - depth.C };
  }

  const MesoModelField& Field;
  const MesoModelPath& Path;
  glm::dvec2 Start; ///< in texels, centres at whole numbers
  glm::dvec2 Span;
};

bool IsSound(const MesoModelField& field, const MesoModelPath& path)
{
  // Past this a texel's number is no int.
  constexpr double MostTexels = 1e9;
  const glm::dvec2 size(field.mapSize());
  const glm::dvec2 reach =
    size * (glm::abs(path.MapSpan) + glm::abs(path.MapStart - field.wholeTiles(path.MapStart)));
  return field.pathIsSound(path) && reach.x < MostTexels && reach.y < MostTexels;
}
}

double MesoFirstMeeting(const MesoModelField& field, const MesoModelPath& path)
{
  if (!IsSound(field, path))
  {
    return Never;
  }
  const double first = Walk(field, path).First(false);
  // A path that ends at the bottom meets it, whatever rounding makes of the last piece.
  return first > 1. && path.DepthEnd >= 1. ? 1. : first;
}

bool MesoIsBlocked(const MesoModelField& field, const MesoModelPath& path)
{
  return path.DepthStart > 0. && IsSound(field, path) && Walk(field, path).First(true) < 1.;
}

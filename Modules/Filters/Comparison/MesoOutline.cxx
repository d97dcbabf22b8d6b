#include "MesoOutline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// The lower envelope of parabolas, one rooted at each place: squared distances along a line.
class LineTransform
{
public:
  explicit LineTransform(int longest)
    : Roots(longest)
    , Starts(longest + 1)
    , Before(longest)
  {
  }

  void operator()(double* values, std::ptrdiff_t step, int length)
  {
    int count = 0;
    for (int place = 0; place < length; ++place)
    {
      const double value = values[step * place];
      this->Before[place] = value;
      if (value == Infinite)
      {
        continue;
      }
      double start = -Infinite;
      while (count > 0)
      {
        const int root = this->Roots[count - 1];
        start = ((value + double(place) * place) - (this->Before[root] + double(root) * root)) /
          (2. * (place - root));
        if (start > this->Starts[count - 1])
        {
          break;
        }
        --count;
        start = -Infinite;
      }
      this->Roots[count] = place;
      this->Starts[count] = start;
      ++count;
    }
    if (count == 0)
    {
      return;
    }
    this->Starts[count] = Infinite;
    for (int place = 0, i = 0; place < length; ++place)
    {
      while (this->Starts[i + 1] < place)
      {
        ++i;
      }
      const double along = place - this->Roots[i];
      values[step * place] = along * along + this->Before[this->Roots[i]];
    }
  }

private:
  std::vector<int> Roots;
  std::vector<double> Starts;
  std::vector<double> Before;
};
}

MesoOutline::MesoOutline(const std::vector<bool>& covered, int width, int height)
  : GridWidth(2 * width + 1)
  , GridHeight(2 * height + 1)
{
  const std::size_t places = std::size_t(this->GridWidth) * this->GridHeight;
  this->SquaredDistance.assign(places, Infinite);
  const auto isCovered = [&](int column, int row)
  { return covered[std::size_t(row) * width + column]; };
  const auto addSide = [&](int x, int y)
  {
    this->Sides.push_back(std::size_t(y) * this->GridWidth + x);
    this->SquaredDistance[this->Sides.back()] = 0.;
  };
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      if (column > 0 && isCovered(column, row) != isCovered(column - 1, row))
      {
        addSide(2 * column, 2 * row + 1);
      }
      if (row > 0 && isCovered(column, row) != isCovered(column, row - 1))
      {
        addSide(2 * column + 1, 2 * row);
      }
    }
  }
  if (this->Sides.empty())
  {
    return;
  }
  LineTransform transform(std::max(this->GridWidth, this->GridHeight));
  for (int x = 0; x < this->GridWidth; ++x)
  {
    transform(&this->SquaredDistance[x], this->GridWidth, this->GridHeight);
  }
  for (int y = 0; y < this->GridHeight; ++y)
  {
    transform(&this->SquaredDistance[std::size_t(y) * this->GridWidth], 1, this->GridWidth);
  }
}

double MesoOutline::DistanceOfPixel(int column, int row) const
{
  return 0.5 *
    std::sqrt(this->SquaredDistance[std::size_t(2 * row + 1) * this->GridWidth + 2 * column + 1]);
}

MesoOutline::Distance MesoOutline::Between(const MesoOutline& a, const MesoOutline& b)
{
  if (a.Empty() && b.Empty())
  {
    return { 0., 0. };
  }
  if (a.Empty() || b.Empty())
  {
    constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
    return { NotKnown, NotKnown };
  }
  double sum = 0.;
  double most = 0.;
  const auto add = [&](const MesoOutline& from, const MesoOutline& to)
  {
    for (const std::size_t side : from.Sides)
    {
      const double distance = 0.5 * std::sqrt(to.SquaredDistance[side]);
      sum += distance;
      most = std::max(most, distance);
    }
  };
  add(a, b);
  add(b, a);
  return { sum / double(a.Sides.size() + b.Sides.size()), most };
}

std::size_t MesoCountUnreached(const std::vector<bool>& set, const std::vector<bool>& reaches,
  int width, int height, std::vector<bool>* marks)
{
  if (marks)
  {
    marks->assign(set.size(), false);
  }
  std::vector<bool> seen(set.size(), false);
  std::size_t count = 0;
  std::vector<std::size_t> part;
  for (std::size_t start = 0; start < set.size(); ++start)
  {
    if (!set[start] || seen[start])
    {
      continue;
    }
    part.assign(1, start);
    seen[start] = true;
    bool reached = false;
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      const int column = static_cast<int>(part[next] % width);
      const int row = static_cast<int>(part[next] / width);
      reached = reached || reaches[part[next]];
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y)
      {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x)
        {
          const std::size_t neighbour = std::size_t(y) * width + x;
          if (set[neighbour] && !seen[neighbour])
          {
            seen[neighbour] = true;
            part.push_back(neighbour);
          }
        }
      }
    }
    if (!reached)
    {
      count += part.size();
      if (marks)
      {
        for (const std::size_t pixel : part)
        {
          (*marks)[pixel] = true;
        }
      }
    }
  }
  return count;
}

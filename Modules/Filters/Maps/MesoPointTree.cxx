#include "MesoPointTree.h"

#include <algorithm>
#include <utility>

struct MesoPointTree::Search
{
  Point Position;
  std::size_t Best;
  double Square;

  static double Between(const Point& a, const Point& b)
  {
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    const double z = a[2] - b[2];
    return x * x + y * y + z * z;
  }
};

MesoPointTree::MesoPointTree(std::vector<Point> points)
  : Points(std::move(points))
  , Axes(this->Points.size())
{
  this->Build(0, this->Points.size());
}

void MesoPointTree::Build(std::size_t first, std::size_t last)
{
  if (last - first < 2)
  {
    return;
  }
  Point least = this->Points[first];
  Point most = least;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      least[axis] = std::min(least[axis], this->Points[i][axis]);
      most[axis] = std::max(most[axis], this->Points[i][axis]);
    }
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    longest = most[axis] - least[axis] > most[longest] - least[longest] ? axis : longest;
  }
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return this->Points.begin() + static_cast<long>(i); };
  std::nth_element(at(first), at(middle), at(last),
    [longest](const Point& a, const Point& b) { return a[longest] < b[longest]; });
  this->Axes[middle] = static_cast<unsigned char>(longest);
  this->Build(first, middle);
  this->Build(middle + 1, last);
}

std::size_t MesoPointTree::Nearest(const Point& position, std::size_t guess) const
{
  Search search = { position, guess, Search::Between(position, this->Points[guess]) };
  this->Look(0, this->Points.size(), search);
  return search.Best;
}

void MesoPointTree::Look(std::size_t first, std::size_t last, Search& search) const
{
  if (first == last)
  {
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const double square = Search::Between(search.Position, this->Points[middle]);
  if (square < search.Square)
  {
    search.Square = square;
    search.Best = middle;
  }
  const int axis = this->Axes[middle];
  const double beyond = search.Position[axis] - this->Points[middle][axis];
  const bool isBelow = beyond < 0.;
  this->Look(isBelow ? first : middle + 1, isBelow ? middle : last, search);
  if (beyond * beyond < search.Square)
  {
    this->Look(isBelow ? middle + 1 : first, isBelow ? last : middle, search);
  }
}

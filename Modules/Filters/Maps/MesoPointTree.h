#ifndef MesoPointTree_h
#define MesoPointTree_h

#include <array>
#include <cstddef>
#include <vector>

/**
 * @class MesoPointTree
 * @brief Finds the nearest of many points: a balanced tree, halved along the longest side of each part.
 *
 * Constant after construction, so threads may share it.
 */
class MesoPointTree
{
public:
  using Point = std::array<double, 3>;

  explicit MesoPointTree(std::vector<Point> points);

  bool Empty() const { return this->Points.empty(); }
  const Point& operator[](std::size_t number) const { return this->Points[number]; }

  /// The number of the nearest point. `guess` is any point's; a near one makes it quick.
  std::size_t Nearest(const Point& position, std::size_t guess = 0) const;

private:
  struct Search;
  void Build(std::size_t first, std::size_t last);
  void Look(std::size_t first, std::size_t last, Search& search) const;

  std::vector<Point> Points;       ///< of a part, the middle one halves it
  std::vector<unsigned char> Axes; ///< along which it does
};

#endif

#ifndef MesoHeightLine_h
#define MesoHeightLine_h

#include <cstddef>
#include <vector>

/**
 * @class MesoHeightLine
 * @brief A line over a map that repeats, from a texel's centre on: where it crosses rows and columns.
 *
 * The line is cut where it crosses rows and columns of texel centres, and between cuts the bilinear
 * surface along it is a parabola. From every texel the cuts are the same, moved with it.
 */
class MesoHeightLine
{
public:
  /**
   * @param width,height of the map in texels; it is 1 x 1 tiles large
   * @param azimuth direction over the map, (cos, sin) in tiles
   * @param reach tiles to which the line goes at least
   */
  MesoHeightLine(int width, int height, double azimuth, double reach);

  std::size_t GetCutCount() const { return this->Cuts.size(); }
  /// Of each cut from the start, in tiles; the first is 0.
  const std::vector<double>& GetOffsets() const { return this->Offsets; }

  /// The surface along the line from a texel on. Depths are computed as far as they are asked for.
  class Profile
  {
  public:
    /// depths: below the base, row by row, in any unit
    Profile(const MesoHeightLine& line, const float* depths);

    void Start(int column, int row);
    /// Makes depths known up to a cut.
    void Reach(std::size_t cut)
    {
      if (cut >= this->Known)
      {
        this->Extend(cut);
      }
    }
    /// At a cut that is known.
    double DepthAt(std::size_t cut) const { return this->Depths[cut]; }
    /// Half the second derivative from a cut to the next.
    double BendAfter(std::size_t cut) const { return this->Bends[cut]; }
    /// How far the surface can lie below its chord, as a depth, from a cut to the next: at least 0.
    double SagAfter(std::size_t cut) const { return this->Sags[cut]; }
    /// Between a cut and the next, both known; `along` from the first, in tiles.
    double DepthBetween(std::size_t cut, double along) const;

  private:
    void Extend(std::size_t cut);

    const MesoHeightLine& Line;
    const float* Map;
    int Column = 0;
    int Row = 0;
    std::size_t Known = 0;
    std::vector<double> Depths;
    std::vector<double> Bends;
    std::vector<double> Sags;
  };

private:
  /// Two texels, relative to the start and within the map's size, and the second one's weight.
  struct Cut
  {
    int Column[2];
    int Row[2];
    double Weight;
    int Cell[2]; ///< lower left texel of the patch after the cut
  };

  int Width;
  int Height;
  double BendPerTwist; ///< of a parabola, for a patch's twist
  std::vector<double> Offsets;
  std::vector<Cut> Cuts;
};

#endif

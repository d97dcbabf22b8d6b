#ifndef MesoHorizonSweep_h
#define MesoHorizonSweep_h

#include "MesoOptions.h" // for MesoWrap

#include <vector>

/**
 * @class MesoHorizonSweep
 * @brief How high the relief stands around each texel, in one direction at a time.
 *
 * The map is cut by parallel lines in the direction, a texel apart across the axis that it is nearer to.
 * Each line is swept once, towards the texels from the far end, with the upper convex hull of what has
 * been passed: the horizon of a point is where its tangent touches the hull, and what the tangent passes
 * over can be no nearer point's horizon. Every sample enters and leaves the hull once, so a direction
 * costs a constant time a texel, whatever lies around it.
 *
 * The lines are sampled where they cross rows and columns of texel centres and in the middle between,
 * and the slope of the surface at the point itself is looked at. Between samples the bilinear surface
 * can rise above them by a 32nd of a patch's twist, |h00 - h10 - h01 + h11| / 32. A texel between two lines has the mean of their angles, weighted by
 * distance; along the axes, and along the diagonals of square maps, lines go through the centres.
 */
class MesoHorizonSweep
{
public:
  /**
   * @param heights row by row, row 0 at v = 0
   * @param reach tiles that are looked at from each texel; what lies further off raises a horizon by at
   *   most 1 / reach, in heights a tile
   * @param scale depth of the relief in widths of a tile, in which angles are measured
   */
  MesoHorizonSweep(int width, int height, MesoWrap wrap, const std::vector<float>& heights,
    double reach, double scale);

  /**
   * Angles of the horizon above the plane, radians in [0, pi/2), a texel each.
   *
   * @param azimuth direction over the map, (cos, sin) in (u, v), tiles in both
   */
  std::vector<float> Sweep(double azimuth) const;

private:
  int Width;
  int Height;
  MesoWrap Wrap;
  const std::vector<float>& Heights;
  double Reach;
  double Scale;
};

#endif

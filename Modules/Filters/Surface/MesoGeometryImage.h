#ifndef MesoGeometryImage_h
#define MesoGeometryImage_h

/**
 * @class MesoGeometryImage
 * @brief Samples a mesh over its texture coordinates into grids whose charts are stitched along their cuts.
 *
 * A texel's sample is the mesh at its centre. Samples at the edge of a chart (a texel beside which, to the
 * right, left, above or below, the chart goes on no more) are moved onto the cut there: along each cut lie
 * places at equal distances, no closer than StitchStep texels of the side that has the fewer, and each
 * sample goes to the nearest. Both sides of the cut so come to the same places, each of them met by a
 * sample of either, and the grids close. Cuts run from corner to corner: vertices where other than two cut
 * edges meet, where the charts beside the cut change, or where a chart's outline turns by more than
 * CornerAngle; corners are places themselves. Edges of the mesh are cuts with one side.
 *
 * Sources: Gu2002; Sander2003 (Documentation/Techniques/References.md), whose zippering this is in short.
 */

#include "MesoTriangleMesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

/// What a geometry image is made of: a normal and a coordinate a point.
struct MesoGeometryInput
{
  MesoTriangleMesh Mesh;
  std::vector<MesoVector> Normals;
  std::vector<std::array<double, 2>> Coordinates;
};

/// Samples, row by row, row 0 at v = 0.
struct MesoGeometryLevel
{
  int Size = 0;
  std::vector<MesoVector> Positions;
  std::vector<MesoVector> Normals; ///< unit
  std::vector<std::array<double, 2>> Coordinates;
  /// Number of the chart from 1, below 0 where it is mirrored; 0: no chart.
  std::vector<std::int32_t> Charts;
  std::int64_t Overlapping = 0; ///< texels under several charts
};

class MesoGeometryImage
{
public:
  static constexpr double StitchStep = 2.;
  static constexpr double CornerAngle = 40.; ///< degrees

  /// The image lies over [0,1] x [0,1], or over more where coordinates go beyond it a little. Throws
  /// std::invalid_argument where they spread over more than two tiles.
  explicit MesoGeometryImage(const MesoGeometryInput& input);

  int NumberOfCharts() const { return static_cast<int>(this->Mirrored.size()); }
  MesoGeometryLevel Sample(int size) const;

  /// Texel numbers, three a triangle: of four samples of one chart two triangles along the shorter
  /// diagonal, of three one. None with two corners in one place.
  static std::vector<std::int32_t> Triangles(const MesoGeometryLevel& level);

private:
  /// A half-edge at the edge of a chart.
  struct Side
  {
    std::int64_t Corner;
    int Chart;
    int Chain;   ///< -1: both ends are one vertex
    double From; ///< where it begins and ends along the chain
    double To;
  };
  /// A stretch of cuts, and the edges along it.
  struct Chain
  {
    std::vector<std::array<std::int64_t, 2>> Edges; ///< vertices, in the chain's direction
    std::vector<double> Ends;                       ///< of each, from the chain's start; uv units
    bool Loop = false;
  };
  using EdgeKey = std::array<std::int64_t, 2>;

  void FindCharts();
  void FindChains();
  bool IsCorner(std::int64_t vertex, const std::vector<EdgeKey>& edges) const;
  double LengthOf(const EdgeKey& edge) const;
  void Follow(EdgeKey edge, std::int64_t from, const std::vector<bool>& corners,
    std::map<EdgeKey, bool>& seen);
  void Stitch(MesoGeometryLevel& level) const;
  void PlaceOn(const Side& side, double along, std::size_t texel, MesoGeometryLevel& level) const;

  const MesoGeometryInput& Input;
  std::array<double, 2> Low = { 0., 0. }; ///< coordinates at the image's lower left
  std::array<double, 2> Span = { 1., 1. };
  std::vector<std::array<double, 2>> Placed; ///< coordinates over the image
  std::vector<int> ChartOf;                  ///< by triangle, from 0
  std::vector<bool> Mirrored;
  std::vector<std::int64_t> PointAt;        ///< by merged vertex
  std::map<EdgeKey, std::vector<int>> Cuts; ///< sides by edge, the lesser vertex first
  std::vector<std::vector<EdgeKey>> CutsAt; ///< by vertex
  std::vector<Side> Sides;
  std::vector<Chain> Chains;
};

#endif

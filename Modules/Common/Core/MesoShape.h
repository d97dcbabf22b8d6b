#ifndef MesoShape_h
#define MesoShape_h

/**
 * @file MesoShape.h
 * @brief Evaluates the built-in shapes as closed forms: position, normal and frame at (u, v).
 *
 * All shapes are centred at the origin and given in object space. A shape is one chart or several:
 * rectangles of (u, v) in [0,1] x [0,1] that do not overlap, each the image of a piece of the surface.
 * All are right-handed with the normal pointing outward, (dp/du x dp/dv) . n > 0 (only at poles it is
 * 0). Counts are numbers of quads of two triangles each.
 *
 * One chart that covers [0,1] x [0,1]:
 * - plane: z = 0, faces +z, u along +x, v along +y. Keys: size [w,h] ([1,1]), segments [nx,ny]
 *   ([1,1]).
 * - sphere: poles on the y axis; u = longitude, eastward, v = latitude from the south pole (-y,
 *   v = 0) to the north pole (+y, v = 1). Keys: radius (1), rings (24, along v), sides (48, along
 *   u).
 * - cylinder: around the y axis, open; u around it eastward, v along it upward. Keys: radius (0.5),
 *   height (1), sides (48, along u), rings (1, along v).
 * - cone: the same, straight from a radius at the bottom to one at the top; with top 0 it ends in a
 *   point, a pole of the chart. Open below. Keys: radius (0.5), top (0), height (1), sides (48), rings
 *   (16).
 * - torus: around the y axis; u around the main circle eastward, v around the tube. Keys: radius (1,
 *   of the main circle), tube (0.4, less than radius), rings (48, along u), sides (24, along v).
 * - vase: around the y axis, open above and below, with a foot, a belly of the given radius, a neck
 *   and a lip; u around it eastward, v = height from the foot. Lengths along v are up to 1 / cos of the
 *   wall's lean: 1.24 times, with the default numbers. Keys: radius (0.5), height (1.5), rings (60,
 *   along v), sides (72, along u): 8640 triangles.
 * - undulating: an open sheet over a rectangle of z = 0, z = amplitude cos(2 pi m (u - 1/2)) cos(2 pi n
 *   (v - 1/2)), facing +z; u along +x, v along +y, so that it is stretched where it is steep. u and v
 *   are not at right angles to each other on it. Keys: size [w,h] ([2,2]), amplitude (0.15), waves
 *   [m,n] ([1.5,1]), segments [nx,ny] ([48,48]).
 *
 * Several charts, the surface welded: points of the charts' common edges have equal bits.
 * - cube: six flat faces with hard edges, each in a cell of 1/3 x 1/2: -x, -y, -z below, +x, +y, +z
 *   above. On the faces around v runs upward; on top and bottom u runs along +x. Keys: size [w,h,d]
 *   ([1,1,1]), segments (1, along each edge).
 * - teapot: the 32 Bezier patches of Newell's, with its bottom, the spout along +x; y runs up. The body
 *   takes u from 0 to 1 eastward and v from the middle of the bottom (0) to the rim (9/16); the lid u
 *   from 0 to 2/3 and v from its edge (5/8) to the knob (7/8); the spout v from 5/8 to 7/8 around it,
 *   and the handle v from 7/8 to 1, u running along both from the body on. Lengths are about alike where
 *   a map has twelve tiles along u and eight along v, or multiples of them, with which it also closes
 *   around all four. Open where lid and body do not meet, and where handle and spout begin. Keys:
 *   radius (1, of the body), segments (8, along each side of a patch: 4032 triangles).
 * - branch: a trunk along y, bent to an S and tapering, in u from 0 to 1/2, with up to four side shoots
 *   in cells of 1/4 x 1/2 beside it; u around each eastward, v along it. Shoots begin inside of the
 *   trunk and run through its wall: they are not welded to it. Ends are half spheres or open. Keys:
 *   radius (0.16, of the trunk's root, less than a quarter of length), length (2), bend (0.5, 0 to 1),
 *   shoots (2, 0 to 4), caps (1: ends are closed; 0), rings (62), sides (32), of the trunk; shoots have
 *   half of them: 5856 triangles.
 *
 * "Eastward" is counter-clockwise seen from +y. The seam u = 0 lies at -z, so that u = 1/2 faces
 * +z (of a branch, in the trunk's own frame); the torus' seam v = 0 lies on its inner equator. A chart
 * that closes has the same position, bit for bit, at both of its ends.
 */

#include "MesoParameter.h"
#include "mesoCommonCoreModule.h" // for export macro

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// Values by key; keys left out have their defaults.
using MesoShapeValues = std::map<std::string, std::vector<double>>;

/// plane, cube, sphere, cylinder, cone, torus, vase, teapot, undulating, branch.
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoShapeNames();

/// The keys of a shape; empty where there is no such shape.
MESOCOMMONCORE_EXPORT std::vector<MesoParameter> MesoShapeParameters(const std::string& shape);

/// What is wrong with this shape and these values (unknown shape or key, wrong value, values that do
/// not go together), naming it, or an empty string.
MESOCOMMONCORE_EXPORT std::string MesoShapeProblem(
  const std::string& shape, const MesoShapeValues& values = {});

/// The surface at one (u, v): dp/du = Scale[0] * Tangent, dp/dv = Scale[1] * Bitangent.
struct MesoShapePoint
{
  std::array<double, 3> Position;
  std::array<double, 3> Normal;    ///< unit, outward
  std::array<double, 3> Tangent;   ///< unit; at a pole its limit along the meridian u
  std::array<double, 3> Bitangent; ///< unit
  std::array<double, 2> Scale;     ///< object units per unit of u and v; [0] is 0 at a pole
};

/// How a surface bends around a point: derivatives of the normal there, and upper bounds, on a
/// rectangle around it, of the lengths of derivatives of position P and normal N.
struct MesoShapeBends
{
  std::array<double, 3> NormalU = { 0., 0., 0. };
  std::array<double, 3> NormalV = { 0., 0., 0. };
  double Puu = 0.;
  double Puv = 0.;
  double Pvv = 0.;
  double Nu = 0.;
  double Nv = 0.;
  double Nuu = 0.;
  double Nuv = 0.;
  double Nvv = 0.;
};

/// A piece of a shape and its rectangle of the texture.
struct MesoShapeChart
{
  std::array<int, 2> Segments = { 1, 1 }; ///< that it is to be cut into, along u and v
  std::array<double, 2> Low = { 0., 0. };
  std::array<double, 2> High = { 1., 1. };
  bool PoleAtStart = false; ///< the edge of the lower v is a single position
  bool PoleAtEnd = false;   ///< that of the higher v

  /// (u, v) of a place (a, b) in [0,1] x [0,1], exact at the edges.
  std::array<double, 2> Coordinates(double a, double b) const
  {
    return { (1. - a) * this->Low[0] + a * this->High[0],
      (1. - b) * this->Low[1] + b * this->High[1] };
  }
};

class MESOCOMMONCORE_EXPORT MesoShape
{
public:
  /// Throws std::invalid_argument with the text of MesoShapeProblem().
  explicit MesoShape(const std::string& shape, const MesoShapeValues& values = {});

  const std::vector<MesoShapeChart>& Charts() const { return this->AllCharts; }

  /// The surface at a place (a, b) in [0,1] x [0,1] of a chart; derivatives are those by u and v.
  MesoShapePoint InChart(std::size_t chart, double a, double b) const;

  /// The surface at (u, v), for shapes of one chart.
  MesoShapePoint At(double u, double v) const { return this->InChart(0, u, v); }

  /// Whether a mesh of the shape is the shape itself: flat faces with constant normals.
  bool IsFlat() const;

  /// Whether BendsAround() knows its bends, and it has one chart.
  bool HasBends() const;

  /// `middle` is At(u, v); the rectangle reaches halfU and halfV to each side, and may reach beyond
  /// the chart.
  MesoShapeBends BendsAround(
    const MesoShapePoint& middle, double u, double v, double halfU, double halfV) const;

  /// The closed form behind a shape; one class each, in the source files.
  class Form;

private:
  std::shared_ptr<const Form> Function;
  std::vector<MesoShapeChart> AllCharts;
};

#endif

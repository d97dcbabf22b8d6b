#ifndef MesoShape_h
#define MesoShape_h

/**
 * @file MesoShape.h
 * @brief Evaluates the built-in shapes as closed forms: position, normal and frame at (u, v).
 *
 * All shapes are centred at the origin and given in object space. Each is one chart: (u, v) covers
 * [0,1] x [0,1] once, and the chart is right-handed with the normal pointing outward,
 * (dp/du x dp/dv) . n > 0 (only at a sphere's poles it is 0).
 *
 * - plane: z = 0, faces +z, u along +x, v along +y. Keys: size [w,h] ([1,1]), segments [nx,ny]
 *   ([1,1]).
 * - sphere: poles on the y axis; u = longitude, eastward, v = latitude from the south pole (-y,
 *   v = 0) to the north pole (+y, v = 1). Keys: radius (1), rings (24, along v), sides (48, along
 *   u).
 * - cylinder: around the y axis, open; u around it eastward, v along it upward. Keys: radius (0.5),
 *   height (1), sides (48, along u), rings (1, along v).
 * - torus: around the y axis; u around the main circle eastward, v around the tube. Keys: radius (1,
 *   of the main circle), tube (0.4, less than radius), rings (48, along u), sides (24, along v).
 *
 * "Eastward" is counter-clockwise seen from +y. The seam u = 0 lies at -z, so that u = 1/2 faces
 * +z; the torus' seam v = 0 lies on its inner equator. A chart that closes has the same position,
 * bit for bit, at 0 and at 1.
 */

#include "MesoParameter.h"
#include "mesoCommonCoreModule.h" // for export macro

#include <array>
#include <map>
#include <string>
#include <vector>

/// Values by key; keys left out have their defaults.
using MesoShapeValues = std::map<std::string, std::vector<double>>;

/// plane, sphere, cylinder, torus.
MESOCOMMONCORE_EXPORT std::vector<std::string> MesoShapeNames();

/// The keys of a shape; empty where there is no such shape.
MESOCOMMONCORE_EXPORT std::vector<MesoParameter> MesoShapeParameters(const std::string& shape);

/// What is wrong with this shape and these values (unknown shape or key, wrong value, a torus' tube
/// that is not less than its radius), naming it, or an empty string.
MESOCOMMONCORE_EXPORT std::string MesoShapeProblem(
  const std::string& shape, const MesoShapeValues& values = {});

/// The surface at one (u, v): dp/du = Scale[0] * Tangent, dp/dv = Scale[1] * Bitangent.
struct MesoShapePoint
{
  std::array<double, 3> Position;
  std::array<double, 3> Normal;    ///< unit, outward
  std::array<double, 3> Tangent;   ///< unit; at a sphere's pole its limit along the meridian u
  std::array<double, 3> Bitangent; ///< unit; at right angles to Tangent in all shapes here
  std::array<double, 2> Scale;     ///< object units per unit of u and v; [0] is 0 at a pole
};

class MESOCOMMONCORE_EXPORT MesoShape
{
public:
  /// Throws std::invalid_argument with the text of MesoShapeProblem().
  explicit MesoShape(const std::string& shape, const MesoShapeValues& values = {});

  MesoShapePoint At(double u, double v) const;

  /// Number of segments that the shape is to be cut into, along u and v.
  std::array<int, 2> Segments() const { return this->Cuts; }
  bool ClosesAlongU() const { return this->Form != Plane; }
  bool ClosesAlongV() const { return this->Form == Torus; }
  /// Whether the edges v = 0 and v = 1 are single positions.
  bool HasPoles() const { return this->Form == Sphere; }

private:
  enum Forms
  {
    Plane,
    Sphere,
    Cylinder,
    Torus
  };
  Forms Form = Plane;
  double A = 1.; ///< width, or radius
  double B = 1.; ///< height, or the tube's radius
  std::array<int, 2> Cuts = { 1, 1 };
};

#endif

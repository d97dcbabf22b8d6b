#ifndef MesoDisplacement_h
#define MesoDisplacement_h

/**
 * @class MesoDisplacement
 * @brief Evaluates the displaced surface q = p + (h - r) D n over a triangle mesh, in double.
 *
 * In each triangle p is linear, n is the vertices' unit normals interpolated linearly and then made
 * unit, and h, in [0,1], is read bilinearly at the map coordinates (s, t) = (u, v) x tiles, which
 * are linear too. D >= 0 is in object units, r in [0,1] is the height that lies on the mesh.
 *
 * The shading normal is q_s x q_t (Blinn1978; Marschner2008) with
 *
 *     q_s = P p_s + D (h_s n + (h - r) n_s),    P p_s = p_s - n (n . p_s),
 *
 * and q_t alike, turned to the side of n where the height is constant. h_s, h_t are central
 * differences of one texel, interpolated bilinearly (heightGradient of Shaders/Kernels); n_s and n_t
 * are the derivatives of the unit normal. P carries the triangle's own p_s into the plane of which n
 * is the normal, so that a flat map leaves a mesh as smooth as its normals say. Where the texture
 * coordinates have no area, or the sum no direction, the normal is n.
 *
 * @sa MesoDicePlan, vtkMesoDisplacedMesh
 */

#include "MesoKernels.h"
#include "MesoTriangleMesh.h"

#include <vector>

/// A place on the base mesh.
struct MesoBasePoint
{
  MesoVector Position;
  MesoVector Normal;                ///< interpolated, not unit
  std::array<double, 2> Coordinate; ///< the mesh's own
};

/// A place on the displaced surface.
struct MesoDisplacedPoint
{
  MesoVector Position;
  MesoVector UnitNormal;               ///< of the base
  std::array<double, 2> MapCoordinate; ///< (s, t)
  double Height;
};

class MesoDisplacement
{
public:
  /// The base mesh: a normal (unit) and a coordinate each point. All are kept by reference.
  struct Base
  {
    const MesoTriangleMesh& Mesh;
    const std::vector<MesoVector>& Normals;
    const std::vector<std::array<double, 2>>& Coordinates;
    double NormalRounding = 0.;     ///< of the stored normals' components
    double CoordinateRounding = 0.; ///< of the stored coordinates, relative to their size
  };

  MesoDisplacement(const Base& base, const MesoKernels::Double::HeightField& heights,
    std::array<double, 2> tiles, double scale, double reference);

  /// Derivatives of a triangle's linear functions with respect to s and t; none where the texture
  /// coordinates have no area but for rounding.
  struct Derivatives
  {
    bool Valid = false;
    std::array<MesoVector, 2> Position;
    std::array<MesoVector, 2> Normal; ///< of the interpolated one
  };
  Derivatives DerivativesOf(std::int64_t triangle) const;

  /// A point of the mesh.
  MesoBasePoint At(std::int64_t point) const;
  /// The fraction `along` of the way between two points of the mesh, exactly theirs at 0 and where
  /// the two agree.
  MesoBasePoint Between(std::int64_t from, std::int64_t to, double along) const;
  /// With weights (1 - i - j, i, j) of the triangle's corners.
  MesoBasePoint Inside(std::int64_t triangle, double i, double j) const;

  MesoDisplacedPoint Displaced(const MesoBasePoint& base) const;
  /// (h_s, h_t) of the shading normal.
  std::array<double, 2> Gradient(const MesoDisplacedPoint& point) const;
  MesoVector ShadingNormal(const Derivatives& triangle, const MesoBasePoint& base,
    const MesoDisplacedPoint& point, const std::array<double, 2>& gradient) const;

  /// Whether two places on different sides of an edge, of equal base position, are one: normals and
  /// heights agree within the rounding of stored normals and texture coordinates.
  bool Agree(const MesoDisplacedPoint& a, const MesoDisplacedPoint& b) const;

private:
  Base Mesh;
  const MesoKernels::Double::HeightField& Heights;
  std::array<double, 2> Tiles;
  double Scale;
  double Reference;
};

#endif

#ifndef MesoBasePatch_h
#define MesoBasePatch_h

/**
 * @file MesoBasePatch.h
 * @brief A piece of a base surface as a function of texel coordinates, with bounds of its bending.
 *
 * A patch gives position P and unit normal N in object space, with their derivatives, for (x, y)
 * in a domain: a triangle, or a rectangle. Where there is no map, or a triangle's texture
 * coordinates span no area, (x, y) are the barycentric coordinates of its second and third corner.
 */

#include "MesoBox.h"
#include "MesoShape.h"
#include "mesoRenderingReferenceModule.h" // for export macro

#include <array>

struct MesoRect
{
  double X0;
  double X1;
  double Y0;
  double Y1;

  bool Empty() const { return !(this->X0 <= this->X1 && this->Y0 <= this->Y1); }
};

/// Base surface at a point: position, unit normal, and their derivatives along x and y.
struct MesoBasePoint
{
  glm::dvec3 P;
  glm::dvec3 Px;
  glm::dvec3 Py;
  glm::dvec3 N;
  glm::dvec3 Nx;
  glm::dvec3 Ny;
};

/// Upper bounds, on a rectangle, of the lengths of derivatives.
struct MesoBaseBends
{
  double Pxx = 0.;
  double Pxy = 0.;
  double Pyy = 0.;
  double Nx = 0.;
  double Ny = 0.;
  double Nxx = 0.;
  double Nxy = 0.;
  double Nyy = 0.;
  bool Wild = false; ///< no bounds of N are known here but |N| <= 1
};

class MESORENDERINGREFERENCE_EXPORT MesoBasePatch
{
public:
  virtual ~MesoBasePatch() = default;

  /// The surface at the middle of a rectangle, and bounds on all of it; the rectangle may reach
  /// out of the domain.
  virtual void Evaluate(
    const MesoRect& rect, MesoBasePoint& middle, MesoBaseBends& bends) const = 0;

  /// The surface at a point.
  MesoBasePoint At(double x, double y) const;

  /// Whether a rectangle lies outside of the domain; false where in doubt.
  virtual bool Misses(const MesoRect& rect) const = 0;
  /// Whether a point lies in the domain, its edges widened by rounding.
  virtual bool Contains(double x, double y) const = 0;
  /// Corners of the domain as weights of a triangle's three corners; of a rectangle (0, 0, 0).
  virtual glm::dvec3 Weights(double x, double y) const = 0;

  /// A box, in the space that `matrix` leads to, around P + g N for all g in [low, high].
  virtual MesoBox Bounds(const glm::dmat4& matrix, double low, double high) const = 0;

  /// The least rectangle around the domain.
  const MesoRect& Domain() const { return this->Around; }
  /// +1 where Px x Py points to the front side, by the patch's own winding, else -1.
  double Orientation() const { return this->Sign; }

protected:
  MesoRect Around = { 0., 1., 0., 1. };
  double Sign = 1.;
};

/// A triangle with P linear and N linear, then normalised.
class MESORENDERINGREFERENCE_EXPORT MesoTrianglePatch final : public MesoBasePatch
{
public:
  /// Corners' positions, normals (of any length) and places (x, y), which must span an area. The
  /// front is the side from which the corners run counter-clockwise; clockwise where a mirror is
  /// still to come.
  MesoTrianglePatch(const std::array<glm::dvec3, 3>& positions,
    const std::array<glm::dvec3, 3>& normals, const std::array<glm::dvec2, 3>& places,
    bool mirrored = false);

  void Evaluate(const MesoRect& rect, MesoBasePoint& middle, MesoBaseBends& bends) const override;
  bool Misses(const MesoRect& rect) const override;
  bool Contains(double x, double y) const override;
  glm::dvec3 Weights(double x, double y) const override;
  MesoBox Bounds(const glm::dmat4& matrix, double low, double high) const override;

  /// Whether places span an area that can be divided by.
  static bool Spans(const std::array<glm::dvec2, 3>& places);

private:
  glm::dvec2 Start; ///< (x, y) of corner 0
  glm::dvec3 P0;
  glm::dvec3 Px;
  glm::dvec3 Py;
  glm::dvec3 M0; ///< the normal before it is normalised
  glm::dvec3 Mx;
  glm::dvec3 My;
  glm::dvec2 Weight1; ///< change of the weight of corner 1 along x and y
  glm::dvec2 Weight2;
};

/// A rectangle of a built-in shape: (u, v) = perX * (x + 0.5), perY * (y + 0.5).
class MESORENDERINGREFERENCE_EXPORT MesoShapePatch final : public MesoBasePatch
{
public:
  MesoShapePatch(const MesoShape& shape, const MesoRect& rect, double perX, double perY);

  void Evaluate(const MesoRect& rect, MesoBasePoint& middle, MesoBaseBends& bends) const override;
  bool Misses(const MesoRect& rect) const override;
  bool Contains(double x, double y) const override;
  glm::dvec3 Weights(double x, double y) const override;
  MesoBox Bounds(const glm::dmat4& matrix, double low, double high) const override;

private:
  const MesoShape& Shape;
  double PerX;
  double PerY;
};

#endif

#ifndef MesoShapeForms_h
#define MesoShapeForms_h

/**
 * @file MesoShapeForms.h
 * @brief The closed forms behind MesoShape. Not installed.
 */

#include "MesoShape.h"

#include <functional>
#include <memory>

/// A shape's charts, each a function of its own (a, b) in [0,1] x [0,1], with b from pole to pole where
/// there are any. MesoShape carries derivatives over to texture coordinates.
class MesoShape::Form
{
public:
  virtual ~Form() = default;
  virtual std::vector<MesoShapeChart> Charts() const = 0;
  /// The surface, its Scale per unit of a and b.
  virtual MesoShapePoint At(std::size_t chart, double a, double b) const = 0;
  virtual bool IsFlat() const { return false; }
  virtual bool HasBends() const { return false; }
  /// For a shape with HasBends(), which has one chart: (a, b) = (u, v).
  virtual MesoShapeBends BendsAround(
    const MesoShapePoint& middle, double u, double v, double halfU, double halfV) const;
};

/// Numbers of a key, given or by default.
using MesoShapeNumbers = std::function<std::vector<double>(const char* key)>;

using MesoShapeFormPointer = std::shared_ptr<const MesoShape::Form>;

///@{
/// The form of a shape whose values are right.
MesoShapeFormPointer MesoMakeRevolvedForm(const std::string& shape,
  const MesoShapeNumbers& numbers); ///< sphere, cylinder, cone, torus, vase
MesoShapeFormPointer MesoMakeSheetForm(
  const std::string& shape, const MesoShapeNumbers& numbers); ///< plane, cube, undulating
MesoShapeFormPointer MesoMakeTeapotForm(const MesoShapeNumbers& numbers);
MesoShapeFormPointer MesoMakeBranchForm(const MesoShapeNumbers& numbers);
///@}

/// Sine and cosine of a number of full turns. Whole turns give the same bits, and quarter turns give
/// exactly 0 and 1, so that seams and poles close without a gap.
struct MesoTurned
{
  double Sine;
  double Cosine;

  explicit MesoTurned(double turns);
};

///@{
/// Triples of doubles.
using MesoTriple = std::array<double, 3>;

inline MesoTriple MesoCombined(double x, const MesoTriple& a, double y, const MesoTriple& b)
{
  return { x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2] };
}

/// Splits a vector into its direction and its length; (1, 0, 0) where it has none.
MesoTriple MesoDirectionOf(const MesoTriple& a, double& length);
///@}

#endif

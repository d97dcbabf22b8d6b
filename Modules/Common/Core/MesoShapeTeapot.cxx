#include "MesoShapeForms.h"

#include <cmath>

/*
 * Martin Newell's teapot of 1975, by the control points of its 32 Bezier patches that Crow published
 * ("The Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987). Twenty-four of
 * them are quarters of figures of revolution, products of a profile (r, z) and an arc; eight are
 * halves of handle and spout, the other halves their mirror images. In the original x runs from the
 * handle to the spout and z up. One number differs: the arcs of the knob's widest control points are
 * 0.5625 there and 0.56 here, as all others are, which moves the knob by less than 5e-4.
 */

namespace
{
using Curve = std::array<std::array<double, 2>, 4>; ///< (r, z)
using Patch = std::array<std::array<MesoTriple, 4>, 4>;

constexpr double Height = 3.15;   ///< of the original
constexpr double BodyRadius = 2.; ///< of the original
constexpr double ArcPoint = 0.56; ///< the quarter circle is (1, 0), (1, this), (this, 1), (0, 1)

/// From the middle of the bottom to the inner edge of the rim.
constexpr Curve Pot[4] = { { { { 0., 0. }, { 1.425, 0. }, { 1.5, 0.075 }, { 1.5, 0.15 } } },
  { { { 1.5, 0.15 }, { 1.5, 0.225 }, { 2., 0.45 }, { 2., 0.9 } } },
  { { { 2., 0.9 }, { 2., 1.35 }, { 1.75, 1.875 }, { 1.5, 2.4 } } },
  { { { 1.5, 2.4 }, { 1.4375, 2.53125 }, { 1.3375, 2.53125 }, { 1.4, 2.4 } } } };

/// From the lid's edge to the middle of the knob.
constexpr Curve Lid[2] = { { { { 1.3, 2.4 }, { 1.3, 2.55 }, { 0.4, 2.55 }, { 0.2, 2.7 } } },
  { { { 0.2, 2.7 }, { 0., 2.85 }, { 0.8, 3.15 }, { 0., 3.15 } } } };

/// Along the handle, from the body out and down; across, from its inner side to its outer one.
constexpr Patch Handle[2] = {
  { { { { { -1.6, 0., 2.025 }, { -1.6, -0.3, 2.025 }, { -1.5, -0.3, 2.25 }, { -1.5, 0., 2.25 } } },
    { { { -2.3, 0., 2.025 }, { -2.3, -0.3, 2.025 }, { -2.5, -0.3, 2.25 }, { -2.5, 0., 2.25 } } },
    { { { -2.7, 0., 2.025 }, { -2.7, -0.3, 2.025 }, { -3., -0.3, 2.25 }, { -3., 0., 2.25 } } },
    { { { -2.7, 0., 1.8 }, { -2.7, -0.3, 1.8 }, { -3., -0.3, 1.8 }, { -3., 0., 1.8 } } } } },
  { { { { { -2.7, 0., 1.8 }, { -2.7, -0.3, 1.8 }, { -3., -0.3, 1.8 }, { -3., 0., 1.8 } } },
    { { { -2.7, 0., 1.575 }, { -2.7, -0.3, 1.575 }, { -3., -0.3, 1.35 }, { -3., 0., 1.35 } } },
    { { { -2.5, 0., 1.125 }, { -2.5, -0.3, 1.125 }, { -2.65, -0.3, 0.9375 },
      { -2.65, 0., 0.9375 } } },
    { { { -2., 0., 0.9 }, { -2., -0.3, 0.9 }, { -1.9, -0.3, 0.6 }, { -1.9, 0., 0.6 } } } } }
};

/// Along the spout, from the body out and up; across, from its upper side to its lower one.
constexpr Patch Spout[2] = {
  { { { { { 1.7, 0., 1.425 }, { 1.7, -0.66, 1.425 }, { 1.7, -0.66, 0.6 }, { 1.7, 0., 0.6 } } },
    { { { 2.6, 0., 1.425 }, { 2.6, -0.66, 1.425 }, { 3.1, -0.66, 0.825 }, { 3.1, 0., 0.825 } } },
    { { { 2.3, 0., 2.1 }, { 2.3, -0.25, 2.1 }, { 2.4, -0.25, 2.025 }, { 2.4, 0., 2.025 } } },
    { { { 2.7, 0., 2.4 }, { 2.7, -0.25, 2.4 }, { 3.3, -0.25, 2.4 }, { 3.3, 0., 2.4 } } } } },
  { { { { { 2.7, 0., 2.4 }, { 2.7, -0.25, 2.4 }, { 3.3, -0.25, 2.4 }, { 3.3, 0., 2.4 } } },
    { { { 2.8, 0., 2.475 }, { 2.8, -0.25, 2.475 }, { 3.525, -0.25, 2.49375 },
      { 3.525, 0., 2.49375 } } },
    { { { 2.9, 0., 2.475 }, { 2.9, -0.15, 2.475 }, { 3.45, -0.15, 2.5125 },
      { 3.45, 0., 2.5125 } } },
    { { { 2.8, 0., 2.4 }, { 2.8, -0.15, 2.4 }, { 3.2, -0.15, 2.4 }, { 3.2, 0., 2.4 } } } } }
};

/// Bernstein's polynomials of degree 3, exactly 0 and 1 at the ends, and their derivatives.
struct Cubic
{
  std::array<double, 4> Value;
  std::array<double, 4> Derivative;

  explicit Cubic(double t)
  {
    const double s = 1. - t;
    this->Value = { s * s * s, 3. * s * s * t, 3. * s * t * t, t * t * t };
    this->Derivative = { -3. * s * s, 3. * s * s - 6. * s * t, 6. * s * t - 3. * t * t,
      3. * t * t };
  }
};

double Weighted(const std::array<double, 4>& weights, double a, double b, double c, double d)
{
  return weights[0] * a + weights[1] * b + weights[2] * c + weights[3] * d;
}

/// A piece of the pot and its cell of the texture, in twelfths of u and eighths of v, which are about
/// as long as each other on the surface.
struct Piece
{
  enum Kinds
  {
    Quarter,     ///< of a figure of revolution
    Half,        ///< of handle or spout, on the side of +z; b runs against the patch's order
    MirroredHalf ///< its mirror image on the side of -z; b runs with it
  };
  Kinds Kind;
  const Curve* Profile;
  const Patch* Points;
  int Number; ///< of the quarter
  std::array<double, 2> Low;
  std::array<double, 2> High;
  bool PoleAtStart = false;
  bool PoleAtEnd = false;
};

std::vector<Piece> MakePieces()
{
  std::vector<Piece> pieces;
  const double potRows[] = { 0., 1.5, 2.5, 4., 4.5 };
  const double lidRows[] = { 5., 6.25, 7. };
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    for (int row = 0; row < 4; ++row)
    {
      pieces.push_back({ Piece::Quarter, &Pot[row], nullptr, quarter,
        { 3. * quarter, potRows[row] }, { 3. * quarter + 3., potRows[row + 1] }, row == 0 });
    }
    for (int row = 0; row < 2; ++row)
    {
      pieces.push_back({ Piece::Quarter, &Lid[row], nullptr, quarter,
        { 2. * quarter, lidRows[row] }, { 2. * quarter + 2., lidRows[row + 1] }, false, row == 1 });
    }
  }
  const double spoutColumns[] = { 8.5, 10.75, 11.5 };
  const double handleColumns[] = { 8.5, 10., 11.5 };
  for (int along = 0; along < 2; ++along)
  {
    for (int side = 0; side < 2; ++side)
    {
      const auto kind = side == 0 ? Piece::Half : Piece::MirroredHalf;
      pieces.push_back({ kind, nullptr, &Spout[along], 0, { spoutColumns[along], 5. + side },
        { spoutColumns[along + 1], 6. + side } });
      pieces.push_back(
        { kind, nullptr, &Handle[along], 0, { handleColumns[along], 7. + 0.5 * side },
          { handleColumns[along + 1], 7.5 + 0.5 * side } });
    }
  }
  return pieces;
}

const std::vector<Piece>& Pieces()
{
  static const std::vector<Piece> pieces = MakePieces();
  return pieces;
}

class TeapotForm final : public MesoShape::Form
{
public:
  TeapotForm(double radius, int segments)
    : Scale(radius / BodyRadius)
    , Segments(segments)
  {
  }

  std::vector<MesoShapeChart> Charts() const override
  {
    std::vector<MesoShapeChart> charts;
    for (const Piece& piece : Pieces())
    {
      charts.push_back(
        { { this->Segments, this->Segments }, { piece.Low[0] / 12., piece.Low[1] / 8. },
          { piece.High[0] / 12., piece.High[1] / 8. }, piece.PoleAtStart, piece.PoleAtEnd });
    }
    return charts;
  }

  MesoShapePoint At(std::size_t chart, double a, double b) const override
  {
    const Piece& piece = Pieces()[chart];
    return piece.Kind == Piece::Quarter ? this->AtQuarter(piece, a, b) : this->AtHalf(piece, a, b);
  }

private:
  /// A point of the original, (x, z, -y) and moved to the middle of its height.
  MesoTriple Placed(double x, double up, double z) const
  {
    return { this->Scale * x, this->Scale * (up - 0.5 * Height), this->Scale * z };
  }

  MesoShapePoint AtQuarter(const Piece& piece, double a, double b) const
  {
    // Eastward from -z: each quarter begins where the one before it ended.
    static constexpr double corners[5][2] = { { 0., -1. }, { -1., 0. }, { 0., 1. }, { 1., 0. },
      { 0., -1. } };
    const auto& from = corners[piece.Number];
    const auto& to = corners[piece.Number + 1];
    const Cubic around(a);
    const double start = Weighted(around.Value, 1., 1., ArcPoint, 0.);
    const double end = Weighted(around.Value, 0., ArcPoint, 1., 1.);
    const double startRate = Weighted(around.Derivative, 1., 1., ArcPoint, 0.);
    const double endRate = Weighted(around.Derivative, 0., ArcPoint, 1., 1.);
    const double x = start * from[0] + end * to[0];
    const double z = start * from[1] + end * to[1];
    const double xRate = startRate * from[0] + endRate * to[0];
    const double zRate = startRate * from[1] + endRate * to[1];

    const Cubic along(b);
    const Curve& p = *piece.Profile;
    const auto blend = [&](const std::array<double, 4>& weights, std::size_t k)
    { return Weighted(weights, p[0][k], p[1][k], p[2][k], p[3][k]); };
    const double radius = blend(along.Value, 0);
    const double radiusRate = blend(along.Derivative, 0);
    const double upRate = blend(along.Derivative, 1);

    MesoShapePoint point;
    point.Position = this->Placed(radius * x, blend(along.Value, 1), radius * z);
    point.Tangent = MesoDirectionOf({ xRate, 0., zRate }, point.Scale[0]);
    point.Scale[0] *= this->Scale * radius;
    point.Bitangent = MesoDirectionOf({ radiusRate * x, upRate, radiusRate * z }, point.Scale[1]);
    point.Scale[1] *= this->Scale;
    // Without the radius, which is 0 at a pole: (xRate, 0, zRate) x the change along the profile.
    double length;
    point.Normal = MesoDirectionOf(
      { -zRate * upRate, radiusRate * (zRate * x - xRate * z), xRate * upRate }, length);
    return point;
  }

  MesoShapePoint AtHalf(const Piece& piece, double a, double b) const
  {
    const bool mirrored = piece.Kind == Piece::MirroredHalf;
    const Cubic along(a);
    const Cubic across(mirrored ? b : 1. - b);
    const double turn = mirrored ? 1. : -1.;
    MesoTriple place = { 0., 0., 0. };
    MesoTriple rateA = { 0., 0., 0. };
    MesoTriple rateB = { 0., 0., 0. };
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = 0; j < 4; ++j)
      {
        const MesoTriple& point = (*piece.Points)[i][j];
        place = MesoCombined(1., place, along.Value[i] * across.Value[j], point);
        rateA = MesoCombined(1., rateA, along.Derivative[i] * across.Value[j], point);
        rateB = MesoCombined(1., rateB, turn * along.Value[i] * across.Derivative[j], point);
      }
    }
    const double side = mirrored ? 1. : -1.;
    const auto turned = [side](const MesoTriple& v) {
      return MesoTriple{ v[0], v[2], side * v[1] };
    };
    MesoShapePoint point;
    point.Position = this->Placed(place[0], place[2], side * place[1]);
    rateA = turned(rateA);
    rateB = turned(rateB);
    point.Tangent = MesoDirectionOf(rateA, point.Scale[0]);
    point.Bitangent = MesoDirectionOf(rateB, point.Scale[1]);
    point.Scale[0] *= this->Scale;
    point.Scale[1] *= this->Scale;
    double length;
    point.Normal = MesoDirectionOf(
      { rateA[1] * rateB[2] - rateA[2] * rateB[1], rateA[2] * rateB[0] - rateA[0] * rateB[2],
        rateA[0] * rateB[1] - rateA[1] * rateB[0] },
      length);
    return point;
  }

  double Scale;
  int Segments;
};
}

MesoShapeFormPointer MesoMakeTeapotForm(const MesoShapeNumbers& numbers)
{
  return std::make_shared<TeapotForm>(
    numbers("radius")[0], static_cast<int>(numbers("segments")[0]));
}

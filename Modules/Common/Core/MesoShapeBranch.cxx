#include "MesoShapeForms.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;
constexpr double TwoPi = 2. * Pi;

/// The golden angle in turns: side shoots so far apart never stand above each other.
constexpr double GoldenTurn = 0.381966011250105;

/**
 * A bent, tapering tube: circles about a plane curve C(w) = origin + f(w) E1 + g(w) E2, w in [0,1],
 * with half spheres at its ends. With T = C' / s, N at right angles to it in the plane and B = E2 x E1,
 *
 *     P = C + r (cos a N + sin a B),   P_w = (s - k r cos a) T + r' (cos a N + sin a B)
 *
 * where k = (f'' g' - g'' f') / s^2 is N's turn with w. The radius r goes from one to the other by
 * w^2 (3 - 2 w), so that the half spheres continue it smoothly.
 */
class Limb
{
public:
  MesoTriple Origin = { 0., 0., 0. };
  MesoTriple E1 = { 1., 0., 0. };
  MesoTriple E2 = { 0., 1., 0. };
  double Length = 1.; ///< of the curve, about
  double RadiusAtStart = 1.;
  double RadiusAtEnd = 1.;
  bool CapAtStart = false;
  bool CapAtEnd = false;
  /// f, g, and their first and second derivatives, at w.
  std::function<std::array<double, 6>(double)> Curve;

  double RadiusAt(double w) const
  {
    return this->RadiusAtStart + (this->RadiusAtEnd - this->RadiusAtStart) * w * w * (3. - 2. * w);
  }

  MesoTriple Centre(double w) const
  {
    const auto c = this->Curve(w);
    const MesoTriple way = MesoCombined(c[0], this->E1, c[1], this->E2);
    return MesoCombined(1., this->Origin, 1., way);
  }

  /// At (a, b) of the chart: once around, and along the surface's length.
  MesoShapePoint At(double a, double b) const
  {
    const double start = this->CapAtStart ? 0.5 * Pi * this->RadiusAtStart : 0.;
    const double end = this->CapAtEnd ? 0.5 * Pi * this->RadiusAtEnd : 0.;
    const double whole = start + this->Length + end;
    const double place = b * whole;
    // The half spheres' angle from the ring where they begin, in turns.
    double lift = 0.;
    double w = (place - start) / this->Length;
    if (b < start / whole)
    {
      w = 0.;
      lift = -0.25 * (1. - place / start);
    }
    else if (b > 1. - end / whole)
    {
      w = 1.;
      lift = 0.25 * (1. - (1. - b) * whole / end);
    }
    return this->Evaluate(a, std::clamp(w, 0., 1.), lift, whole);
  }

private:
  MesoShapePoint Evaluate(double a, double w, double lift, double whole) const
  {
    const auto c = this->Curve(w);
    const double speed = std::hypot(c[2], c[3]);
    const MesoTriple forward = MesoCombined(c[2] / speed, this->E1, c[3] / speed, this->E2);
    const MesoTriple side = MesoCombined(c[3] / speed, this->E1, -c[2] / speed, this->E2);
    const MesoTriple& x = this->E2;
    const MesoTriple& y = this->E1;
    const MesoTriple across = { x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
      x[0] * y[1] - x[1] * y[0] };
    const MesoTurned around(a + 0.5);
    const MesoTurned up(lift);
    const MesoTriple out = MesoCombined(around.Cosine, side, around.Sine, across);
    const double radius = this->RadiusAt(w);

    MesoShapePoint point;
    point.Tangent = MesoCombined(-around.Sine, side, around.Cosine, across);
    const MesoTriple round = MesoCombined(up.Cosine, out, up.Sine, forward);
    point.Position = MesoCombined(1., this->Centre(w), radius, round);
    point.Scale[0] = TwoPi * radius * up.Cosine;
    if (lift != 0.)
    {
      point.Normal = round;
      point.Bitangent = MesoCombined(-up.Sine, out, up.Cosine, forward);
      point.Scale[1] = whole; // a quarter circle is as long as its part of b
      return point;
    }
    const double taper =
      6. * w * (1. - w) * (this->RadiusAtEnd - this->RadiusAtStart) / this->Length;
    const double bend = (c[4] * c[3] - c[5] * c[2]) / (speed * speed);
    const double advance = (speed - bend * radius * around.Cosine) / this->Length;
    point.Bitangent = MesoDirectionOf(MesoCombined(advance, forward, taper, out), point.Scale[1]);
    point.Scale[1] *= whole;
    double length;
    point.Normal = MesoDirectionOf(MesoCombined(advance, out, -taper, forward), length);
    return point;
  }
};

/// A trunk, bent to an S, and side shoots that begin on its axis.
class BranchForm final : public MesoShape::Form
{
public:
  explicit BranchForm(const MesoShapeNumbers& numbers)
    : Rings(static_cast<int>(numbers("rings")[0]))
    , Sides(static_cast<int>(numbers("sides")[0]))
  {
    const double radius = numbers("radius")[0];
    const double length = numbers("length")[0];
    const bool caps = numbers("caps")[0] != 0.;
    Limb trunk;
    trunk.Length = length;
    trunk.RadiusAtStart = radius;
    trunk.RadiusAtEnd = 0.6 * radius;
    trunk.CapAtStart = caps;
    trunk.CapAtEnd = caps;
    const double amplitude = MostBend * numbers("bend")[0] * length;
    trunk.Curve = [amplitude, length](double w)
    {
      const double turn = TwoPi * w;
      return std::array<double, 6>{ amplitude * std::sin(turn), length * (w - 0.5),
        amplitude * TwoPi * std::cos(turn), length, -amplitude * TwoPi * TwoPi * std::sin(turn),
        0. };
    };
    this->Limbs.push_back(trunk);
    const int shoots = static_cast<int>(numbers("shoots")[0]);
    for (int i = 0; i < shoots; ++i)
    {
      const double where = 0.3 + 0.4 * (i + 0.5) / shoots;
      Limb shoot;
      shoot.Origin = trunk.Centre(where);
      const MesoTurned azimuth(GoldenTurn * i + 0.2);
      shoot.E1 = { azimuth.Sine, 0., azimuth.Cosine };
      shoot.Length = 0.4 * length;
      shoot.RadiusAtStart = 0.55 * trunk.RadiusAt(where);
      shoot.RadiusAtEnd = 0.35 * trunk.RadiusAt(where);
      shoot.CapAtEnd = caps;
      // From 60 degrees off the vertical to 20, evenly; the way along the chord is a little shorter.
      shoot.Curve = [reach = shoot.Length](double w)
      {
        const double f[2] = { 0.866, 0.342 };
        const double g[2] = { 0.5, 0.94 };
        const auto way = [&](const double* rate)
        { return reach * w * (rate[0] + 0.5 * w * (rate[1] - rate[0])); };
        return std::array<double, 6>{ way(f), way(g), reach * (f[0] + w * (f[1] - f[0])),
          reach * (g[0] + w * (g[1] - g[0])), reach * (f[1] - f[0]), reach * (g[1] - g[0]) };
      };
      this->Limbs.push_back(shoot);
    }
  }

  std::vector<MesoShapeChart> Charts() const override
  {
    std::vector<MesoShapeChart> charts;
    for (std::size_t i = 0; i < this->Limbs.size(); ++i)
    {
      const Limb& limb = this->Limbs[i];
      MesoShapeChart chart;
      chart.Segments = i == 0 ? std::array<int, 2>{ this->Sides, this->Rings }
                              : std::array<int, 2>{ this->Sides / 2, this->Rings / 2 };
      if (i == 0)
      {
        chart.High = { 0.5, 1. };
      }
      else
      {
        const double column = (i - 1) % 2 == 0 ? 0.5 : 0.75;
        const double row = (i - 1) / 2 == 0 ? 0. : 0.5;
        chart.Low = { column, row };
        chart.High = { column + 0.25, row + 0.5 };
      }
      chart.PoleAtStart = limb.CapAtStart;
      chart.PoleAtEnd = limb.CapAtEnd;
      charts.push_back(chart);
    }
    return charts;
  }

  MesoShapePoint At(std::size_t chart, double a, double b) const override
  {
    return this->Limbs[chart].At(a, b);
  }

private:
  /// Of the length. The curve's radius of curvature then is length / (4 pi^2 .08) or more, so that a
  /// tube of a quarter of the length would still not meet itself.
  static constexpr double MostBend = 0.08;

  int Rings;
  int Sides;
  std::vector<Limb> Limbs;
};
}

MesoShapeFormPointer MesoMakeBranchForm(const MesoShapeNumbers& numbers)
{
  return std::make_shared<BranchForm>(numbers);
}

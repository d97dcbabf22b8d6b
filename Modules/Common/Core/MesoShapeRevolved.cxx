#include "MesoShapeForms.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;
constexpr double TwoPi = 2. * Pi;

/// A curve in the half plane of "out" (away from the axis) and y.
struct Profile
{
  double Out;
  double Y;
  double NormalOut; ///< the unit normal (cos f, sin f)
  double NormalY;
  double Speed; ///< along v; the direction is (-NormalY, NormalOut)
  double Turn;  ///< df / dv
};

/// Upper bounds of a profile, on a range of v.
struct ProfileBends
{
  double Speed;    ///< of Out alone
  double Change;   ///< of the second derivative
  double Turn;     ///< of df / dv
  double TurnRate; ///< of its derivative
};

/// A profile turned about the y axis: u goes around it, v along the profile.
class RevolvedForm : public MesoShape::Form
{
public:
  RevolvedForm(int sides, int rings)
    : Grid{ { sides, rings } }
  {
  }

  std::vector<MesoShapeChart> Charts() const override { return { this->Grid }; }
  bool HasBends() const override { return true; }

  MesoShapePoint At(std::size_t, double u, double v) const override
  {
    // Half a turn on: the seam is at -z. "out" is (around.Sine, 0, around.Cosine).
    const MesoTurned around(u + 0.5);
    const Profile at = this->ProfileAt(v);
    return { { at.Out * around.Sine, at.Y, at.Out * around.Cosine },
      { at.NormalOut * around.Sine, at.NormalY, at.NormalOut * around.Cosine },
      { around.Cosine, 0., -around.Sine },
      { -at.NormalY * around.Sine, at.NormalOut, -at.NormalY * around.Cosine },
      { TwoPi * at.Out, at.Speed } };
  }

  MesoShapeBends BendsAround(
    const MesoShapePoint& middle, double, double v, double, double halfV) const override
  {
    const Profile at = this->ProfileAt(v);
    const ProfileBends most = this->BendsOf(v, halfV);
    MesoShapeBends bends;
    for (int k = 0; k < 3; ++k)
    {
      bends.NormalU[k] = TwoPi * at.NormalOut * middle.Tangent[k];
      bends.NormalV[k] = at.Turn * middle.Bitangent[k];
    }
    // Turning about the axis keeps lengths, so P_uu <= 2 pi P_u and so on.
    const double mostPu = TwoPi * (at.Out + most.Speed * halfV);
    bends.Nu = TwoPi * std::min(1., std::abs(at.NormalOut) + most.Turn * halfV);
    bends.Nv = most.Turn;
    bends.Puu = TwoPi * mostPu;
    bends.Puv = TwoPi * most.Speed;
    bends.Pvv = most.Change;
    bends.Nuu = TwoPi * bends.Nu;
    bends.Nuv = TwoPi * most.Turn;
    bends.Nvv = most.Turn * most.Turn + most.TurnRate;
    return bends;
  }

protected:
  virtual Profile ProfileAt(double v) const = 0;
  virtual ProfileBends BendsOf(double v, double halfV) const = 0;

  MesoShapeChart Grid;
};

/// An arc of a circle about (Middle, 0): all of it (torus), or the half from pole to pole (sphere).
class CircleForm final : public RevolvedForm
{
public:
  CircleForm(double middle, double radius, int sides, int rings)
    : RevolvedForm(sides, rings)
    , Middle(middle)
    , Radius(radius)
    , Whole(middle > 0.)
  {
    this->Grid.PoleAtStart = !this->Whole;
    this->Grid.PoleAtEnd = !this->Whole;
  }

private:
  double Turn() const { return this->Whole ? TwoPi : Pi; }

  Profile ProfileAt(double v) const override
  {
    const MesoTurned up(this->Whole ? v + 0.5 : 0.5 * (v - 0.5));
    return { this->Middle + this->Radius * up.Cosine, this->Radius * up.Sine, up.Cosine, up.Sine,
      this->Turn() * this->Radius, this->Turn() };
  }
  ProfileBends BendsOf(double, double) const override
  {
    const double speed = this->Turn() * this->Radius;
    return { speed, this->Turn() * speed, this->Turn(), 0. };
  }

  double Middle;
  double Radius;
  bool Whole;
};

/// A straight line from (bottom, -height / 2) to (top, height / 2).
class LineForm final : public RevolvedForm
{
public:
  LineForm(double bottom, double top, double height, int sides, int rings)
    : RevolvedForm(sides, rings)
    , Bottom(bottom)
    , Top(top)
    , Height(height)
    , Slant(std::hypot(bottom - top, height))
  {
    this->Grid.PoleAtEnd = top == 0.;
  }

private:
  Profile ProfileAt(double v) const override
  {
    return { this->Bottom + v * (this->Top - this->Bottom), (v - 0.5) * this->Height,
      this->Height / this->Slant, (this->Bottom - this->Top) / this->Slant, this->Slant, 0. };
  }
  ProfileBends BendsOf(double, double) const override
  {
    return { std::abs(this->Bottom - this->Top), 0., 0., 0. };
  }

  double Bottom;
  double Top;
  double Height;
  double Slant;
};

/// Out = radius f(v) with f a sum of cosines, y linear in v.
class VaseForm final : public RevolvedForm
{
public:
  VaseForm(double radius, double height, int sides, int rings)
    : RevolvedForm(sides, rings)
    , Radius(radius)
    , Height(height)
  {
  }

private:
  /// f = sum of Waves[k] cos(k pi v): a foot of .52, a belly of 1 at v = .38, a neck of .44 at .82
  /// and a lip of .53.
  static constexpr std::array<double, 6> Waves = { 0.716, 0.151, -0.208, -0.119, 0.018, -0.034 };

  /// The n-th derivative of radius f at v; with `bound`, what none is beyond.
  double Derivative(int n, double v, bool bound = false) const
  {
    double sum = 0.;
    for (std::size_t k = 0; k < Waves.size(); ++k)
    {
      const double rate = Pi * static_cast<double>(k);
      const double size = Waves[k] * std::pow(rate, n);
      sum += bound ? std::abs(size) : size * std::cos(rate * v + 0.5 * Pi * n);
    }
    return this->Radius * sum;
  }

  Profile ProfileAt(double v) const override
  {
    // The normal's angle is f = -atan(out' / height).
    const double slope = this->Derivative(1, v);
    const double speed = std::hypot(slope, this->Height);
    return { this->Derivative(0, v), (v - 0.5) * this->Height, this->Height / speed, -slope / speed,
      speed, -this->Derivative(2, v) * this->Height / (speed * speed) };
  }

  ProfileBends BendsOf(double v, double halfV) const override
  {
    const double third = this->Derivative(3, v, true);
    const double second = std::abs(this->Derivative(2, v)) + third * halfV;
    const double first = std::abs(this->Derivative(1, v)) + second * halfV;
    // df/dv = -out'' H / (H^2 + out'^2); in its derivative, x / (H^2 + x^2)^2 <= .325 / H^3.
    const double turn = second / this->Height;
    return { first, second, turn, third / this->Height + 0.65 * turn * turn };
  }

  double Radius;
  double Height;
};
}

MesoShapeFormPointer MesoMakeRevolvedForm(const std::string& shape, const MesoShapeNumbers& numbers)
{
  const auto number = [&](const char* key) { return numbers(key)[0]; };
  const double radius = number("radius");
  const int sides = static_cast<int>(number("sides"));
  const int rings = static_cast<int>(number("rings"));
  if (shape == "sphere")
  {
    return std::make_shared<CircleForm>(0., radius, sides, rings);
  }
  if (shape == "torus")
  {
    return std::make_shared<CircleForm>(radius, number("tube"), rings, sides);
  }
  const double height = number("height");
  if (shape == "vase")
  {
    return std::make_shared<VaseForm>(radius, height, sides, rings);
  }
  const double top = shape == "cone" ? number("top") : radius;
  return std::make_shared<LineForm>(radius, top, height, sides, rings);
}

#include "MesoShapeForms.h"

#include <cmath>

namespace
{
constexpr double TwoPi = 6.283185307179586476925287;

class PlaneForm final : public MesoShape::Form
{
public:
  PlaneForm(std::array<double, 2> size, std::array<int, 2> segments)
    : Size(size)
    , Segments(segments)
  {
  }
  std::vector<MesoShapeChart> Charts() const override { return { { this->Segments } }; }
  bool IsFlat() const override { return true; }
  MesoShapePoint At(std::size_t, double a, double b) const override
  {
    return { { (a - 0.5) * this->Size[0], (b - 0.5) * this->Size[1], 0. }, { 0., 0., 1. },
      { 1., 0., 0. }, { 0., 1., 0. }, this->Size };
  }

private:
  std::array<double, 2> Size;
  std::array<int, 2> Segments;
};

/// Faces -x, -y, -z below, +x, +y, +z above, each in a cell of 1/3 x 1/2.
class CubeForm final : public MesoShape::Form
{
public:
  CubeForm(const std::vector<double>& size, int segments)
    : Size{ size[0], size[1], size[2] }
    , Segments(segments)
  {
  }
  std::vector<MesoShapeChart> Charts() const override
  {
    std::vector<MesoShapeChart> charts;
    for (int face = 0; face < 6; ++face)
    {
      const int column = face % 3;
      const int row = face / 3;
      charts.push_back({ { this->Segments, this->Segments }, { column / 3., row / 2. },
        { (column + 1) / 3., (row + 1) / 2. } });
    }
    return charts;
  }
  bool IsFlat() const override { return true; }
  MesoShapePoint At(std::size_t chart, double a, double b) const override
  {
    // y is up on the faces around; the top and the bottom are seen with x to the right.
    const std::size_t axis = chart % 3;
    const double side = chart < 3 ? -1. : 1.;
    const std::size_t along = axis == 0 ? 2 : 0;
    const std::size_t up = axis == 1 ? 2 : 1;
    MesoShapePoint point = { { 0., 0., 0. }, { 0., 0., 0. }, { 0., 0., 0. }, { 0., 0., 0. },
      { this->Size[along], this->Size[up] } };
    point.Normal[axis] = side;
    point.Tangent[along] = axis == 0 ? -side : axis == 1 ? 1. : side;
    point.Bitangent[up] = axis == 1 ? -side : 1.;
    point.Position[axis] = 0.5 * side * this->Size[axis];
    point.Position[along] = (a - 0.5) * point.Tangent[along] * this->Size[along];
    point.Position[up] = (b - 0.5) * point.Bitangent[up] * this->Size[up];
    return point;
  }

private:
  std::array<double, 3> Size;
  int Segments;
};

/// z = amplitude cos(2 pi m (u - 1/2)) cos(2 pi n (v - 1/2)) over a rectangle.
class UndulatingForm final : public MesoShape::Form
{
public:
  UndulatingForm(const MesoShapeNumbers& numbers)
    : Amplitude(numbers("amplitude")[0])
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      this->Size[k] = numbers("size")[k];
      this->Rate[k] = TwoPi * numbers("waves")[k];
      this->Segments[k] = static_cast<int>(numbers("segments")[k]);
    }
  }
  std::vector<MesoShapeChart> Charts() const override { return { { this->Segments } }; }
  bool HasBends() const override { return true; }

  MesoShapePoint At(std::size_t, double u, double v) const override
  {
    const Waves at(*this, u, v);
    const double slopeX = at.Z(1, 0) / this->Size[0];
    const double slopeY = at.Z(0, 1) / this->Size[1];
    const double steepness = std::hypot(1., slopeX, slopeY);
    const double alongX = std::hypot(1., slopeX);
    const double alongY = std::hypot(1., slopeY);
    return { { (u - 0.5) * this->Size[0], (v - 0.5) * this->Size[1], at.Z(0, 0) },
      { -slopeX / steepness, -slopeY / steepness, 1. / steepness },
      { 1. / alongX, 0., slopeX / alongX }, { 0., 1. / alongY, slopeY / alongY },
      { alongX * this->Size[0], alongY * this->Size[1] } };
  }

  MesoShapeBends BendsAround(
    const MesoShapePoint& middle, double u, double v, double, double) const override
  {
    // N = m / |m| with m = (-z_x, -z_y, 1), |m| >= 1: N_u = (m_u - N (N . m_u)) / |m|, so that
    // |N_u| <= |m_u| and |N_uv| <= |m_uv| + 3 |m_u| |m_v|.
    const Waves at(*this, u, v);
    const double length = 1. / middle.Normal[2];
    MesoShapeBends bends;
    for (int k = 0; k < 2; ++k)
    {
      const MesoTriple change = { -at.Z(k == 0 ? 2 : 1, k) / this->Size[0],
        -at.Z(1 - k, k == 0 ? 1 : 2) / this->Size[1], 0. };
      const double along = change[0] * middle.Normal[0] + change[1] * middle.Normal[1];
      (k == 0 ? bends.NormalU : bends.NormalV) =
        MesoCombined(1. / length, change, -along / length, middle.Normal);
    }
    bends.Puu = this->Most(2, 0);
    bends.Puv = this->Most(1, 1);
    bends.Pvv = this->Most(0, 2);
    bends.Nu = this->MostChange(1, 0);
    bends.Nv = this->MostChange(0, 1);
    bends.Nuu = this->MostChange(2, 0) + 3. * bends.Nu * bends.Nu;
    bends.Nuv = this->MostChange(1, 1) + 3. * bends.Nu * bends.Nv;
    bends.Nvv = this->MostChange(0, 2) + 3. * bends.Nv * bends.Nv;
    return bends;
  }

private:
  /// Derivatives of z at a place, of order i and j in u and v.
  struct Waves
  {
    const UndulatingForm& Form;
    double U;
    double V;
    Waves(const UndulatingForm& form, double u, double v)
      : Form(form)
      , U(form.Rate[0] * (u - 0.5))
      , V(form.Rate[1] * (v - 0.5))
    {
    }
    double Z(int i, int j) const
    {
      constexpr double quarter = 0.25 * TwoPi;
      return this->Form.Most(i, j) * std::cos(this->U + quarter * i) *
        std::cos(this->V + quarter * j);
    }
  };

  double Most(int i, int j) const
  {
    return this->Amplitude * std::pow(this->Rate[0], i) * std::pow(this->Rate[1], j);
  }
  /// Bound of a derivative of (z_x, z_y).
  double MostChange(int i, int j) const
  {
    return std::hypot(this->Most(i + 1, j) / this->Size[0], this->Most(i, j + 1) / this->Size[1]);
  }

  double Amplitude;
  std::array<double, 2> Size;
  std::array<double, 2> Rate;
  std::array<int, 2> Segments;
};
}

MesoShapeFormPointer MesoMakeSheetForm(const std::string& shape, const MesoShapeNumbers& numbers)
{
  const auto segments = numbers("segments");
  if (shape == "cube")
  {
    return std::make_shared<CubeForm>(numbers("size"), static_cast<int>(segments[0]));
  }
  if (shape == "undulating")
  {
    return std::make_shared<UndulatingForm>(numbers);
  }
  const auto size = numbers("size");
  return std::make_shared<PlaneForm>(std::array<double, 2>{ size[0], size[1] },
    std::array<int, 2>{ static_cast<int>(segments[0]), static_cast<int>(segments[1]) });
}

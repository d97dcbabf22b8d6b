#include "MesoFlip.h"

#include "MesoScene.h" // for MesoInputError
#include "MesoSeparableFilter.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Color = std::array<double, 3>;

constexpr double Pi = 3.14159265358979323846;

// Linear sRGB to XYZ under D65, and the white that results from (1, 1, 1).
constexpr double ToXYZ[3][3] = { { 10135552. / 24577794., 8788810. / 24577794.,
                                   4435075. / 24577794. },
  { 2613072. / 12288897., 8788810. / 12288897., 887015. / 12288897. },
  { 1425312. / 73733382., 8788810. / 73733382., 70074185. / 73733382. } };
constexpr Color White = { ToXYZ[0][0] + ToXYZ[0][1] + ToXYZ[0][2],
  ToXYZ[1][0] + ToXYZ[1][1] + ToXYZ[1][2], ToXYZ[2][0] + ToXYZ[2][1] + ToXYZ[2][2] };

/// XYZ relative to white.
Color RelativeXYZ(const Color& linear)
{
  Color result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] =
      (ToXYZ[i][0] * linear[0] + ToXYZ[i][1] * linear[1] + ToXYZ[i][2] * linear[2]) / White[i];
  }
  return result;
}

/// The inverse of ToXYZ, by cofactors.
std::array<Color, 3> InverseOfToXYZ()
{
  const auto& m = ToXYZ;
  std::array<Color, 3> inverse;
  double determinant = 0.;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int a = (j + 1) % 3;
      const int b = (j + 2) % 3;
      const int c = (i + 1) % 3;
      const int d = (i + 2) % 3;
      inverse[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
    determinant += m[0][i] * inverse[i][0];
  }
  for (Color& row : inverse)
  {
    for (double& value : row)
    {
      value /= determinant;
    }
  }
  return inverse;
}

/// The linear opponent space that the blur is made in: luminance, red-green, blue-yellow.
Color OpponentOfLinear(const Color& linear)
{
  const Color xyz = RelativeXYZ(linear);
  return { 116. * xyz[1] - 16., 500. * (xyz[0] - xyz[1]), 200. * (xyz[1] - xyz[2]) };
}

Color LinearOfOpponent(const Color& opponent)
{
  static const std::array<Color, 3> inverse = InverseOfToXYZ();
  const double y = (opponent[0] + 16.) / 116.;
  const Color xyz = { (y + opponent[1] / 500.) * White[0], y * White[1],
    (y - opponent[2] / 200.) * White[2] };
  Color linear;
  for (int i = 0; i < 3; ++i)
  {
    linear[i] = inverse[i][0] * xyz[0] + inverse[i][1] * xyz[1] + inverse[i][2] * xyz[2];
  }
  return linear;
}

/// L*a*b*, with a* and b* scaled by lightness as colours look less saturated in the dark (Hunt).
Color HuntLabOfLinear(const Color& linear)
{
  const auto root = [](double t)
  {
    constexpr double Delta = 6. / 29.;
    return t > Delta * Delta * Delta ? std::cbrt(t) : t / (3. * Delta * Delta) + 4. / 29.;
  };
  const Color xyz = RelativeXYZ(linear);
  const double lightness = 116. * root(xyz[1]) - 16.;
  return { lightness, 0.01 * lightness * 500. * (root(xyz[0]) - root(xyz[1])),
    0.01 * lightness * 200. * (root(xyz[1]) - root(xyz[2])) };
}

double HyAB(const Color& a, const Color& b)
{
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// Distance of colours to [0,1]: small ones take most of the range.
double ColorError(double distance)
{
  constexpr double Exponent = 0.7;
  constexpr double KneeIn = 0.4;
  constexpr double KneeOut = 0.95;
  // The largest distance there is, from green to blue.
  static const double most =
    std::pow(HyAB(HuntLabOfLinear({ 0., 1., 0. }), HuntLabOfLinear({ 0., 0., 1. })), Exponent);
  const double value = std::pow(distance, Exponent);
  const double knee = KneeIn * most;
  return value < knee ? KneeOut / knee * value
                      : KneeOut + (value - knee) / (most - knee) * (1. - KneeOut);
}

/// exp(-x^2 factor) for x = -radius to radius.
std::vector<double> Bell(int radius, double factor)
{
  std::vector<double> kernel;
  for (int x = -radius; x <= radius; ++x)
  {
    kernel.push_back(std::exp(-x * x * factor));
  }
  return kernel;
}

double Sum(const std::vector<double>& values)
{
  double sum = 0.;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

void Scale(std::vector<double>& values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
}

/// Positive weights to the sum 1, negative ones to the sum -1.
void BalanceSigns(std::vector<double>& kernel)
{
  double positive = 0.;
  double negative = 0.;
  for (const double value : kernel)
  {
    (value > 0. ? positive : negative) += value;
  }
  for (double& value : kernel)
  {
    value /= value > 0. ? positive : -negative;
  }
}

/// A term a sqrt(pi / b) exp(-pi^2 x^2 / b) of a contrast sensitivity, x in degrees.
struct SensitivityTerm
{
  double A;
  double B;
};

/// A channel as the eye sees it: blurred by its contrast sensitivity.
MesoPlane Blurred(
  const MesoPlane& plane, const std::vector<SensitivityTerm>& terms, double pixelsPerDegree)
{
  constexpr double WidestB = 0.04; // that of all channels, whose kernels have one radius
  const int radius =
    static_cast<int>(std::ceil(3. * std::sqrt(WidestB / (2. * Pi * Pi)) * pixelsPerDegree));
  double total = 0.;
  MesoPlane result(plane.Width, plane.Height);
  for (const SensitivityTerm& term : terms)
  {
    const std::vector<double> kernel =
      Bell(radius, Pi * Pi / (term.B * pixelsPerDegree * pixelsPerDegree));
    const double weight = term.A * std::sqrt(Pi / term.B);
    const MesoPlane part = MesoFilterSeparably(plane, kernel, kernel, MesoFilterEdge::Nearest);
    total += weight * Sum(kernel) * Sum(kernel);
    for (std::size_t i = 0; i < part.Values.size(); ++i)
    {
      result.Values[i] += weight * part.Values[i];
    }
  }
  Scale(result.Values, 1. / total);
  return result;
}

/// What is computed of one picture by itself.
struct Seen
{
  std::vector<Color> Lab;    ///< blurred, Hunt-adjusted
  std::vector<double> Edge;  ///< length of the gradient
  std::vector<double> Point; ///< length of the second derivative
};

std::vector<double> FeatureLengths(
  const MesoPlane& plane, const std::vector<double>& derivative, const std::vector<double>& bell)
{
  const MesoPlane x = MesoFilterSeparably(plane, derivative, bell, MesoFilterEdge::Nearest);
  const MesoPlane y = MesoFilterSeparably(plane, bell, derivative, MesoFilterEdge::Nearest);
  std::vector<double> lengths(x.Values.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    lengths[i] = std::hypot(x.Values[i], y.Values[i]);
  }
  return lengths;
}

void FindFeatures(MesoPlane luminance, double pixelsPerDegree, Seen& seen)
{
  for (double& value : luminance.Values)
  {
    value = (value + 16.) / 116.;
  }
  constexpr double FeatureWidth = 0.082; // degrees: what the eye detects best
  const double deviation = 0.5 * FeatureWidth * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3. * deviation));
  std::vector<double> bell = Bell(radius, 0.5 / (deviation * deviation));
  std::vector<double> edge = bell;
  std::vector<double> point = bell;
  for (int x = -radius; x <= radius; ++x)
  {
    edge[x + radius] *= -x;
    point[x + radius] *= x * x / (deviation * deviation) - 1.;
  }
  Scale(bell, 1. / Sum(bell));
  BalanceSigns(edge);
  BalanceSigns(point);
  seen.Edge = FeatureLengths(luminance, edge, bell);
  seen.Point = FeatureLengths(luminance, point, bell);
}

Seen See(const MesoPicture& picture, double pixelsPerDegree)
{
  MesoPlane luminance(picture.Width, picture.Height);
  MesoPlane redGreen = luminance;
  MesoPlane blueYellow = luminance;
  const std::size_t count = picture.NumberOfPixels();
  for (std::size_t i = 0; i < count; ++i)
  {
    const float* rgb = &picture.Rgb[3 * i];
    const Color opponent = OpponentOfLinear(
      { MesoLinearOfSRGB(rgb[0]), MesoLinearOfSRGB(rgb[1]), MesoLinearOfSRGB(rgb[2]) });
    luminance.Values[i] = opponent[0];
    redGreen.Values[i] = opponent[1];
    blueYellow.Values[i] = opponent[2];
  }
  Seen seen;
  FindFeatures(luminance, pixelsPerDegree, seen);
  luminance = Blurred(luminance, { { 1., 0.0047 } }, pixelsPerDegree);
  redGreen = Blurred(redGreen, { { 1., 0.0053 } }, pixelsPerDegree);
  blueYellow = Blurred(blueYellow, { { 34.1, 0.04 }, { 13.5, 0.025 } }, pixelsPerDegree);
  seen.Lab.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Color linear =
      LinearOfOpponent({ luminance.Values[i], redGreen.Values[i], blueYellow.Values[i] });
    for (double& value : linear)
    {
      value = std::clamp(value, 0., 1.);
    }
    seen.Lab[i] = HuntLabOfLinear(linear);
  }
  return seen;
}
}

std::vector<float> MesoFlip(
  const MesoPicture& truth, const MesoPicture& test, double pixelsPerDegree)
{
  if (truth.Width != test.Width || truth.Height != test.Height)
  {
    throw MesoInputError("FLIP compares pictures of one size");
  }
  if (!(pixelsPerDegree > 0.))
  {
    throw MesoInputError("FLIP needs more than 0 pixels per degree");
  }
  const Seen seenTruth = See(truth, pixelsPerDegree);
  const Seen seenTest = See(test, pixelsPerDegree);
  std::vector<float> errors(truth.NumberOfPixels());
  vtkSMPTools::For(0, static_cast<vtkIdType>(errors.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double color = ColorError(HyAB(seenTruth.Lab[i], seenTest.Lab[i]));
        const double feature = std::max(std::abs(seenTruth.Edge[i] - seenTest.Edge[i]),
          std::abs(seenTruth.Point[i] - seenTest.Point[i]));
        const double featureError = std::min(std::sqrt(feature / std::sqrt(2.)), 1.);
        errors[i] = static_cast<float>(std::min(std::pow(color, 1. - featureError), 1.));
      }
    });
  return errors;
}

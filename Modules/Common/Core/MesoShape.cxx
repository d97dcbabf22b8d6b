#include "MesoShape.h"

#include <cmath>
#include <stdexcept>

namespace
{
constexpr double Pi = 3.141592653589793238462643;

// Lengths are positive; the bounds keep squares and quotients far from float's limits.
constexpr double Least = 1e-9;
constexpr double Most = 1e9;
constexpr double MostSegments = 4096.;

struct Entry
{
  const char* Name;
  std::vector<MesoParameter> Parameters;
};

MesoParameter Length(const char* key, double value)
{
  return { key, { value }, Least, Most, false };
}

MesoParameter Count(const char* key, double value, double least)
{
  return { key, { value }, least, MostSegments, true };
}

const std::vector<Entry>& Table()
{
  static const std::vector<Entry> table = {
    { "plane",
      { { "size", { 1., 1. }, Least, Most, false },
        { "segments", { 1., 1. }, 1., MostSegments, true } } },
    { "sphere", { Length("radius", 1.), Count("rings", 24., 2.), Count("sides", 48., 3.) } },
    { "cylinder",
      { Length("radius", 0.5), Length("height", 1.), Count("sides", 48., 3.),
        Count("rings", 1., 1.) } },
    { "torus",
      { Length("radius", 1.), Length("tube", 0.4), Count("rings", 48., 3.),
        Count("sides", 24., 3.) } },
  };
  return table;
}

const Entry* Find(const std::string& shape)
{
  for (const auto& entry : Table())
  {
    if (shape == entry.Name)
    {
      return &entry;
    }
  }
  return nullptr;
}

std::vector<double> ValueOf(const Entry& entry, const MesoShapeValues& values, const char* key)
{
  const auto given = values.find(key);
  if (given != values.end())
  {
    return given->second;
  }
  for (const auto& parameter : entry.Parameters)
  {
    if (parameter.Key == key)
    {
      return parameter.Default;
    }
  }
  return {};
}

struct Angle
{
  double Sine;
  double Cosine;
};

// Sine and cosine of a number of full turns. Whole turns give the same bits, and quarter turns give
// exactly 0 and 1, so that seams and poles close without a gap.
Angle OfTurns(double turns)
{
  const double within = turns - std::floor(turns);
  const double quarter = std::floor(4. * within + 0.5);
  const double rest = 2. * Pi * (within - 0.25 * quarter);
  const double sine = std::sin(rest);
  const double cosine = std::cos(rest);
  switch (static_cast<int>(quarter) % 4)
  {
    case 1:
      return { cosine, -sine };
    case 2:
      return { -sine, -cosine };
    case 3:
      return { -cosine, sine };
    default:
      return { sine, cosine };
  }
}
}

std::vector<std::string> MesoShapeNames()
{
  std::vector<std::string> names;
  for (const auto& entry : Table())
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

std::vector<MesoParameter> MesoShapeParameters(const std::string& shape)
{
  const Entry* entry = Find(shape);
  return entry ? entry->Parameters : std::vector<MesoParameter>{};
}

std::string MesoShapeProblem(const std::string& shape, const MesoShapeValues& values)
{
  const Entry* entry = Find(shape);
  if (!entry)
  {
    return "unknown shape '" + shape + "' (known: " + MesoListOfNames(MesoShapeNames()) + ")";
  }
  for (const auto& [key, value] : values)
  {
    const std::string problem = MesoParameterProblem(entry->Parameters, key, value);
    if (!problem.empty())
    {
      return "shape '" + shape + "': " + problem;
    }
  }
  if (shape == "torus" &&
    !(ValueOf(*entry, values, "tube")[0] < ValueOf(*entry, values, "radius")[0]))
  {
    return "shape 'torus': 'tube' must be less than 'radius'";
  }
  return {};
}

MesoShape::MesoShape(const std::string& shape, const MesoShapeValues& values)
{
  const std::string problem = MesoShapeProblem(shape, values);
  if (!problem.empty())
  {
    throw std::invalid_argument(problem);
  }
  const Entry& entry = *Find(shape);
  const auto number = [&](const char* key) { return ValueOf(entry, values, key)[0]; };
  if (shape == "plane")
  {
    const auto size = ValueOf(entry, values, "size");
    const auto segments = ValueOf(entry, values, "segments");
    this->A = size[0];
    this->B = size[1];
    this->Cuts = { static_cast<int>(segments[0]), static_cast<int>(segments[1]) };
    return;
  }
  this->A = number("radius");
  const int rings = static_cast<int>(number("rings"));
  const int sides = static_cast<int>(number("sides"));
  this->Cuts = { sides, rings };
  if (shape == "sphere")
  {
    this->Form = Sphere;
  }
  else if (shape == "cylinder")
  {
    this->Form = Cylinder;
    this->B = number("height");
  }
  else
  {
    this->Form = Torus;
    this->B = number("tube");
    this->Cuts = { rings, sides };
  }
}

MesoShapePoint MesoShape::At(double u, double v) const
{
  if (this->Form == Plane)
  {
    return { { (u - 0.5) * this->A, (v - 0.5) * this->B, 0. }, { 0., 0., 1. }, { 1., 0., 0. },
      { 0., 1., 0. }, { this->A, this->B } };
  }
  // Half a turn on: the seam is at -z. "out" is (around.Sine, 0, around.Cosine).
  const Angle around = OfTurns(u + 0.5);
  const std::array<double, 3> east = { around.Cosine, 0., -around.Sine };
  if (this->Form == Cylinder)
  {
    return { { this->A * around.Sine, (v - 0.5) * this->B, this->A * around.Cosine },
      { around.Sine, 0., around.Cosine }, east, { 0., 1., 0. }, { 2. * Pi * this->A, this->B } };
  }
  // The profile is a circle of radius r about (middle, 0) in the plane of "out" and y.
  const bool torus = this->Form == Torus;
  const Angle up = torus ? OfTurns(v + 0.5) : OfTurns(0.5 * (v - 0.5));
  const double middle = torus ? this->A : 0.;
  const double r = torus ? this->B : this->A;
  const double out = middle + r * up.Cosine;
  return { { out * around.Sine, r * up.Sine, out * around.Cosine },
    { up.Cosine * around.Sine, up.Sine, up.Cosine * around.Cosine }, east,
    { -up.Sine * around.Sine, up.Cosine, -up.Sine * around.Cosine },
    { 2. * Pi * out, (torus ? 2. : 1.) * Pi * r } };
}

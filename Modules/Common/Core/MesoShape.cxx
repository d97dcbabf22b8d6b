#include "MesoShape.h"

#include "MesoShapeForms.h"

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

MesoParameter Number(const char* key, double value, double least, double most, bool integer = false)
{
  return { key, { value }, least, most, integer };
}

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
    { "cube", { { "size", { 1., 1., 1. }, Least, Most, false }, Count("segments", 1., 1.) } },
    { "sphere", { Length("radius", 1.), Count("rings", 24., 2.), Count("sides", 48., 3.) } },
    { "cylinder",
      { Length("radius", 0.5), Length("height", 1.), Count("sides", 48., 3.),
        Count("rings", 1., 1.) } },
    { "cone",
      { Length("radius", 0.5), Number("top", 0., 0., Most), Length("height", 1.),
        Count("sides", 48., 3.), Count("rings", 16., 1.) } },
    { "torus",
      { Length("radius", 1.), Length("tube", 0.4), Count("rings", 48., 3.),
        Count("sides", 24., 3.) } },
    { "vase",
      { Length("radius", 0.5), Length("height", 1.5), Count("rings", 60., 1.),
        Count("sides", 72., 3.) } },
    { "teapot", { Length("radius", 1.), Number("segments", 8., 1., 512., true) } },
    { "undulating",
      { { "size", { 2., 2. }, Least, Most, false }, Number("amplitude", 0.15, 0., Most),
        { "waves", { 1.5, 1. }, 0., 64., false },
        { "segments", { 48., 48. }, 1., MostSegments, true } } },
    { "branch",
      { Length("radius", 0.16), Length("length", 2.), Number("bend", 0.5, 0., 1.),
        Number("shoots", 2., 0., 4., true), Number("caps", 1., 0., 1., true),
        Count("rings", 62., 4.), Count("sides", 32., 6.) } },
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

// Conditions between the values of several keys.
std::string JointProblem(const Entry& entry, const MesoShapeValues& values)
{
  const auto number = [&](const char* key) { return ValueOf(entry, values, key)[0]; };
  const std::string shape = entry.Name;
  if (shape == "torus" && !(number("tube") < number("radius")))
  {
    return "'tube' must be less than 'radius'";
  }
  if (shape == "branch" && !(4. * number("radius") < number("length")))
  {
    return "'radius' must be less than a quarter of 'length'";
  }
  return {};
}

MesoShapeFormPointer MakeForm(const std::string& shape, const MesoShapeNumbers& numbers)
{
  if (shape == "teapot")
  {
    return MesoMakeTeapotForm(numbers);
  }
  if (shape == "branch")
  {
    return MesoMakeBranchForm(numbers);
  }
  return shape == "plane" || shape == "cube" || shape == "undulating"
    ? MesoMakeSheetForm(shape, numbers)
    : MesoMakeRevolvedForm(shape, numbers);
}
}

MesoTurned::MesoTurned(double turns)
{
  const double within = turns - std::floor(turns);
  const double quarter = std::floor(4. * within + 0.5);
  const double rest = 2. * Pi * (within - 0.25 * quarter);
  const double sine = std::sin(rest);
  const double cosine = std::cos(rest);
  const int whole = static_cast<int>(quarter) % 4;
  this->Sine = whole == 0 ? sine : whole == 1 ? cosine : whole == 2 ? -sine : -cosine;
  this->Cosine = whole == 0 ? cosine : whole == 1 ? -sine : whole == 2 ? -cosine : sine;
}

MesoTriple MesoDirectionOf(const MesoTriple& a, double& length)
{
  length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return length > 0. ? MesoTriple{ a[0] / length, a[1] / length, a[2] / length }
                     : MesoTriple{ 1., 0., 0. };
}

MesoShapeBends MesoShape::Form::BendsAround(
  const MesoShapePoint&, double, double, double, double) const
{
  throw std::logic_error("the bends of this shape are not known");
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
  const std::string problem = JointProblem(*entry, values);
  return problem.empty() ? problem : "shape '" + shape + "': " + problem;
}

MesoShape::MesoShape(const std::string& shape, const MesoShapeValues& values)
{
  const std::string problem = MesoShapeProblem(shape, values);
  if (!problem.empty())
  {
    throw std::invalid_argument(problem);
  }
  const Entry& entry = *Find(shape);
  this->Function = MakeForm(shape, [&](const char* key) { return ValueOf(entry, values, key); });
  this->AllCharts = this->Function->Charts();
}

MesoShapePoint MesoShape::InChart(std::size_t chart, double a, double b) const
{
  MesoShapePoint point = this->Function->At(chart, a, b);
  for (std::size_t k = 0; k < 2; ++k)
  {
    point.Scale[k] /= this->AllCharts[chart].High[k] - this->AllCharts[chart].Low[k];
  }
  return point;
}

bool MesoShape::IsFlat() const
{
  return this->Function->IsFlat();
}

bool MesoShape::HasBends() const
{
  return this->Function->HasBends();
}

MesoShapeBends MesoShape::BendsAround(
  const MesoShapePoint& middle, double u, double v, double halfU, double halfV) const
{
  return this->Function->BendsAround(middle, u, v, halfU, halfV);
}

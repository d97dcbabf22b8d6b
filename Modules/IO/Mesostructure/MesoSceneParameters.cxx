#include "MesoSceneParameters.h"

#include <algorithm>

std::string MesoReadName(const MesoSceneValue& value, const std::string& kind,
  const std::vector<std::string>& names, const std::vector<std::string>& later)
{
  const std::string name = value.ToText();
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    value.FailChoice(kind, name, names, later);
  }
  return name;
}

void MesoCheckNamesKind(const MesoSceneValue& value, const std::string& key)
{
  if (!value.Has(key))
  {
    value.Fail("must be a file name, or an object with the key " + key);
  }
}

std::vector<double> MesoReadParameter(const MesoSceneValue& value, const MesoParameter& parameter)
{
  const MesoSceneRange range = { parameter.Minimum, parameter.Maximum, true };
  const auto read = [&](const MesoSceneValue& element)
  { return parameter.Integer ? element.ToInteger(range) : element.ToNumber(range); };
  if (parameter.Default.size() == 1)
  {
    return { read(value) };
  }
  std::vector<double> numbers;
  for (const MesoSceneValue& element : value.ToList(parameter.Default.size()))
  {
    numbers.push_back(read(element));
  }
  return numbers;
}

std::array<double, 2> MesoReadRange(const MesoSceneValue& value)
{
  const auto range = value.ToNumbers<2>();
  if (!(range[0] < range[1]))
  {
    value.Fail("the first number must be less than the second");
  }
  return range;
}

void MesoReadPatternValues(const MesoSceneValue& value,
  const std::vector<MesoParameter>& parameters, std::uint32_t& seed,
  std::map<std::string, double>& values)
{
  value.With("seed",
    [&](const MesoSceneValue& number)
    {
      const MesoSceneRange range = { 0., std::numeric_limits<std::uint32_t>::max(), true };
      seed = static_cast<std::uint32_t>(number.ToInteger(range));
    });
  for (const MesoParameter& parameter : parameters)
  {
    value.With(parameter.Key,
      [&](const MesoSceneValue& number)
      { values[parameter.Key] = MesoReadParameter(number, parameter).front(); });
  }
}

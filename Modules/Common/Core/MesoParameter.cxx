#include "MesoParameter.h"

#include <cmath>
#include <sstream>

std::string MesoListOfNames(const std::vector<std::string>& names)
{
  std::string text;
  for (const auto& name : names)
  {
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text.empty() ? "none" : text;
}

std::string MesoParameterProblem(const std::vector<MesoParameter>& parameters,
  const std::string& key, const std::vector<double>& values)
{
  const MesoParameter* found = nullptr;
  std::vector<std::string> keys;
  for (const auto& parameter : parameters)
  {
    keys.push_back(parameter.Key);
    if (parameter.Key == key)
    {
      found = &parameter;
    }
  }
  std::ostringstream problem;
  if (!found)
  {
    problem << "unknown key '" << key << "' (known: " << MesoListOfNames(keys) << ")";
    return problem.str();
  }
  if (values.size() != found->Default.size())
  {
    problem << "'" << key << "' takes " << found->Default.size() << " number"
            << (found->Default.size() == 1 ? "" : "s") << ", not " << values.size();
    return problem.str();
  }
  for (double value : values)
  {
    // Written so that NaN is out of range.
    if (!(value >= found->Minimum && value <= found->Maximum))
    {
      problem << "'" << key << "' is " << value << ", allowed are " << found->Minimum << " to "
              << found->Maximum;
      return problem.str();
    }
    if (found->Integer && value != std::floor(value))
    {
      problem << "'" << key << "' is " << value << ", allowed are whole numbers";
      return problem.str();
    }
  }
  return {};
}

#include "MesoPatternTable.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace
{
MesoPatternValues WithDefaults(
  const MesoPatternTable::Entry& entry, const MesoPatternValues& values)
{
  MesoPatternValues all = values;
  for (const auto& parameter : entry.Parameters)
  {
    all.emplace(parameter.Key, parameter.Default[0]);
  }
  return all;
}
}

MesoPatternTable::MesoPatternTable(const char* kind, JointCheck check, std::vector<Entry> entries)
  : Kind(kind)
  , Check(check)
  , Entries(std::move(entries))
{
}

MesoParameter MesoPatternTable::Number(const char* key, double value, double least, double most)
{
  return { key, { value }, least, most, false };
}

MesoParameter MesoPatternTable::Count(const char* key, double value, double least, double most)
{
  return { key, { value }, least, most, true };
}

const MesoPatternTable::Entry* MesoPatternTable::Find(const std::string& pattern) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&](const Entry& entry) { return pattern == entry.Name; });
  return found == this->Entries.end() ? nullptr : &*found;
}

std::vector<std::string> MesoPatternTable::Names() const
{
  std::vector<std::string> names;
  for (const Entry& entry : this->Entries)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

std::vector<MesoParameter> MesoPatternTable::Parameters(const std::string& pattern) const
{
  const Entry* entry = this->Find(pattern);
  return entry ? entry->Parameters : std::vector<MesoParameter>{};
}

std::string MesoPatternTable::Problem(
  const std::string& pattern, const MesoPatternValues& values) const
{
  const Entry* entry = this->Find(pattern);
  if (!entry)
  {
    return "unknown " + this->Kind + " '" + pattern +
      "' (known: " + MesoListOfNames(this->Names()) + ")";
  }
  const std::string start = this->Kind + " '" + pattern + "': ";
  for (const auto& [key, value] : values)
  {
    const std::string problem = MesoParameterProblem(entry->Parameters, key, { value });
    if (!problem.empty())
    {
      return start + problem;
    }
  }
  const std::string problem = this->Check(pattern, WithDefaults(*entry, values));
  return problem.empty() ? problem : start + problem;
}

MesoPatternValues MesoPatternTable::Complete(
  const std::string& pattern, const MesoPatternValues& values) const
{
  const std::string problem = this->Problem(pattern, values);
  if (!problem.empty())
  {
    throw std::invalid_argument(problem);
  }
  return WithDefaults(*this->Find(pattern), values);
}

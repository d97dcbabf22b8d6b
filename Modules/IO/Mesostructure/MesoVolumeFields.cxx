#include "MesoVolumeFields.h"

#include "MesoFileBytes.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoVolumeNumbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace
{
std::string Quoted(const std::string& text)
{
  constexpr std::size_t most = 60;
  return "'" + (text.size() > most ? text.substr(0, most) + "..." : text) + "'";
}
}

void MesoVolumeFields::Set(const std::string& key, const std::string& value)
{
  const std::size_t first = value.find_first_not_of(" \t");
  const std::size_t last = value.find_last_not_of(" \t\r");
  this->Fields[key] = first == std::string::npos || last == std::string::npos || last < first
    ? std::string()
    : value.substr(first, last - first + 1);
}

std::string MesoVolumeFields::Of(const std::string& key) const
{
  const auto found = this->Fields.find(key);
  return found == this->Fields.end() ? std::string() : found->second;
}

std::string MesoVolumeFields::OneOf(const std::vector<std::string>& keys) const
{
  const auto found = std::find_if(
    keys.begin(), keys.end(), [this](const std::string& key) { return this->Has(key); });
  return found == keys.end() ? keys.back() : *found;
}

std::vector<double> MesoVolumeFields::Numbers(const std::string& key, std::size_t count) const
{
  std::string text = this->Of(key);
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::vector<double> numbers;
  const char* place = text.c_str();
  for (char* end = nullptr; numbers.size() <= count; place = end)
  {
    const double number = std::strtod(place, &end);
    if (end == place || !std::isfinite(number))
    {
      break;
    }
    numbers.push_back(number);
  }
  const bool isAll = std::string(place).find_first_not_of(" \t") == std::string::npos;
  if (numbers.size() != count || !isAll)
  {
    this->Fail(key,
      Quoted(this->Of(key)) + " is not " + std::to_string(count) +
        (count == 1 ? " finite number" : " finite numbers"));
  }
  return numbers;
}

double MesoVolumeFields::WholeNumber(
  const std::string& key, double least, double most, double otherwise) const
{
  if (!this->Has(key))
  {
    return otherwise;
  }
  const double number = this->Numbers(key, 1)[0];
  if (!(number >= least && number <= most) || number != std::floor(number))
  {
    this->Fail(key, Quoted(this->Of(key)) + " makes no sense");
  }
  return number;
}

std::array<int, 3> MesoVolumeFields::Size(const std::string& key) const
{
  const std::vector<double> sides = this->Numbers(key, 3);
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < size.size(); ++axis)
  {
    const double side = sides[axis];
    if (!(side >= 1. && side <= MesoVolumeLargestSide) || side != std::floor(side))
    {
      this->Fail(key,
        Quoted(this->Of(key)) + " samples; a side has 1 to " +
          std::to_string(MesoVolumeLargestSide));
    }
    size[axis] = static_cast<int>(side);
  }
  return size;
}

bool MesoVolumeFields::IsTrue(const std::string& key) const
{
  const std::string text = this->Of(key);
  for (const char* word : { "True", "true", "TRUE", "T", "1" })
  {
    if (text == word)
    {
      return true;
    }
  }
  for (const char* word : { "", "False", "false", "FALSE", "F", "0" })
  {
    if (text == word)
    {
      return false;
    }
  }
  this->Fail(key, Quoted(text) + " is neither True nor False");
}

std::string MesoVolumeFields::BytesBeside(const std::string& key) const
{
  const std::filesystem::path name = this->Of(key);
  // Whoever opens a volume did not ask for a file elsewhere on the disk.
  if (name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end())
  {
    this->Fail(key, Quoted(name.string()) + " lies outside of the folder of the header");
  }
  const std::string beside = (std::filesystem::path(this->FileName).parent_path() / name).string();
  const std::string problem = MesoWhyNoFile(beside);
  if (!problem.empty())
  {
    this->Fail(key, Quoted(name.string()) + ": " + problem);
  }
  return MesoReadBytes(beside, MesoVolumeMostBytes, "a volume file");
}

void MesoVolumeFields::Fail(const std::string& key, const std::string& reason) const
{
  throw MesoInputError(
    this->FileName + ": " + MesoPrintable((key.empty() ? "" : key + ": ") + reason));
}

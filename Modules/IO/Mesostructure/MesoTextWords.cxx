#include "MesoTextWords.h"

#include "MesoMeshFile.h"

#include <cmath>

namespace
{
bool IsBlank(char character)
{
  return character == ' ' || character == '\t' || character == '\r' || character == '\v' ||
    character == '\f';
}

bool IsTiny(std::string_view digits)
{
  const std::size_t exponent = digits.find_first_of("eE");
  return exponent != std::string_view::npos ? digits.substr(exponent + 1, 1) == "-"
                                            : digits.find("0.") <= 1;
}
}

std::string_view MesoNextWord(std::string_view& rest)
{
  std::size_t begin = 0;
  while (begin < rest.size() && IsBlank(rest[begin]))
  {
    ++begin;
  }
  std::size_t end = begin;
  while (end < rest.size() && !IsBlank(rest[end]) && rest[end] != '#')
  {
    ++end;
  }
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(word.empty() ? rest.size() : end);
  return word;
}

std::string MesoQuoted(std::string_view word)
{
  return "\"" + std::string(word.substr(0, 40)) + "\"";
}

std::string MesoReadNumber(std::string_view word, double& number)
{
  const std::string_view digits = !word.empty() && word[0] == '+' ? word.substr(1) : word;
  const char* const end = digits.data() + digits.size();
  number = 0.; // which from_chars leaves where a number is too small for a double
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument)
  {
    return MesoQuoted(word) + " is not a number";
  }
  const bool isTooLarge = error == std::errc::result_out_of_range && !IsTiny(digits);
  if (isTooLarge || !(std::abs(number) <= MesoMeshLargestNumber))
  {
    return MesoQuoted(word) + " is not finite or beyond 1e30";
  }
  return {};
}

std::string MesoReadInteger(std::string_view word, std::int64_t& number)
{
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return stop != end || error != std::errc() ? MesoQuoted(word) + " is not a whole number" : "";
}

bool MesoTextLines::Next(std::string_view& line)
{
  if (this->Rest.empty())
  {
    return false;
  }
  ++this->Count;
  const std::size_t end = this->Rest.find('\n');
  line = this->Rest.substr(0, end);
  this->Rest.remove_prefix(end == std::string_view::npos ? this->Rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  return true;
}

bool MesoTextLines::NextWithWords(std::string_view& line)
{
  while (this->Next(line))
  {
    std::string_view rest = line;
    if (!MesoNextWord(rest).empty())
    {
      return true;
    }
  }
  return false;
}

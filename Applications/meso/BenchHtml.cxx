#include "BenchHtml.h"

#include <cmath>
#include <cstdio>

using Json = BenchResults::Json;

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    switch (letter)
    {
      case '<':
        escaped += "&lt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string Number(const std::optional<double>& value)
{
  if (!value)
  {
    return "&ndash;";
  }
  char text[32];
  std::snprintf(text, sizeof(text), std::abs(*value) < 1000. ? "%.3g" : "%.0f", *value);
  return text;
}

std::string Number(const Json& value)
{
  return Number(value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt);
}

std::string Interval(const Json& interval)
{
  return interval.is_null() ? "" : " [" + Number(interval[0]) + ", " + Number(interval[1]) + "]";
}

std::string TimesPlain(const Json& row)
{
  return row["ratio_to_floor"].is_null()
    ? ""
    : ", x" + Number(row["ratio_to_floor"]) + Interval(row.value("ratio_interval", Json()));
}

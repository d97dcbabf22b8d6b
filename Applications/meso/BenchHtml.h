#ifndef BenchHtml_h
#define BenchHtml_h

#include "BenchResults.h"

#include <optional>
#include <string>

/// How a bench's report writes texts and numbers.

std::string Escaped(const std::string& text);

/// Three digits, or all that stand before the point; a dash for what is not known.
std::string Number(const std::optional<double>& value);
std::string Number(const BenchResults::Json& value);

/// " [low, high]" of a list of two; nothing where it is null.
std::string Interval(const BenchResults::Json& interval);

/// How many times as long as plain, with its interval; nothing where the floor was too short to be
/// measured.
std::string TimesPlain(const BenchResults::Json& row);

#endif

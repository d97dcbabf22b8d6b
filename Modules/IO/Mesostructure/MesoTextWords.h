#ifndef MesoTextWords_h
#define MesoTextWords_h

/**
 * @file MesoTextWords.h
 * @brief Lines, words and numbers of text files of meshes.
 */

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Takes the next word off `rest`; empty at the end, or at a '#', which begins a comment.
std::string_view MesoNextWord(std::string_view& rest);

/// Reads a number. Returns why it is none, `"x" is not a number`, or an empty text. A number too
/// small for a double is 0.
std::string MesoReadNumber(std::string_view word, double& number);

/// Reads a whole number. Returns why it is none, `"x" is not a whole number`, or an empty text.
std::string MesoReadInteger(std::string_view word, std::int64_t& number);

/// The word in quotation marks, cut at 40 characters.
std::string MesoQuoted(std::string_view word);

/// Lines of a text, one after the other, without their ends ("\n" or "\r\n").
class MesoTextLines
{
public:
  explicit MesoTextLines(std::string_view text, std::size_t linesBefore = 0)
    : Rest(text)
    , Count(linesBefore)
  {
  }

  /// False at the text's end.
  bool Next(std::string_view& line);
  /// The same for the next line that has a word before a comment.
  bool NextWithWords(std::string_view& line);
  /// The number of the line last given, from 1.
  std::size_t Number() const { return this->Count; }
  /// What follows the line last given.
  std::string_view After() const { return this->Rest; }

private:
  std::string_view Rest;
  std::size_t Count;
};

#endif

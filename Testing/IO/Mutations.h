#ifndef Mutations_h
#define Mutations_h

/**
 * @file Mutations.h
 * @brief Damages files as accidents and fuzzers do, the same way for the same seed.
 */

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

class Mutator
{
public:
  explicit Mutator(std::uint32_t seed)
    : Random(seed)
  {
  }

  /// One to eight damages. `words` are put in where they may hurt: keywords, borders of numbers.
  std::string Damage(std::string bytes, const std::vector<std::string>& words)
  {
    const int count = 1 + this->Below(8);
    for (int i = 0; i < count; ++i)
    {
      this->DamageOnce(bytes, words);
    }
    return bytes;
  }

private:
  int Below(std::size_t limit)
  {
    // Not std::uniform_int_distribution, which differs from library to library.
    return limit == 0 ? 0 : static_cast<int>(this->Random() % limit);
  }

  void DamageOnce(std::string& bytes, const std::vector<std::string>& words)
  {
    const auto place = static_cast<std::size_t>(this->Below(bytes.size() + 1));
    const auto length = static_cast<std::size_t>(this->Below(
      std::min<std::size_t>(bytes.size() - place + 1, std::size_t(1) << this->Below(10))));
    constexpr int kinds = 8;
    switch (this->Below(kinds))
    {
      case 0: // cut off
        bytes.resize(place);
        break;
      case 1: // take out
        bytes.erase(place, length);
        break;
      case 2: // say twice
        bytes.insert(place, bytes.substr(place, length));
        break;
      case 3: // flip a bit
        if (place < bytes.size())
        {
          bytes[place] = static_cast<char>(bytes[place] ^ (1 << this->Below(8)));
        }
        break;
      case 4: // any byte
        if (place < bytes.size())
        {
          bytes[place] = static_cast<char>(this->Below(256));
        }
        break;
      case 5: // a word put in
        bytes.insert(place, words[this->Below(words.size())]);
        break;
      case 6: // a word written over
      {
        const std::string& word = words[this->Below(words.size())];
        bytes.replace(place, std::min(word.size(), bytes.size() - place), word);
        break;
      }
      default: // a digit changed, which hits counts and indices of text
      {
        const std::size_t digit = bytes.find_first_of("0123456789", place);
        if (digit != std::string::npos)
        {
          bytes[digit] = static_cast<char>('0' + this->Below(10));
        }
        break;
      }
    }
  }

  std::mt19937 Random;
};

#endif

#ifndef MesoSceneValue_h
#define MesoSceneValue_h

/**
 * @file MesoSceneValue.h
 * @brief A value of a scene file with its place in it, read with types and ranges checked.
 *
 * Every failed check throws a MesoInputError "file: place: reason".
 */

#include "MesoJson.h"
#include "MesoScene.h"
#include "MesoSceneKeys.h"

#include <cmath>
#include <functional>
#include <limits>

/// The file that is read: what its messages and relative names go by.
struct MesoSceneSource
{
  std::string FileName;
  bool FilesMustExist = false;
};

/// Numbers that a key takes. None is beyond MesoSceneLargest, so that no float overflows.
constexpr double MesoSceneLargest = 1e18;
struct MesoSceneRange
{
  double Minimum = -MesoSceneLargest;
  double Maximum = MesoSceneLargest;
  bool WithEnds = true;
};

namespace MesoSceneRanges
{
constexpr MesoSceneRange Any;
constexpr MesoSceneRange Positive = { 0., MesoSceneLargest, false };
constexpr MesoSceneRange NotNegative = { 0., MesoSceneLargest, true };
constexpr MesoSceneRange Fraction = { 0., 1., true };
}

class MesoSceneValue
{
public:
  MesoSceneValue(
    const MesoJsonValue& value, const std::string& place, const MesoSceneSource& source)
    : Value(&value)
    , Place(place)
    , Source(&source)
  {
  }

  [[noreturn]] void Fail(const std::string& reason) const;

  bool IsString() const { return this->Value->Type == MesoJsonValue::Kind::String; }
  bool IsBoolean() const { return this->Value->Type == MesoJsonValue::Kind::Boolean; }
  bool IsNumber() const { return this->Value->Type == MesoJsonValue::Kind::Number; }

  bool ToBoolean() const;
  double ToNumber(const MesoSceneRange& range = {}) const;
  double ToInteger(const MesoSceneRange& range) const;
  /// Not empty, without control characters.
  std::string ToText() const;
  /// A file's name, resolved against the scene file's folder; checked to exist if so asked.
  std::string ToFileName() const;
  /// Elements of a list; `count` of them if that is not 0.
  std::vector<MesoSceneValue> ToList(std::size_t count = 0) const;
  /// The number of elements of a list.
  std::size_t ToCount() const;
  /// The element of a list with that number, which is less than ToCount().
  MesoSceneValue ElementAt(std::size_t number) const;

  template <std::size_t N>
  std::array<double, N> ToNumbers(const MesoSceneRange& range = {}) const
  {
    std::array<double, N> numbers;
    const auto list = this->ToList(N);
    for (std::size_t i = 0; i < N; ++i)
    {
      numbers[i] = list[i].ToNumber(range);
    }
    return numbers;
  }

  /// Three numbers of which one is not 0, scaled to length 1.
  MesoVector3 ToDirection() const;

  /**
   * One of several words. `names` are those that `fromName` knows; `later` are those that the
   * format has but this version does not.
   */
  template <typename T>
  T ToChoice(const std::string& kind, std::optional<T> (*fromName)(const std::string&),
    const std::vector<std::string>& names, const std::vector<std::string>& later = {}) const
  {
    const std::string word = this->ToText();
    const std::optional<T> choice = fromName(word);
    if (!choice)
    {
      this->FailChoice(kind, word, names, later);
    }
    return *choice;
  }
  [[noreturn]] void FailChoice(const std::string& kind, const std::string& word,
    const std::vector<std::string>& names, const std::vector<std::string>& later) const;

  /// Check that this is an object with keys of the group of that name, and no others.
  void CheckKeys(const std::string& object) const;
  bool Has(const std::string& key) const;
  /// The value of a key; fails where there is none.
  MesoSceneValue At(const std::string& key) const;
  /// Call `read` with the value of the key, if it is there.
  void With(const std::string& key, const std::function<void(const MesoSceneValue&)>& read) const;
  /// Fail if one of the keys is there.
  void Refuse(const std::vector<std::string>& keys, const std::string& reason) const;

private:
  [[noreturn]] void FailType(const char* wanted) const;
  std::string PlaceOf(const std::string& key) const;

  const MesoJsonValue* Value;
  std::string Place;
  const MesoSceneSource* Source;
};

#endif

#ifndef MesoJson_h
#define MesoJson_h

/**
 * @file MesoJson.h
 * @brief JSON text as a tree of plain values, strictly read.
 *
 * What the JSON grammar leaves open is refused here: a key given twice in one object, more than
 * MesoJsonMaximumDepth levels, numbers that a double cannot hold. Everything wrong is a
 * MesoInputError of one line with the line and column, or the place of the value.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <cstddef>
#include <string>
#include <vector>

/// Arrays and objects inside one another, at most.
constexpr std::size_t MesoJsonMaximumDepth = 64;

struct MESOIOMESOSTRUCTURE_EXPORT MesoJsonValue
{
  enum class Kind
  {
    Null,
    Boolean,
    Number,
    String,
    Array,
    Object
  };
  Kind Type = Kind::Null;
  bool Boolean = false;
  double Number = 0.;
  std::string Text;
  std::vector<MesoJsonValue> Elements; ///< of an array, or the values of an object
  std::vector<std::string> Keys;       ///< of an object: Keys[i] names Elements[i], in file order

  /// The value of a key of an object, or null where there is none.
  const MesoJsonValue* Find(const std::string& key) const;
  /// What it is, with its article: "a number", "an object", ...
  const char* TypeName() const;
};

/// Parse JSON text (UTF-8). `fileName` serves the messages of the MesoInputError only.
MESOIOMESOSTRUCTURE_EXPORT MesoJsonValue MesoParseJson(
  const std::string& text, const std::string& fileName);

/// Text of unknown origin as it may stand in a one-line message: no control characters, not long.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoPrintable(const std::string& text);

/// A number in the fewest digits that give it back.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoNumberText(double value);

#endif

#ifndef MesoPatternTable_h
#define MesoPatternTable_h

#include "MesoPattern.h" // for MesoPatternValues

#include <string>
#include <vector>

/**
 * @class MesoPatternTable
 * @brief The built-in patterns of a kind: their names, their keys, and the check of values against them.
 */
class MesoPatternTable
{
public:
  struct Entry
  {
    const char* Name;
    std::vector<MesoParameter> Parameters;
  };

  /// What is wrong with the values of several keys of a pattern together; empty where nothing is.
  using JointCheck = std::string (*)(const std::string& pattern, const MesoPatternValues& all);

  /// @param kind what messages call one of them, "pattern"
  MesoPatternTable(const char* kind, JointCheck check, std::vector<Entry> entries);

  ///@{
  /// A key of one number, any or whole.
  static MesoParameter Number(const char* key, double value, double least, double most);
  static MesoParameter Count(const char* key, double value, double least, double most);
  ///@}

  std::vector<std::string> Names() const;
  /// Of a pattern; none where it is unknown.
  std::vector<MesoParameter> Parameters(const std::string& pattern) const;
  /// Why a pattern cannot be made of these values; empty where it can.
  std::string Problem(const std::string& pattern, const MesoPatternValues& values) const;
  /// The values and the defaults of all other keys. Throws std::invalid_argument with the Problem().
  MesoPatternValues Complete(const std::string& pattern, const MesoPatternValues& values) const;

private:
  const Entry* Find(const std::string& pattern) const;

  std::string Kind;
  JointCheck Check;
  std::vector<Entry> Entries;
};

#endif

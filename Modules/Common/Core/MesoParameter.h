#ifndef MesoParameter_h
#define MesoParameter_h

/**
 * @file MesoParameter.h
 * @brief What a key of a built-in shape or pattern may hold, and the check of a value against it.
 */

#include "mesoCommonCoreModule.h" // for export macro

#include <string>
#include <vector>

/// One key: a number, or a short list of numbers of fixed length.
struct MesoParameter
{
  std::string Key;
  std::vector<double> Default; ///< its length is the number of values the key takes
  double Minimum;              ///< least value allowed, for each number
  double Maximum;              ///< greatest value allowed, for each number
  bool Integer;                ///< whole numbers only
};

/**
 * What is wrong with `values` for `key` among `parameters`, as one sentence without a full stop
 * ("unknown key 'sidez' (known: ...)"), or an empty string where all is right. Unknown keys, a
 * wrong number of values, numbers that are not finite, out of range or not whole are wrong.
 */
MESOCOMMONCORE_EXPORT std::string MesoParameterProblem(const std::vector<MesoParameter>& parameters,
  const std::string& key, const std::vector<double>& values);

/// The names as one text, in quotes and with commas, for messages.
MESOCOMMONCORE_EXPORT std::string MesoListOfNames(const std::vector<std::string>& names);

#endif

#ifndef MesoSceneParameters_h
#define MesoSceneParameters_h

/**
 * @file MesoSceneParameters.h
 * @brief Words of a list, ranges, and the numbers of what is built in, read from a scene file.
 */

#include "MesoParameter.h"
#include "MesoSceneValue.h"

/// A word of a list, for ToChoice.
std::string MesoReadName(const MesoSceneValue& value, const std::string& kind,
  const std::vector<std::string>& names, const std::vector<std::string>& later);

/// A mesh, map or volume that is no file name must be an object that says which one is meant.
void MesoCheckNamesKind(const MesoSceneValue& value, const std::string& key);

std::vector<double> MesoReadParameter(const MesoSceneValue& value, const MesoParameter& parameter);

/// [from, to], the one less than the other.
std::array<double, 2> MesoReadRange(const MesoSceneValue& value);

/// A pattern's `seed` and its own keys, where they are given.
void MesoReadPatternValues(const MesoSceneValue& value,
  const std::vector<MesoParameter>& parameters, std::uint32_t& seed,
  std::map<std::string, double>& values);

#endif

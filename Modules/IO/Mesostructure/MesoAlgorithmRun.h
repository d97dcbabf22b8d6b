#ifndef MesoAlgorithmRun_h
#define MesoAlgorithmRun_h

#include "mesoIOMesostructureModule.h" // for export macro

#include <string>
#include <vector>

class vtkAlgorithm;

/// Update an algorithm; its first error becomes a MesoInputError "place: message", its warnings are
/// added to the list, each with the place.
MESOIOMESOSTRUCTURE_EXPORT void MesoRunAlgorithm(
  vtkAlgorithm* algorithm, const std::string& place, std::vector<std::string>& warnings);

#endif

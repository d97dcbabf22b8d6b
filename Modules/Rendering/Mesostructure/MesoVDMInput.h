#ifndef MesoVDMInput_h
#define MesoVDMInput_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkMesoVDMMapper;
class vtkPolyData;

/**
 * Give a mapper the table of its height map: a baked file's, or one that is baked now and kept in the
 * cache (MesoBakeCache.h), with as many factors as its options ask for and the curvatures that the mesh has.
 *
 * @param mapper with its options and its height map
 * @param baked a file's name, or empty
 * @param mesh whose tiles say how deep the relief is in them
 * @param place for messages; throws MesoInputError where a file cannot be used or no table be baked
 */
void MesoSetVDMTable(vtkMesoVDMMapper* mapper, const std::string& baked, vtkPolyData* mesh,
  const std::string& place, std::vector<std::string>& warnings);

/// The heights that a table was baked from, at its resolution. Throws MesoInputError where a file cannot be
/// used.
vtkSmartPointer<vtkImageData> MesoReadVDMHeights(
  const std::string& baked, const std::string& place);

#endif

#ifndef MesoDicedArray_h
#define MesoDicedArray_h

/**
 * @file MesoDicedArray.h
 * @brief A point array of a mesh over the points that a MesoDicePlan dices it into.
 */

#include "MesoDicePlan.h"

#include "vtkSmartPointer.h"

class vtkDataArray;

/// Linear in the mesh's triangles, computed in double; of the array's name and of this type of VTK.
vtkSmartPointer<vtkDataArray> MesoDicedArray(
  const MesoDicePlan& plan, const MesoTriangleMesh& mesh, vtkDataArray* array, int type);

#endif

#ifndef MesoPolyDataInput_h
#define MesoPolyDataInput_h

/**
 * @file MesoPolyDataInput.h
 * @brief Reads and checks what the surface filters take from a vtkPolyData, and makes their arrays.
 *
 * What cannot be used throws std::invalid_argument with the filter's message.
 */

#include "MesoTriangleMesh.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

class vtkCellArray;
class vtkPointData;

/// Rounding of the stored numbers, relative to their size: 2^-53 for doubles, else 2^-24.
double MesoRoundingOf(vtkDataArray* array);

/// Null where the input has no normals, or none that fit it.
vtkDataArray* MesoFindNormals(vtkPolyData* input);

/// The active ones, or an array named `TextureCoordinates`. Throws where there are none, or not two
/// numbers for each point.
vtkDataArray* MesoFindTextureCoordinates(vtkPolyData* input);

/// Throws where a cell names a point that does not exist.
void MesoCheckCells(vtkCellArray* cells, const char* what, vtkIdType points);

/// The input's polygons and strips as triangles, over the same points.
vtkSmartPointer<vtkPolyData> MesoTriangulated(vtkPolyData* input);

std::vector<std::array<std::int64_t, 3>> MesoTrianglesOf(vtkCellArray* cells);

/// The input's MesoVertex, or nothing where it does not number positions.
std::vector<std::int64_t> MesoGivenVertices(
  vtkPointData* data, const std::vector<MesoVector>& positions);

/// Numbers positions from 0 without a gap, in the order of their first point.
std::vector<std::int64_t> MesoMadeVertices(const std::vector<MesoVector>& positions);

/// The tuples as doubles; throws where one is not finite.
template <std::size_t N>
std::vector<std::array<double, N>> MesoTuples(vtkDataArray* array, const char* what)
{
  std::vector<std::array<double, N>> tuples(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), tuples[i].data());
    for (double component : tuples[i])
    {
      if (!std::isfinite(component))
      {
        std::ostringstream message;
        message << what << " of point " << i << " is not finite (";
        for (std::size_t k = 0; k < N; ++k)
        {
          message << (k > 0 ? ", " : "") << tuples[i][k];
        }
        throw std::invalid_argument(message.str() + ")");
      }
    }
  }
  return tuples;
}

template <std::size_t N>
vtkSmartPointer<vtkDataArray> MesoMakeArray(
  const char* name, int type, const std::vector<std::array<double, N>>& tuples)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(N));
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), tuples[i].data());
  }
  return array;
}

#endif

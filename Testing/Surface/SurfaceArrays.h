#ifndef SurfaceArrays_h
#define SurfaceArrays_h

#include "MesoVector.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// A point's tuple; missing arrays give zeros.
inline MesoVector TupleOf(vtkPolyData* mesh, const char* name, vtkIdType point)
{
  MesoVector tuple = { 0., 0., 0. };
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  for (int k = 0; array && k < array->GetNumberOfComponents() && k < 3; ++k)
  {
    tuple[k] = array->GetComponent(point, k);
  }
  return tuple;
}

inline MesoVector PositionOf(vtkPolyData* mesh, vtkIdType point)
{
  MesoVector position;
  mesh->GetPoint(point, position.data());
  return position;
}

inline std::vector<std::array<vtkIdType, 3>> TrianglesOf(vtkPolyData* mesh)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    triangles.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
  }
  return triangles;
}

/// A mesh in double of positions, texture coordinates (left out where there are none) and cells.
inline vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<MesoVector>& positions,
  const std::vector<std::array<double, 2>>& coordinates,
  const std::vector<std::vector<vtkIdType>>& cells)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const MesoVector& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  mesh->SetPoints(points);
  if (!coordinates.empty())
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("uv");
    array->SetNumberOfComponents(2);
    for (const auto& coordinate : coordinates)
    {
      array->InsertNextTuple(coordinate.data());
    }
    mesh->GetPointData()->SetTCoords(array);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& cell : cells)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  mesh->SetPolys(polygons);
  return mesh;
}

inline double DistanceOf(const MesoVector& a, const MesoVector& b)
{
  return MesoLength(MesoDifference(a, b));
}

#endif

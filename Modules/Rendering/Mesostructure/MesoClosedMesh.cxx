#include "MesoClosedMesh.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

bool MesoIsClosed(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() == 0 || mesh->GetNumberOfStrips() > 0)
  {
    return false;
  }
  vtkDataArray* vertices = mesh->GetPointData()->GetArray("MesoVertex");
  const auto vertexOf = [&](vtkIdType point)
  { return vertices ? static_cast<vtkIdType>(vertices->GetComponent(point, 0)) : point; };
  // An edge as it is walked, and the same turned round: the two lists must be equal.
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  std::vector<std::pair<vtkIdType, vtkIdType>> turned;
  vtkCellArray* polys = mesh->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType cell = 0; cell < polys->GetNumberOfCells(); ++cell)
  {
    polys->GetCellAtId(cell, count, points);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType from = vertexOf(points[i]);
      const vtkIdType to = vertexOf(points[(i + 1) % count]);
      if (from != to)
      {
        edges.emplace_back(from, to);
        turned.emplace_back(to, from);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(turned.begin(), turned.end());
  return edges == turned;
}

#include "MesoFitInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace
{
/// Unit normals; false where one has no length.
bool Normalize(std::vector<MesoVector>& normals)
{
  bool all = true;
  for (MesoVector& normal : normals)
  {
    // In two steps: squares of the largest components may overflow.
    const double size = std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
    all = all && size > 0.;
    if (size > 0.)
    {
      normal = { normal[0] / size, normal[1] / size, normal[2] / size };
      normal = MesoScaled(normal, 1. / MesoLength(normal));
    }
  }
  return all;
}

void MakeMissingNormals(const MesoTriangleMesh& mesh, std::vector<MesoVector>& normals)
{
  const MesoCornerNormals corners =
    MesoMakeCornerNormals(mesh, MesoMeasureTriangles(mesh), false, 0.);
  std::vector<bool> missing(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    missing[i] = !(MesoLength(normals[i]) > 0.);
    normals[i] = missing[i] ? MesoVector{ 0., 0., 1. } : normals[i];
  }
  for (std::int64_t c = 0; c < mesh.NumberOfCorners(); ++c)
  {
    const std::int64_t point = mesh.PointOf(c);
    if (missing[point])
    {
      normals[point] = corners.Normals[corners.Group[c]];
    }
  }
}
}

MesoFitInput MesoReadFitInput(vtkPolyData* input)
{
  MesoFitInput result;
  vtkDataArray* positions = input->GetPoints()->GetData();
  result.Mesh.Positions = MesoTuples<3>(positions, "the position");
  result.Mesh.PositionRounding = MesoRoundingOf(positions);
  vtkDataArray* normals = MesoFindNormals(input);
  if (normals)
  {
    result.Normals = MesoTuples<3>(normals, "the normal");
  }
  result.Normals.resize(result.Mesh.Positions.size(), { 0., 0., 0. });
  MesoCheckCells(input->GetPolys(), "polygon", input->GetNumberOfPoints());
  MesoCheckCells(input->GetStrips(), "strip", input->GetNumberOfPoints());
  result.Triangles = MesoTriangulated(input);
  result.Mesh.Triangles = MesoTrianglesOf(result.Triangles->GetPolys());
  result.Mesh.Vertex = MesoGivenVertices(input->GetPointData(), result.Mesh.Positions);
  if (result.Mesh.Vertex.empty())
  {
    result.Mesh.Vertex = MesoMadeVertices(result.Mesh.Positions);
  }
  result.NormalsAreMade = !Normalize(result.Normals);
  if (result.NormalsAreMade)
  {
    MakeMissingNormals(result.Mesh, result.Normals);
  }
  return result;
}

void MesoWriteFitOutput(const MesoFitInput& input, vtkPolyData* output)
{
  output->ShallowCopy(input.Triangles);
  vtkPointData* data = output->GetPointData();
  if (input.NormalsAreMade)
  {
    data->SetNormals(MesoMakeArray("Normals", input.ArrayType(), input.Normals));
  }
  else
  {
    data->SetActiveNormals(MesoFindNormals(output)->GetName());
  }
  std::vector<std::array<double, 1>> vertices;
  for (std::int64_t vertex : input.Mesh.Vertex)
  {
    vertices.push_back({ static_cast<double>(vertex) });
  }
  data->AddArray(MesoMakeArray("MesoVertex", VTK_DOUBLE, vertices));
}

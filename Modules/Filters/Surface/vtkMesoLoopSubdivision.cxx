#include "vtkMesoLoopSubdivision.h"

#include "MesoFitInput.h"
#include "MesoLoopSubdivision.h"
#include "MesoPolyDataInput.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

vtkStandardNewMacro(vtkMesoLoopSubdivision);

void vtkMesoLoopSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

int vtkMesoLoopSubdivision::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorMessage = MesoFitFailure(
    "finer triangles", [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return 1;
}

void vtkMesoLoopSubdivision::Execute(vtkPolyData* input, vtkPolyData* output)
{
  MesoCheckCells(input->GetPolys(), "polygon", input->GetNumberOfPoints());
  MesoCheckCells(input->GetStrips(), "strip", input->GetNumberOfPoints());
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  MesoSubdividedMesh mesh;
  mesh.Mesh.Positions = MesoTuples<3>(input->GetPoints()->GetData(), "the position");
  mesh.Mesh.Triangles = MesoTrianglesOf(MesoTriangulated(input)->GetPolys());
  mesh.Mesh.Vertex = MesoGivenVertices(input->GetPointData(), mesh.Mesh.Positions);
  if (mesh.Mesh.Vertex.empty())
  {
    mesh.Mesh.Vertex = MesoMadeVertices(mesh.Mesh.Positions);
  }
  if (input->GetPointData()->GetTCoords())
  {
    mesh.Coordinates = MesoTuples<2>(MesoFindTextureCoordinates(input), "the texture coordinate");
  }
  const auto triangles = static_cast<vtkIdType>(mesh.Mesh.Triangles.size()) << (2 * this->Levels);
  if (triangles > MostTriangles)
  {
    throw std::invalid_argument("subdivision into " + std::to_string(triangles) +
      " triangles is more than the limit of " + std::to_string(MostTriangles));
  }
  for (int level = 0; level < this->Levels; ++level)
  {
    if (this->GetAbortExecute())
    {
      return;
    }
    mesh = MesoSubdivide(mesh);
    this->UpdateProgress((level + 1.) / (this->Levels + 1.));
  }
  MesoMoveToLimit(mesh.Mesh);

  vtkNew<vtkPoints> points;
  points->SetData(MesoMakeArray<3>("Points", VTK_DOUBLE, mesh.Mesh.Positions));
  output->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& corners : mesh.Mesh.Triangles)
  {
    const vtkIdType ids[] = { corners[0], corners[1], corners[2] };
    cells->InsertNextCell(3, ids);
  }
  output->SetPolys(cells);
  if (!mesh.Coordinates.empty())
  {
    output->GetPointData()->SetTCoords(
      MesoMakeArray<2>("TextureCoordinates", VTK_DOUBLE, mesh.Coordinates));
  }
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("MesoVertex");
  for (const std::int64_t vertex : mesh.Mesh.Vertex)
  {
    vertices->InsertNextValue(vertex);
  }
  output->GetPointData()->AddArray(vertices);
}

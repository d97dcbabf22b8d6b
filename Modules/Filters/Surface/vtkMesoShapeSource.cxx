#include "vtkMesoShapeSource.h"

#include "MesoShape.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkMesoShapeSource);

namespace
{
/// Numbers the points of a shape's grid: rows of v from 0, in each the columns of u. Rows that are
/// poles have a point for each segment, the others one more.
class Grid
{
public:
  explicit Grid(const MesoShape& shape)
    : Columns(shape.Segments()[0])
    , Rows(shape.Segments()[1])
    , ClosesAlongU(shape.ClosesAlongU())
    , ClosesAlongV(shape.ClosesAlongV())
    , HasPoles(shape.HasPoles())
  {
  }

  bool IsPole(int row) const { return this->HasPoles && (row == 0 || row == this->Rows); }
  int PointsInRow(int row) const { return this->IsPole(row) ? this->Columns : this->Columns + 1; }

  vtkIdType NumberOfPoints() const
  {
    return this->FirstPoint(this->Rows) + this->PointsInRow(this->Rows);
  }

  vtkIdType Point(int column, int row) const { return this->FirstPoint(row) + column; }

  std::array<double, 2> Coordinates(int column, int row) const
  {
    const double u = this->IsPole(row) ? column + 0.5 : column;
    return { u / this->Columns, static_cast<double>(row) / this->Rows };
  }

  vtkIdType Vertex(int column, int row) const
  {
    if (this->IsPole(row))
    {
      return row == 0 ? 0 : 1 + vtkIdType(this->Rows - 1) * this->Columns;
    }
    const vtkIdType width = this->ClosesAlongU ? this->Columns : this->Columns + 1;
    const int i = this->ClosesAlongU ? column % this->Columns : column;
    const int j = this->ClosesAlongV ? row % this->Rows : row;
    return this->HasPoles ? 1 + (j - 1) * width + i : j * width + i;
  }

  vtkSmartPointer<vtkCellArray> Triangles() const
  {
    vtkNew<vtkIdTypeArray> corners;
    corners->SetNumberOfValues(3 * this->NumberOfTriangles());
    vtkIdType* next = corners->GetPointer(0);
    for (int j = 0; j < this->Rows; ++j)
    {
      for (int i = 0; i < this->Columns; ++i)
      {
        if (!this->IsPole(j))
        {
          const std::array<vtkIdType, 3> lower = { this->Point(i, j), this->Point(i + 1, j),
            this->Point(this->IsPole(j + 1) ? i : i + 1, j + 1) };
          next = std::copy(lower.begin(), lower.end(), next);
        }
        if (!this->IsPole(j + 1))
        {
          const std::array<vtkIdType, 3> upper = { this->Point(i, j), this->Point(i + 1, j + 1),
            this->Point(i, j + 1) };
          next = std::copy(upper.begin(), upper.end(), next);
        }
      }
    }
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(3, corners);
    return cells;
  }

private:
  vtkIdType FirstPoint(int row) const
  {
    const vtkIdType missing = this->HasPoles && row > 0 ? 1 : 0;
    return vtkIdType(row) * (this->Columns + 1) - missing;
  }

  vtkIdType NumberOfTriangles() const
  {
    const vtkIdType quads = vtkIdType(this->Columns) * this->Rows;
    return 2 * quads - (this->HasPoles ? 2 * this->Columns : 0);
  }

  int Columns;
  int Rows;
  bool ClosesAlongU;
  bool ClosesAlongV;
  bool HasPoles;
};

/// The shape's point; at a pole with the |dp/du| of half a ring away.
MesoShapePoint PointAt(const MesoShape& shape, const Grid& grid, int column, int row)
{
  const auto [u, v] = grid.Coordinates(column, row);
  MesoShapePoint point = shape.At(u, v);
  if (grid.IsPole(row))
  {
    const double halfRing = 0.5 / shape.Segments()[1];
    point.Scale[0] = shape.At(u, row == 0 ? v + halfRing : v - halfRing).Scale[0];
  }
  return point;
}

vtkSmartPointer<vtkDataArray> MakeArray(
  bool single, const char* name, int components, vtkIdType tuples)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(single ? VTK_FLOAT : VTK_DOUBLE));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void Evaluate(const MesoShape& shape, const Grid& grid, bool single, vtkPolyData* output)
{
  const vtkIdType size = grid.NumberOfPoints();
  const auto positions = MakeArray(single, "Points", 3, size);
  const auto normals = MakeArray(single, "Normals", 3, size);
  const auto coordinates = MakeArray(single, "TextureCoordinates", 2, size);
  const auto tangents = MakeArray(single, "MesoTangent", 3, size);
  const auto bitangents = MakeArray(single, "MesoBitangent", 3, size);
  const auto scales = MakeArray(single, "MesoTileScale", 2, size);
  const auto valid = MakeArray(single, "MesoFrameValid", 1, size);
  const auto vertices = MakeArray(false, "MesoVertex", 1, size);
  valid->Fill(1.);
  vtkIdType id = 0;
  for (int row = 0; row <= shape.Segments()[1]; ++row)
  {
    for (int column = 0; column < grid.PointsInRow(row); ++column, ++id)
    {
      const MesoShapePoint point = PointAt(shape, grid, column, row);
      positions->SetTuple(id, point.Position.data());
      normals->SetTuple(id, point.Normal.data());
      coordinates->SetTuple(id, grid.Coordinates(column, row).data());
      tangents->SetTuple(id, point.Tangent.data());
      bitangents->SetTuple(id, point.Bitangent.data());
      scales->SetTuple(id, point.Scale.data());
      vertices->SetTuple1(id, static_cast<double>(grid.Vertex(column, row)));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  data->SetNormals(normals);
  data->SetTCoords(coordinates);
  for (vtkDataArray* array :
    { vertices.Get(), tangents.Get(), bitangents.Get(), scales.Get(), valid.Get() })
  {
    data->AddArray(array);
  }
}
}

vtkMesoShapeSource::vtkMesoShapeSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkMesoShapeSource::SetShape(const char* shape)
{
  const std::string name = shape ? shape : "";
  if (this->Shape != name)
  {
    this->Shape = name;
    this->Modified();
  }
}

void vtkMesoShapeSource::SetParameter(const std::string& key, const std::vector<double>& values)
{
  const auto found = this->Parameters.find(key);
  if (found == this->Parameters.end() || found->second != values)
  {
    this->Parameters[key] = values;
    this->Modified();
  }
}

void vtkMesoShapeSource::ClearParameters()
{
  if (!this->Parameters.empty())
  {
    this->Parameters.clear();
    this->Modified();
  }
}

int vtkMesoShapeSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorMessage = MesoShapeProblem(this->Shape, this->Parameters);
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
    return 1;
  }
  const MesoShape shape(this->Shape, this->Parameters);
  const Grid grid(shape);
  Evaluate(shape, grid, this->OutputPointsPrecision == SINGLE_PRECISION, output);
  this->UpdateProgress(0.8);
  output->SetPolys(grid.Triangles());
  return 1;
}

void vtkMesoShapeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  for (const auto& [key, values] : this->Parameters)
  {
    os << indent << "Parameter " << key << ":";
    for (double value : values)
    {
      os << " " << value;
    }
    os << "\n";
  }
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

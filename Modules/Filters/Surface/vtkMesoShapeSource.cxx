#include "vtkMesoShapeSource.h"

#include "MesoPolyDataInput.h"
#include "MesoShape.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
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
/// Numbers the points of a chart's grid: rows of v from its low end, in each the columns of u. Rows
/// that are poles have a point for each segment, the others one more.
class Grid
{
public:
  Grid(const MesoShapeChart& chart, vtkIdType firstPoint)
    : Chart(chart)
    , Columns(chart.Segments[0])
    , Rows(chart.Segments[1])
    , Start(firstPoint)
  {
  }

  bool IsPole(int row) const
  {
    return (row == 0 && this->Chart.PoleAtStart) || (row == this->Rows && this->Chart.PoleAtEnd);
  }
  int PointsInRow(int row) const { return this->IsPole(row) ? this->Columns : this->Columns + 1; }
  int GetRows() const { return this->Rows; }
  vtkIdType EndOfPoints() const
  {
    return this->Point(0, this->Rows) + this->PointsInRow(this->Rows);
  }

  /// A point's place in the chart.
  std::array<double, 2> Place(int column, int row) const
  {
    const double a = this->IsPole(row) ? column + 0.5 : column;
    return { a / this->Columns, static_cast<double>(row) / this->Rows };
  }

  vtkIdType NumberOfTriangles() const
  {
    const int poles = (this->Chart.PoleAtStart ? 1 : 0) + (this->Chart.PoleAtEnd ? 1 : 0);
    return vtkIdType(this->Columns) * (2 * this->Rows - poles);
  }

  vtkIdType* WriteTriangles(vtkIdType* next) const
  {
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
    return next;
  }

private:
  vtkIdType Point(int column, int row) const
  {
    const vtkIdType missing = this->Chart.PoleAtStart && row > 0 ? 1 : 0;
    return this->Start + vtkIdType(row) * (this->Columns + 1) - missing + column;
  }

  MesoShapeChart Chart;
  int Columns;
  int Rows;
  vtkIdType Start;
};

std::vector<Grid> GridsOf(const MesoShape& shape)
{
  std::vector<Grid> grids;
  for (const MesoShapeChart& chart : shape.Charts())
  {
    grids.emplace_back(chart, grids.empty() ? 0 : grids.back().EndOfPoints());
  }
  return grids;
}

/// The shape's point; at a pole with the |dp/du| of half a ring away.
MesoShapePoint PointAt(
  const MesoShape& shape, std::size_t chart, const Grid& grid, int column, int row)
{
  const auto [a, b] = grid.Place(column, row);
  MesoShapePoint point = shape.InChart(chart, a, b);
  if (grid.IsPole(row))
  {
    const double halfRing = 0.5 / grid.GetRows();
    point.Scale[0] = shape.InChart(chart, a, row == 0 ? b + halfRing : b - halfRing).Scale[0];
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

vtkSmartPointer<vtkCellArray> TrianglesOf(const std::vector<Grid>& grids)
{
  vtkIdType triangles = 0;
  for (const Grid& grid : grids)
  {
    triangles += grid.NumberOfTriangles();
  }
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * triangles);
  vtkIdType* next = corners->GetPointer(0);
  for (const Grid& grid : grids)
  {
    next = grid.WriteTriangles(next);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

/// Numbers of the positions as they are stored.
vtkSmartPointer<vtkDataArray> VerticesOf(vtkDataArray* positions)
{
  const auto numbers = MesoMadeVertices(MesoTuples<3>(positions, "the position"));
  auto vertices = MakeArray(false, "MesoVertex", 1, positions->GetNumberOfTuples());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    vertices->SetTuple1(static_cast<vtkIdType>(i), static_cast<double>(numbers[i]));
  }
  return vertices;
}

void Evaluate(
  const MesoShape& shape, const std::vector<Grid>& grids, bool single, vtkPolyData* output)
{
  const vtkIdType size = grids.back().EndOfPoints();
  const auto positions = MakeArray(single, "Points", 3, size);
  const auto normals = MakeArray(single, "Normals", 3, size);
  const auto coordinates = MakeArray(single, "TextureCoordinates", 2, size);
  const auto tangents = MakeArray(single, "MesoTangent", 3, size);
  const auto bitangents = MakeArray(single, "MesoBitangent", 3, size);
  const auto scales = MakeArray(single, "MesoTileScale", 2, size);
  const auto valid = MakeArray(single, "MesoFrameValid", 1, size);
  valid->Fill(1.);
  vtkIdType id = 0;
  for (std::size_t chart = 0; chart < grids.size(); ++chart)
  {
    const Grid& grid = grids[chart];
    for (int row = 0; row <= grid.GetRows(); ++row)
    {
      for (int column = 0; column < grid.PointsInRow(row); ++column, ++id)
      {
        const MesoShapePoint point = PointAt(shape, chart, grid, column, row);
        const auto [a, b] = grid.Place(column, row);
        positions->SetTuple(id, point.Position.data());
        normals->SetTuple(id, point.Normal.data());
        coordinates->SetTuple(id, shape.Charts()[chart].Coordinates(a, b).data());
        tangents->SetTuple(id, point.Tangent.data());
        bitangents->SetTuple(id, point.Bitangent.data());
        scales->SetTuple(id, point.Scale.data());
      }
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  data->SetNormals(normals);
  data->SetTCoords(coordinates);
  data->AddArray(VerticesOf(positions));
  for (vtkDataArray* array : { tangents.Get(), bitangents.Get(), scales.Get(), valid.Get() })
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
  const std::vector<Grid> grids = GridsOf(shape);
  Evaluate(shape, grids, this->OutputPointsPrecision == SINGLE_PRECISION, output);
  this->UpdateProgress(0.8);
  output->SetPolys(TrianglesOf(grids));
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

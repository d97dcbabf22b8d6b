#include "MesoVolume.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoVolumeTile.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace
{
const char* const DistanceName = "MesoSignedDistance";
const char* const DepthName = "MesoVolumeDepth";
const char* const ColorName = "MesoColor";

int Wrapped(int i, int period)
{
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

/// The eight samples around a position, and where it is between them.
struct Cell
{
  double Corner[2][2][2]; ///< by z, y, x
  double Weight[3];

  Cell(const MesoVolumeField& field, const MesoVolumeField::Vector& position)
  {
    int low[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = position[axis] * field.GetSize()[axis] - 0.5;
      const double floor = std::floor(place);
      low[axis] = static_cast<int>(floor);
      this->Weight[axis] = place - floor;
    }
    field.Corners(low[0], low[1], low[2], this->Corner);
  }

  static double Mix(double a, double b, double t) { return a + (b - a) * t; }
  double AlongX(int z, int y) const
  {
    return Mix(this->Corner[z][y][0], this->Corner[z][y][1], this->Weight[0]);
  }
};
}

std::string MesoVolumeProblem(vtkImageData* volume)
{
  if (!volume)
  {
    return "there is no volume";
  }
  auto* distances = vtkFloatArray::SafeDownCast(volume->GetPointData()->GetArray(DistanceName));
  if (!distances || distances->GetNumberOfComponents() != 1)
  {
    return std::string("a volume has a point array ") + DistanceName + " of one float";
  }
  int size[3];
  volume->GetDimensions(size);
  if (std::min({ size[0], size[1], size[2] }) < 1 ||
    distances->GetNumberOfTuples() != volume->GetNumberOfPoints())
  {
    return "the volume has no samples, or not as many as its size says";
  }
  vtkDataArray* depth = volume->GetFieldData()->GetArray(DepthName);
  if (!depth || depth->GetNumberOfTuples() != 1 || depth->GetNumberOfComponents() != 1 ||
    !(depth->GetTuple1(0) > 0.) || !std::isfinite(depth->GetTuple1(0)))
  {
    return std::string("a volume has a field data array ") + DepthName + " of one number above 0";
  }
  vtkDataArray* colors = volume->GetPointData()->GetArray(ColorName);
  if (colors &&
    (colors->GetDataType() != VTK_FLOAT || colors->GetNumberOfComponents() != 3 ||
      colors->GetNumberOfTuples() != volume->GetNumberOfPoints()))
  {
    return std::string("the point array ") + ColorName + " must be of three floats a sample";
  }
  const float* values = distances->GetPointer(0);
  if (!std::all_of(values, values + distances->GetNumberOfTuples(),
        [](float value) { return std::isfinite(value); }))
  {
    return "the volume holds distances that are not finite";
  }
  return {};
}

vtkFloatArray* MesoVolumeColors(vtkImageData* volume)
{
  return vtkFloatArray::SafeDownCast(volume->GetPointData()->GetArray(ColorName));
}

std::string MesoSetVolumeColors(vtkImageData* volume, vtkImageData* colors)
{
  constexpr int channels = 3;
  vtkDataArray* given = colors->GetPointData()->GetScalars();
  if (!given || given->GetNumberOfComponents() < channels)
  {
    return "colors need three numbers a sample";
  }
  const int type = given->GetDataType();
  const float unit = type == VTK_UNSIGNED_CHAR ? 1.f / 255.f
    : type == VTK_UNSIGNED_SHORT               ? 1.f / 65535.f
                                               : 1.f;
  vtkNew<vtkFloatArray> result;
  result->SetName(ColorName);
  result->SetNumberOfComponents(channels);
  result->SetNumberOfTuples(volume->GetNumberOfPoints());
  for (int channel = 0; channel < channels; ++channel)
  {
    vtkNew<vtkFloatArray> numbers;
    numbers->SetNumberOfTuples(given->GetNumberOfTuples());
    for (vtkIdType i = 0; i < given->GetNumberOfTuples(); ++i)
    {
      const double number = given->GetComponent(i, channel);
      if (!std::isfinite(number))
      {
        return "it holds colors that are not finite";
      }
      numbers->SetValue(i, static_cast<float>(number));
    }
    vtkNew<vtkImageData> image;
    image->CopyStructure(colors);
    image->GetPointData()->SetScalars(numbers);
    vtkNew<vtkMesoVolumeTile> tile;
    tile->SetInputData(image);
    tile->SetSize(volume->GetDimensions());
    tile->Update();
    vtkDataArray* sampled = tile->GetOutput()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
    {
      result->SetComponent(
        i, channel, std::clamp(unit * static_cast<float>(sampled->GetTuple1(i)), 0.f, 1.f));
    }
  }
  volume->GetPointData()->AddArray(result);
  return {};
}

double MesoVolumeDepth(vtkImageData* volume)
{
  return volume->GetFieldData()->GetArray(DepthName)->GetTuple1(0);
}

vtkSmartPointer<vtkImageData> MesoMakeVolume(
  std::array<int, 3> size, double depth, const std::vector<float>& distances)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(size.data());
  const double spacing[3] = { 1. / size[0], 1. / size[1], depth / size[2] };
  volume->SetSpacing(spacing);
  volume->SetOrigin(0.5 * spacing[0], 0.5 * spacing[1], 0.5 * spacing[2]);
  vtkNew<vtkFloatArray> array;
  array->SetName(DistanceName);
  array->SetNumberOfTuples(volume->GetNumberOfPoints());
  std::copy_n(distances.begin(), volume->GetNumberOfPoints(), array->GetPointer(0));
  volume->GetPointData()->SetScalars(array);
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName(DepthName);
  thickness->InsertNextValue(depth);
  volume->GetFieldData()->AddArray(thickness);
  return volume;
}

MesoVolumeField::MesoVolumeField(std::array<int, 3> size, double depth, std::vector<float> values)
  : Size(size)
  , Depth(depth)
  , Values(std::move(values))
{
  if (std::min({ size[0], size[1], size[2] }) < 1 || !(depth > 0.) ||
    this->Values.size() != std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]))
  {
    throw std::invalid_argument("a volume needs a depth and as many values as its size says");
  }
}

MesoVolumeField::MesoVolumeField(vtkImageData* volume)
  : Depth(MesoVolumeDepth(volume))
{
  volume->GetDimensions(this->Size.data());
  auto* distances = vtkFloatArray::SafeDownCast(volume->GetPointData()->GetArray(DistanceName));
  const float* first = distances->GetPointer(0);
  this->Values.assign(first, first + distances->GetNumberOfTuples());
}

double MesoVolumeField::Sample(int i, int j, int k) const
{
  const std::size_t column = Wrapped(i, this->Size[0]);
  const std::size_t row = Wrapped(j, this->Size[1]);
  const std::size_t slice = std::clamp(k, 0, this->Size[2] - 1);
  return this->Values[(slice * this->Size[1] + row) * this->Size[0] + column];
}

void MesoVolumeField::Corners(int i, int j, int k, double (&corner)[2][2][2]) const
{
  const int columns[2] = { Wrapped(i, this->Size[0]), Wrapped(i + 1, this->Size[0]) };
  const int rows[2] = { Wrapped(j, this->Size[1]), Wrapped(j + 1, this->Size[1]) };
  const int last = this->Size[2] - 1;
  const int slices[2] = { std::clamp(k, 0, last), std::clamp(k + 1, 0, last) };
  for (int z = 0; z < 2; ++z)
  {
    for (int y = 0; y < 2; ++y)
    {
      const float* row =
        this->Values.data() + (std::size_t(slices[z]) * this->Size[1] + rows[y]) * this->Size[0];
      corner[z][y][0] = row[columns[0]];
      corner[z][y][1] = row[columns[1]];
    }
  }
}

double MesoVolumeField::At(const Vector& position) const
{
  const Cell cell(*this, position);
  const double below = Cell::Mix(cell.AlongX(0, 0), cell.AlongX(0, 1), cell.Weight[1]);
  const double above = Cell::Mix(cell.AlongX(1, 0), cell.AlongX(1, 1), cell.Weight[1]);
  return Cell::Mix(below, above, cell.Weight[2]);
}

MesoVolumeField::Vector MesoVolumeField::Gradient(const Vector& position) const
{
  const Cell cell(*this, position);
  const auto alongX = [&](int z, int y) { return cell.Corner[z][y][1] - cell.Corner[z][y][0]; };
  const double below = Cell::Mix(cell.AlongX(0, 0), cell.AlongX(0, 1), cell.Weight[1]);
  const double above = Cell::Mix(cell.AlongX(1, 0), cell.AlongX(1, 1), cell.Weight[1]);
  return { this->Size[0] *
      Cell::Mix(Cell::Mix(alongX(0, 0), alongX(0, 1), cell.Weight[1]),
        Cell::Mix(alongX(1, 0), alongX(1, 1), cell.Weight[1]), cell.Weight[2]),
    this->Size[1] *
      Cell::Mix(cell.AlongX(0, 1) - cell.AlongX(0, 0), cell.AlongX(1, 1) - cell.AlongX(1, 0),
        cell.Weight[2]),
    this->Size[2] / this->Depth * (above - below) };
}

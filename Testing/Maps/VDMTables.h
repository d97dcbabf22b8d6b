#ifndef VDMTables_h
#define VDMTables_h

// Tiny maps, tables of view-dependent displacements of them, and their numbers.

#include "MadeMap.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoVDM.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <random>
#include <vector>

namespace VDMTables
{
const double Pi = std::acos(-1.);

inline vtkSmartPointer<vtkImageData> RandomMap(int width, int height)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.1, 1.);
  return MakeMap(width, height, [&](int, int) { return uniform(random); });
}

/// Of heights 0, 0.4 and 1 alone.
inline vtkSmartPointer<vtkImageData> SteppedMap(int width, int height)
{
  std::mt19937 random(5);
  const double heights[] = { 0., 0., 0.4, 1. };
  return MakeMap(width, height, [&](int, int) { return heights[random() % 4]; });
}

/// Level but for one texel.
inline vtkSmartPointer<vtkImageData> OneTexel(int size, double level, double texel)
{
  return MakeMap(
    size, size, [=](int column, int row) { return column == 1 && row == 2 ? texel : level; });
}

inline MesoVDMLayout SmallLayout(int width, int height)
{
  MesoVDMLayout layout;
  layout.Width = width;
  layout.Height = height;
  layout.Azimuths = 12;
  layout.Polars = 5;
  layout.Curvatures = 4; // -1.5, 0, 1.5, 3
  layout.FirstCurvature = -1.5;
  layout.LastCurvature = 3.;
  layout.Depth = 0.15;
  return layout;
}

/// A number of the table itself, in [0, 1].
inline double NumberAt(vtkImageData* table, const MesoVDMLayout& layout, int column, int row,
  int azimuth, int polar, int curvature)
{
  const vtkIdType tuple = (vtkIdType(azimuth) * layout.Height + row) * layout.Width + column;
  return table->GetPointData()->GetArray("VDM")->GetComponent(
           tuple, curvature * layout.Polars + polar) /
    65535.;
}

inline double AngleAt(
  vtkImageData* table, const MesoVDMLayout& layout, int column, int row, int azimuth, int curvature)
{
  const vtkIdType tuple = (vtkIdType(azimuth) * layout.Height + row) * layout.Width + column;
  return table->GetPointData()->GetArray("MVM")->GetComponent(tuple, curvature) / 65535. * Pi / 2.;
}

inline vtkSmartPointer<vtkImageData> Bake(vtkImageData* map, const MesoVDMLayout& layout,
  int rank = 0, MesoVDMCurved curved = MesoVDMCurved::Exact, int bits = 16)
{
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(map);
  filter->SetLayout(layout);
  filter->SetCurved(curved);
  filter->SetRanks(rank, rank);
  filter->SetBits(bits);
  filter->Update();
  return filter->GetOutput();
}

/// The stored number that the first factors of a table stand for, or what a largest angle leaves.
inline double FactoredAt(vtkImageData* table, vtkIdType tuple, int column, int rank,
  const char* functions = "VDMFunctions")
{
  vtkFieldData* data = table->GetFieldData();
  vtkDataArray* weights = table->GetPointData()->GetScalars();
  const double largest = weights->GetDataTypeMax();
  double sum = 0.;
  for (int i = 0; i < rank; ++i)
  {
    sum +=
      (data->GetArray("WeightLow")->GetTuple1(i) +
        data->GetArray("WeightWidth")->GetTuple1(i) * weights->GetComponent(tuple, i) / largest) *
      data->GetArray(functions)->GetComponent(column, i);
  }
  return sum;
}

inline double RootMeanSquareError(
  vtkImageData* factored, vtkImageData* table, const MesoVDMLayout& layout, int rank)
{
  vtkDataArray* numbers = table->GetPointData()->GetArray("VDM");
  double sum = 0.;
  for (vtkIdType tuple = 0; tuple < numbers->GetNumberOfTuples(); ++tuple)
  {
    for (int column = 0; column < layout.DistanceColumns(); ++column)
    {
      const double error =
        FactoredAt(factored, tuple, column, rank) - numbers->GetComponent(tuple, column) / 65535.;
      sum += error * error;
    }
  }
  return std::sqrt(sum / double(numbers->GetNumberOfValues()));
}
}

#endif

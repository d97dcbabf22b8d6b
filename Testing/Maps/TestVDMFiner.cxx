// Finer tables of view-dependent displacements put rays nearer to where they meet the map.

#include "VDMBench.h"
#include "VDMTables.h"

#include <gtest/gtest.h>

namespace
{
constexpr double Depth = 0.1;
constexpr double Curvature = 1.; // 1 / tile

/// What a table of a size leaves of random rays at a polar angle, against steps along them through the map.
VDMBench::Spread LeftBy(vtkImageData* map, int texels, int azimuths, int polars, double polar)
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = texels;
  layout.Azimuths = azimuths;
  layout.Polars = polars;
  layout.Curvatures = 1;
  layout.FirstCurvature = layout.LastCurvature = Curvature;
  layout.Depth = Depth;
  const auto image = VDMTables::Bake(map, layout);
  vtkDataArray* numbers = image->GetPointData()->GetScalars();
  const VDMBench::Table table(layout,
    [&](std::size_t row, int column)
    { return numbers->GetComponent(static_cast<vtkIdType>(row), column) / 65535.; });
  return VDMBench::Measure(table, VDMBench::Truth(map, Depth), polar, Curvature);
}
}

TEST(VDMFiner, LeavesLess)
{
  const vtkSmartPointer<vtkImageData> map = VDMBench::MapOf("smooth");
  for (const double degrees : { 30., 60. })
  {
    const double polar = degrees * VDMBench::Pi / 180.;
    const VDMBench::Spread coarse = LeftBy(map, 12, 8, 4, polar);
    const VDMBench::Spread middle = LeftBy(map, 24, 16, 8, polar);
    const VDMBench::Spread fine = LeftBy(map, 48, 32, 16, polar);
    EXPECT_GT(fine.Median, 0.);
    EXPECT_LT(middle.Median, 0.6 * coarse.Median) << degrees;
    EXPECT_LT(fine.Median, 0.6 * middle.Median) << degrees;
    EXPECT_LT(middle.Most, 0.6 * coarse.Most) << degrees;
    EXPECT_LT(fine.Most, 0.6 * middle.Most) << degrees;
  }
}

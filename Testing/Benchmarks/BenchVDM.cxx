// What tables of view-dependent displacements leave, over polar angle, kind of nodes, kind of stored
// numbers and curvature: distances over the base between where random rays really meet the relief and where
// the interpolated table says, median and 95th percentile, in texels of 128. By itself, without a window:
//
//   BenchVDM angles|curvatures [PATTERN [DEPTH]]
//
// prints a table of comma-separated values.

#include "VDMBench.h"
#include "vtkDataArray.h"
#include "vtkMesoVDM.h"

#include <cstdio>
#include <cstdlib>

namespace
{
using namespace VDMBench;

constexpr int Polars[] = { 10, 30, 50, 70, 80, 85 };

void PrintHeader(const char* first)
{
  std::printf("%s", first);
  for (const int polar : Polars)
  {
    std::printf(",%d median,%d p95", polar, polar);
  }
  std::printf("\n");
}

/// A row's figures: of a table that is baked at curvature after curvature once.
void PrintErrors(vtkImageData* image, const Truth& truth, double curvature)
{
  vtkDataArray* numbers = image->GetPointData()->GetScalars();
  const Table table(MesoVDMLayout::Read(image),
    [&](std::size_t row, int column)
    { return numbers->GetComponent(static_cast<vtkIdType>(row), column) / 65535.; });
  for (const int polar : Polars)
  {
    const Spread spread = Measure(table, truth, polar * Pi / 180., curvature);
    if (spread.Median < 0.)
    {
      std::printf(",,");
      continue;
    }
    std::printf(",%.3f,%.2f", spread.Median, spread.Most);
  }
  std::printf("\n");
  std::fflush(stdout);
}

vtkSmartPointer<vtkImageData> Bake(
  vtkImageData* map, const MesoVDMLayout& layout, MesoVDMCurved curved)
{
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(map);
  filter->SetLayout(layout);
  filter->SetRanks(0, 0);
  filter->SetCurved(curved);
  filter->Update();
  return filter->GetOutput();
}

void Angles(vtkImageData* map, const Truth& truth, const MesoVDMLayout& layout)
{
  PrintHeader("curvature,nodes,stored");
  const char* const nodeNames[] = { "edges", "centres", "graded" };
  const char* const storeNames[] = { "distance", "depth", "offset" };
  for (const double curvature : { -1., 0., 1.5 })
  {
    for (int nodes = 0; nodes < 3; ++nodes)
    {
      for (int stores = 0; stores < 3; ++stores)
      {
        MesoVDMLayout one = layout;
        one.Curvatures = 1;
        one.FirstCurvature = one.LastCurvature = curvature;
        one.Nodes = static_cast<MesoVDMNodes>(nodes);
        one.Stores = static_cast<MesoVDMStores>(stores);
        std::printf("%g,%s,%s", curvature, nodeNames[nodes], storeNames[stores]);
        PrintErrors(Bake(map, one, MesoVDMCurved::Exact), truth, curvature);
      }
    }
  }
}

void Curvatures(vtkImageData* map, const Truth& truth, const MesoVDMLayout& layout)
{
  PrintHeader("curved,curvature");
  for (const auto curved : { MesoVDMCurved::Exact, MesoVDMCurved::Bent })
  {
    const auto image = Bake(map, layout, curved);
    for (int i = -8; i <= 12; ++i)
    {
      std::printf("%s,%g", curved == MesoVDMCurved::Exact ? "exact" : "bent", 0.25 * i);
      PrintErrors(image, truth, 0.25 * i);
    }
  }
}
}

int main(int argc, char* argv[])
{
  const std::string what = argc > 1 ? argv[1] : "";
  if (what != "angles" && what != "curvatures")
  {
    std::fprintf(stderr, "usage: BenchVDM angles|curvatures [PATTERN [DEPTH]]\n");
    return 2;
  }
  MesoVDMLayout layout;
  layout.Depth = argc > 3 ? std::atof(argv[3]) : 0.1;
  const vtkSmartPointer<vtkImageData> map = MapOf(argc > 2 ? argv[2] : "brick");
  const Truth truth(map, layout.Depth);
  (what == "angles" ? Angles : Curvatures)(map, truth, layout);
  return 0;
}

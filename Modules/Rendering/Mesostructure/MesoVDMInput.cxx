#include "MesoVDMInput.h"

#include "MesoAlgorithmRun.h"
#include "MesoBakeCache.h"
#include "MesoBumpMaps.h"
#include "MesoScene.h"
#include "MesoVDMTable.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoVDM.h"
#include "vtkMesoVDMMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
/// What tables in the cache have, so that one serves all qualities.
constexpr std::array<int, 2> KeptRanks = { 12, 4 };

/// The relief must not reach the centre of the strongest curvature.
constexpr double LargestReach = 0.8;

/// Between the curvatures of a table, in 1 / tile; 0 is one of them.
constexpr double CurvatureStep = 1. / 3.;

const char* const Kind = "vdm";

/// The smallest and the largest curvature of the mesh's quadrics in a table's space, 1 / tile.
std::array<double, 2> CurvaturesOf(
  vtkPolyData* mesh, const MesoMesostructureOptions& options, double depth)
{
  std::array<double, 2> range = { 0., 0. };
  vtkDataArray* quadrics = mesh->GetPointData()->GetArray("MesoQuadric");
  vtkDataArray* scales = mesh->GetPointData()->GetArray("MesoTileScale");
  for (vtkIdType i = 0; quadrics && scales && i < quadrics->GetNumberOfTuples(); ++i)
  {
    // Of z = a x^2 + b y^2 + c x y: twice the eigenvalues of its matrix.
    const double* abc = quadrics->GetTuple3(i);
    const double mean = abc[0] + abc[1];
    const double apart = std::hypot(abc[0] - abc[1], abc[2]);
    const double tile = std::max(
      scales->GetComponent(i, 0) / options.Tiles[0], scales->GetComponent(i, 1) / options.Tiles[1]);
    const double perTile = tile * tile * depth / options.Scale;
    range[0] = std::min(range[0], (mean - apart) * perTile);
    range[1] = std::max(range[1], (mean + apart) * perTile);
  }
  return range;
}

/// The axes of a table for a mesh: the paper's, of its curvatures those that the mesh has.
MesoVDMLayout LayoutFor(vtkPolyData* mesh, const MesoMesostructureOptions& options)
{
  MesoVDMLayout layout;
  layout.Depth = MesoDepthInTiles(mesh, options);
  const double strongest = std::min(layout.LastCurvature, LargestReach / layout.Depth);
  const std::array<double, 2> range = CurvaturesOf(mesh, options, layout.Depth);
  constexpr double slack = 1e-3; // of a step: planes have none
  const auto low =
    static_cast<int>(std::floor(std::max(range[0], layout.FirstCurvature) / CurvatureStep + slack));
  const auto high =
    static_cast<int>(std::ceil(std::min(range[1], strongest) / CurvatureStep - slack));
  layout.Curvatures = high - low + 1;
  layout.FirstCurvature = low * CurvatureStep;
  layout.LastCurvature = std::min(high * CurvatureStep, strongest);
  return layout;
}

vtkSmartPointer<vtkImageData> Bake(vtkImageData* heights, const MesoVDMLayout& layout,
  const std::array<int, 2>& ranks, const std::string& place, std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(heights);
  filter->SetLayout(layout);
  filter->SetRanks(ranks[0], ranks[1]);
  MesoRunAlgorithm(filter, place, warnings);
  return filter->GetOutput();
}

vtkSmartPointer<vtkImageData> BakeOnce(vtkMesoVDMMapper* mapper, vtkPolyData* mesh,
  const std::string& place, std::vector<std::string>& warnings)
{
  const MesoVDMLayout layout = LayoutFor(mesh, mapper->GetOptions());
  std::array<int, 2> ranks = vtkMesoVDMMapper::GetRanks(mapper->GetOptions());
  if (ranks[0] == 0)
  {
    // The table itself is faster baked than read.
    return Bake(mapper->GetHeightMap(), layout, ranks, place, warnings);
  }
  for (int i = 0; i < 2; ++i)
  {
    ranks[i] = std::max(ranks[i], KeptRanks[i]);
  }
  const std::map<std::string, MesoBakedParameter> parameters = {
    { "version", std::vector<double>{ MesoVDMVersion } },
    { "heights", MesoContentOf(mapper->GetHeightMap()) },
    { "depth", std::vector<double>{ layout.Depth } },
    { "curvatures",
      std::vector<double>{
        double(layout.Curvatures), layout.FirstCurvature, layout.LastCurvature } },
    { "rank", std::vector<double>{ double(ranks[0]), double(ranks[1]) } },
  };
  return MesoBakeOnce(
    Kind, parameters, [&] { return Bake(mapper->GetHeightMap(), layout, ranks, place, warnings); },
    warnings)
    .Table;
}

MesoBaked Read(const std::string& baked, const std::string& place)
{
  MesoBaked file;
  try
  {
    file = MesoReadBaked(baked, Kind);
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(place + ": " + problem.what());
  }
  std::string problem;
  try
  {
    problem = MesoVDMProblem(file.Table, MesoVDMLayout::Read(file.Table));
  }
  catch (const std::runtime_error& reason)
  {
    problem = reason.what();
  }
  if (!problem.empty())
  {
    throw MesoInputError(
      place + ": " + baked + ": is no table of view-dependent displacements: " + problem);
  }
  return file;
}
}

void MesoSetVDMTable(vtkMesoVDMMapper* mapper, const std::string& baked, vtkPolyData* mesh,
  const std::string& place, std::vector<std::string>& warnings)
{
  const MesoMesostructureOptions& options = mapper->GetOptions();
  if (!mapper->GetHeightMap() || MesoEffectsOn(options).Empty() || !(options.Scale > 0.))
  {
    return;
  }
  vtkSmartPointer<vtkImageData> table;
  if (baked.empty())
  {
    table = BakeOnce(mapper, mesh, place, warnings);
  }
  else
  {
    table = Read(baked, place + ".baked").Table;
    if (options.Quality == MesoQuality::Full && !table->GetPointData()->GetArray("VDM"))
    {
      warnings.push_back(place + ".baked: " + baked +
        ": holds the factors of a table, so that quality full is that of all of them");
    }
  }
  mapper->SetTable(table);
  if (!mapper->GetTable())
  {
    throw MesoInputError(place + ": " + (baked.empty() ? "the table" : baked) +
      ": is no table of view-dependent displacements");
  }
}

vtkSmartPointer<vtkImageData> MesoReadVDMHeights(const std::string& baked, const std::string& place)
{
  const MesoBaked file = Read(baked, place);
  auto* heights = vtkFloatArray::SafeDownCast(file.Table->GetFieldData()->GetArray("Heights"));
  int size[3];
  file.Table->GetDimensions(size);
  if (!heights || heights->GetNumberOfValues() != vtkIdType(size[0]) * size[1])
  {
    throw MesoInputError(place + ": " + baked + ": holds no heights of its size");
  }
  for (vtkIdType i = 0; i < heights->GetNumberOfValues(); ++i)
  {
    if (!(heights->GetValue(i) >= 0.f && heights->GetValue(i) <= 1.f))
    {
      throw MesoInputError(place + ": " + baked + ": holds the height " +
        std::to_string(heights->GetValue(i)) + " at " + std::to_string(i) + ", not in [0,1]");
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(heights);
  return image;
}

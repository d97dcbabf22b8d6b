// Maps from geometry: what a coarse mesh needs to look like a detailed one.

#include "ErrorRecorder.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoMapFromMesh.h"
#include "vtkMesoShapeSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
/// A grid of n x n squares over (u, v) in [0, width] x [0,1], with texture coordinates (u, v).
vtkSmartPointer<vtkPolyData> Grid(
  int n, const std::function<std::array<double, 3>(double, double)>& place, double width = 1.)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double u = width * i / n;
      const double v = static_cast<double>(j) / n;
      points->InsertNextPoint(place(u, v).data());
      coordinates->InsertNextTuple2(u, v);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType low = vtkIdType(j) * (n + 1) + i;
      cells->InsertNextCell({ low, low + 1, low + n + 2 });
      cells->InsertNextCell({ low, low + n + 2, low + n + 1 });
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetTCoords(coordinates);
  return mesh;
}

vtkSmartPointer<vtkPolyData> FlatBase()
{
  return Grid(2, [](double u, double v) { return std::array<double, 3>{ 2. * u, v, 0. }; });
}

double Wave(double u, double v)
{
  return 0.05 * std::cos(2. * vtkMath::Pi() * u) + 0.03 * std::sin(2. * vtkMath::Pi() * v);
}

vtkSmartPointer<vtkPolyData> WavyDetail(double width = 1.)
{
  return Grid(
    96,
    [](double u, double v) {
      return std::array<double, 3>{ 2. * u, v, Wave(u, v) };
    },
    width);
}

double Value(vtkMesoMapFromMesh* maps, const char* name, int column, int row, int component = 0)
{
  vtkImageData* image = maps->GetOutput();
  return image->GetPointData()->GetArray(name)->GetComponent(
    vtkIdType(row) * image->GetDimensions()[0] + column, component);
}

std::string Refusal(vtkMesoMapFromMesh* maps, vtkPolyData* base, vtkPolyData* detail)
{
  ErrorRecorder recorder;
  recorder.Watch(maps);
  maps->SetInputData(base);
  maps->SetDetailData(detail);
  maps->Update();
  EXPECT_EQ(maps->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(recorder.Errors.size(), 1u);
  maps->RemoveAllObservers();
  return recorder.Errors.empty() ? "" : recorder.Errors.front();
}
}

TEST(MapFromMesh, OfAWaveOverAPlaneIsTheWave)
{
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(FlatBase());
  maps->SetDetailData(WavyDetail());
  maps->SetSize(40, 30);
  maps->Update();
  EXPECT_EQ(maps->GetNumberOfMetTexels(), 40 * 30);
  EXPECT_EQ(maps->GetNumberOfVoidTexels(), 0);
  EXPECT_EQ(maps->GetNumberOfFoldTexels(), 0);
  EXPECT_EQ(maps->GetNumberOfOverlappingTexels(), 0);
  double error = 0.;
  double angle = 0.;
  for (int row = 0; row < 30; ++row)
  {
    for (int column = 0; column < 40; ++column)
    {
      const double u = (column + 0.5) / 40.;
      const double v = (row + 0.5) / 30.;
      error = std::max(error, std::abs(Value(maps, "Displacement", column, row) - Wave(u, v)));
      double expected[3] = { 0.05 * vtkMath::Pi() * std::sin(2. * vtkMath::Pi() * u),
        -0.06 * vtkMath::Pi() * std::cos(2. * vtkMath::Pi() * v), 1. };
      vtkMath::Normalize(expected);
      for (const char* name : { "NormalObject", "Normal" }) // equal over this base
      {
        double cosine = 0.;
        for (int k = 0; k < 3; ++k)
        {
          cosine += expected[k] * Value(maps, name, column, row, k);
        }
        angle = std::max(angle, std::acos(std::min(1., cosine)));
      }
    }
  }
  // Facets of 1/96: sagitta (2 pi / 96)^2 / 8 of the amplitudes, 0.08 in all.
  EXPECT_LT(error, 0.08 * 5.4e-4);
  EXPECT_LT(angle, 0.005);
  EXPECT_NEAR(maps->GetDisplacementRange()[0], -0.08, 1e-3);
  EXPECT_NEAR(maps->GetDisplacementRange()[1], 0.08, 1e-3);
}

TEST(MapFromMesh, LooksInwardAndOutwardAlongInterpolatedNormals)
{
  // A coarse sphere inside of a fine one, and around it.
  for (const double radius : { 0.9, 1.15 })
  {
    vtkNew<vtkMesoShapeSource> base;
    base->SetShape("sphere");
    base->SetParameter("rings", { 12. });
    base->SetParameter("sides", { 24. });
    vtkNew<vtkMesoShapeSource> detail;
    detail->SetShape("sphere");
    detail->SetParameter("radius", { radius });
    detail->SetParameter("rings", { 200. });
    detail->SetParameter("sides", { 400. });
    base->Update();
    const double baseRadius = base->GetOutput()->GetBounds()[5];
    vtkNew<vtkMesoMapFromMesh> maps;
    maps->SetInputConnection(base->GetOutputPort());
    maps->SetDetailConnection(detail->GetOutputPort());
    maps->SetSize(48, 24);
    maps->SetReach(0.7);
    maps->Update();
    EXPECT_EQ(maps->GetNumberOfVoidTexels(), 0);
    EXPECT_EQ(maps->GetNumberOfFoldTexels(), 0) << "a thin detail's far side is not its outer side";
    // At vertices s is the difference of the radii, between them more, by the base's sagitta.
    EXPECT_GT(maps->GetDisplacementRange()[0], radius - baseRadius - 1e-3);
    EXPECT_LT(maps->GetDisplacementRange()[1], radius - baseRadius + 0.03);
  }
}

TEST(MapFromMesh, GivesTheDetailBackWhenDisplaced)
{
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(FlatBase());
  maps->SetDetailData(WavyDetail());
  maps->SetSize(128, 128);
  maps->Update();
  const double low = maps->GetDisplacementRange()[0];
  const double depth = maps->GetDisplacementRange()[1] - low;
  vtkNew<vtkFloatArray> heights;
  vtkDataArray* displacements = maps->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < displacements->GetNumberOfTuples(); ++i)
  {
    heights->InsertNextValue(std::min(
      1.f, std::max(0.f, static_cast<float>((displacements->GetTuple1(i) - low) / depth))));
  }
  vtkNew<vtkImageData> map;
  map->SetDimensions(128, 128, 1);
  map->GetPointData()->SetScalars(heights);
  vtkNew<vtkMesoDisplacedMesh> displaced;
  displaced->SetInputData(FlatBase());
  displaced->SetHeightMapData(map);
  displaced->SetScale(depth);
  displaced->SetReference(-low / depth);
  displaced->Update();
  vtkPolyData* mesh = displaced->GetOutput();
  ASSERT_GT(mesh->GetNumberOfPoints(), 10000);
  double error = 0.;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double place[3];
    mesh->GetPoint(i, place);
    error = std::max(error, std::abs(place[2] - Wave(0.5 * place[0], place[1])));
  }
  // Facets and texels: second differences of the wave over 1/96 and 1/128.
  EXPECT_LT(error, 1e-4);
}

TEST(MapFromMesh, FillsWhatMeetsNothing)
{
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(FlatBase());
  maps->SetDetailData(WavyDetail(0.5)); // over the left half only
  maps->SetSize(40, 30);
  maps->Update();
  EXPECT_EQ(maps->GetNumberOfMetTexels(), 20 * 30);
  EXPECT_EQ(maps->GetNumberOfVoidTexels(), 20 * 30);
  EXPECT_EQ(Value(maps, "State", 19, 3), 1.);
  EXPECT_EQ(Value(maps, "State", 20, 3), 2.);
  for (int column = 20; column < 40; ++column)
  {
    EXPECT_LE(std::abs(Value(maps, "Displacement", column, 7)), 0.081);
    const double length = std::hypot(Value(maps, "Normal", column, 7, 0),
      Value(maps, "Normal", column, 7, 1), Value(maps, "Normal", column, 7, 2));
    EXPECT_NEAR(length, 1., 1e-6);
  }
  EXPECT_NEAR(Value(maps, "Displacement", 20, 7), Value(maps, "Displacement", 19, 7), 0.02);
}

TEST(MapFromMesh, LaysChartsOverTheMapsBorder)
{
  // The same base with its coordinates moved by 0.3 along u: the wave runs on over the border.
  const auto base = FlatBase();
  vtkDataArray* coordinates = base->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, coordinates->GetComponent(i, 0) + 0.3);
  }
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(base);
  maps->SetDetailData(WavyDetail());
  maps->SetSize(40, 30);
  maps->Update();
  EXPECT_EQ(maps->GetNumberOfMetTexels(), 40 * 30);
  EXPECT_EQ(maps->GetNumberOfOverlappingTexels(), 0);
  EXPECT_NEAR(Value(maps, "Displacement", 2, 7), Wave(2.5 / 40. + 0.7, 7.5 / 30.), 1e-4);
  EXPECT_NEAR(Value(maps, "Displacement", 35, 7), Wave(35.5 / 40. - 0.3, 7.5 / 30.), 1e-4);
}

TEST(MapFromMesh, TellsFolds)
{
  // A second sheet above the right half: the line meets the outer side twice there, and the nearest
  // sheet jumps at the border.
  vtkNew<vtkMesoMapFromMesh> maps;
  const auto twoSheets = Grid(40,
    [](double u, double v)
    {
      const bool above = v > 0.5; // rows of the grid are laid over the base a second time
      return std::array<double, 3>{ above ? 1. + u : 2. * u, above ? 2. * v - 1. : 2. * v,
        above ? 0.1 : -0.02 };
    });
  maps->SetInputData(FlatBase());
  maps->SetDetailData(twoSheets);
  maps->SetSize(40, 30);
  maps->Update();
  EXPECT_EQ(Value(maps, "State", 5, 15), 1.);
  EXPECT_EQ(Value(maps, "State", 35, 15), 3.);
  EXPECT_GT(maps->GetNumberOfFoldTexels(), 500);
  EXPECT_NEAR(Value(maps, "Displacement", 35, 15), -0.02, 1e-6) << "the nearest is taken";

  // A step of 0.1 within a texel width of 0.05 is steep; 8 texel widths are the limit by default.
  const auto step = Grid(400,
    [](double u, double v)
    {
      return std::array<double, 3>{ 2. * u, v,
        0.06 * std::min(1., std::max(0., 400. * (u - 0.5))) };
    });
  maps->SetDetailData(step);
  maps->SetSlopeLimit(1.1);
  maps->Update();
  EXPECT_EQ(maps->GetNumberOfFoldTexels(), 2 * 30);
  maps->SetSlopeLimit(1.3);
  maps->Update();
  EXPECT_EQ(maps->GetNumberOfFoldTexels(), 0);
}

TEST(MapFromMesh, CarriesArraysOfTheDetail)
{
  const auto detail = WavyDetail();
  vtkNew<vtkDoubleArray> places;
  places->SetName("Place");
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < detail->GetNumberOfPoints(); ++i)
  {
    places->InsertNextTuple2(detail->GetPoint(i)[0], detail->GetPoint(i)[1]);
  }
  detail->GetPointData()->AddArray(places);
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(FlatBase());
  maps->SetDetailData(detail);
  maps->SetSize(40, 30);
  maps->AddDetailArray("Place");
  maps->Update();
  EXPECT_NEAR(Value(maps, "Place", 12, 7, 0), 2. * 12.5 / 40., 1e-6);
  EXPECT_NEAR(Value(maps, "Place", 12, 7, 1), 7.5 / 30., 1e-6);
  maps->AddDetailArray("None");
  EXPECT_NE(Refusal(maps, FlatBase(), detail).find("named None"), std::string::npos);
}

TEST(MapFromMesh, ByTextureDropsWhatIsOffTheNormal)
{
  const auto moved = Grid(10,
    [](double u, double v) {
      return std::array<double, 3>{ 2. * u + 0.25, v, 0.125 };
    });
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(FlatBase());
  maps->SetDetailData(moved);
  maps->SetSize(16, 16);
  maps->SetCorrespondence(vtkMesoMapFromMesh::Texture);
  maps->Update();
  EXPECT_NEAR(Value(maps, "Displacement", 3, 4), 0.125, 1e-12);
  EXPECT_NEAR(maps->GetLargestDrift(), 0.25, 1e-12);
  EXPECT_EQ(maps->GetNumberOfVoidTexels(), 0);
}

TEST(MapFromMesh, TangentSpaceFollowsMirroredAndShearedCharts)
{
  // u runs against x, and along y as well; the detail is a tilted plane.
  const auto base = Grid(3,
    [](double u, double v) {
      return std::array<double, 3>{ -u, v + 0.4 * u, 0. };
    });
  // Seen from above the grid's triangles run clockwise now.
  base->GetPolys()->ReverseCellAtId(0);
  for (vtkIdType cell = 1; cell < base->GetNumberOfPolys(); ++cell)
  {
    base->GetPolys()->ReverseCellAtId(cell);
  }
  const auto detail = Grid(3,
    [](double u, double v) {
      return std::array<double, 3>{ 4. * u - 2., 4. * v - 2., 0.1 * (4. * u - 2.) };
    });
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetInputData(base);
  maps->SetDetailData(detail);
  maps->SetSize(8, 8);
  maps->Update();
  ASSERT_EQ(maps->GetNumberOfMetTexels(), 64);
  const double t[3] = { -1. / std::sqrt(1.16), 0.4 / std::sqrt(1.16), 0. };
  const double b[3] = { 0., 1., 0. };
  double rebuilt[3];
  for (int k = 0; k < 3; ++k)
  {
    rebuilt[k] = t[k] * Value(maps, "Normal", 3, 3, 0) + b[k] * Value(maps, "Normal", 3, 3, 1) +
      (k == 2 ? Value(maps, "Normal", 3, 3, 2) : 0.);
  }
  vtkMath::Normalize(rebuilt);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(rebuilt[k], Value(maps, "NormalObject", 3, 3, k), 1e-6);
  }
  EXPECT_NEAR(rebuilt[0], -0.1 / std::sqrt(1.01), 1e-6);
}

TEST(MapFromMesh, RefusesWhatCannotBeBaked)
{
  vtkNew<vtkMesoMapFromMesh> maps;
  maps->SetSize(8, 8);
  const auto base = FlatBase();
  const auto detail = WavyDetail();
  vtkNew<vtkPolyData> empty;
  EXPECT_NE(Refusal(maps, base, empty).find("the detail has no points"), std::string::npos);
  EXPECT_NE(Refusal(maps, empty, detail).find("texture coordinates"), std::string::npos);
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(base);
  bare->GetPointData()->Initialize();
  EXPECT_NE(Refusal(maps, bare, detail).find("texture coordinates"), std::string::npos);
  const auto wide = Grid(
    1,
    [](double u, double v) {
      return std::array<double, 3>{ u, v, 0. };
    },
    1.5);
  EXPECT_NE(
    Refusal(maps, wide, detail).find("triangle 0 is longer than the map"), std::string::npos);
  const auto far = Grid(2, [](double u, double v) { return std::array<double, 3>{ u, v, 50. }; });
  EXPECT_NE(
    Refusal(maps, base, far).find("nothing of the base meets the detail"), std::string::npos);
  maps->SetSize(8, 20000);
  EXPECT_NE(Refusal(maps, base, detail).find("8 x 20000"), std::string::npos);
}

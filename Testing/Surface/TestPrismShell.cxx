// vtkMesoPrismShell: prisms share corners, fins and diagonals, so that the shell of a closed mesh has no
// opening and that of an open one only where it should; what turns over is told; what cannot be is refused.

#include "DicedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoPrismShell.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkFieldData.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

namespace
{
class PrismShell : public testing::Test
{
protected:
  vtkNew<vtkMesoPrismShell> Filter;

  PrismShell() { this->Filter->InnerFinsOn(); }

  vtkPolyData* Shell(vtkPolyData* mesh, double thickness)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->SetThickness(thickness);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  static int FlagsOf(vtkPolyData* shell, vtkIdType prism)
  {
    return static_cast<int>(
      shell->GetFieldData()->GetArray("MesoPrismTable")->GetComponent(7 * prism + 6, 0));
  }

  /// Triangles of fins by their places, sorted: how often each is there, and with which winding.
  static std::map<std::set<MesoVector>, std::array<int, 2>> FinTriangles(vtkPolyData* shell)
  {
    std::map<std::set<MesoVector>, std::array<int, 2>> fins;
    const auto triangles = TrianglesOf(shell);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      if (i % 8 >= 2)
      {
        std::array<MesoVector, 3> places;
        for (int k = 0; k < 3; ++k)
        {
          places[k] = PositionOf(shell, triangles[i][k]);
        }
        const std::set<MesoVector> key(places.begin(), places.end());
        // Which way round, from the least place on.
        const auto least = std::min_element(places.begin(), places.end()) - places.begin();
        const bool turned = places[(least + 1) % 3] < places[(least + 2) % 3];
        ++fins[key][turned ? 1 : 0];
      }
    }
    return fins;
  }

  /// Fins whose triangles are there once, and others that are not there once from either side.
  static std::array<int, 2> LoneAndWrong(vtkPolyData* shell)
  {
    std::array<int, 2> counts = { 0, 0 };
    for (const auto& fin : FinTriangles(shell))
    {
      const std::array<int, 2>& ways = fin.second;
      counts[0] += ways[0] + ways[1] == 1 ? 1 : 0;
      counts[1] += ways[0] + ways[1] != 1 && (ways[0] != 1 || ways[1] != 1) ? 1 : 0;
    }
    return counts;
  }

  /// Volume that the shell's faces enclose, each prism's fronts outward.
  static double VolumeOf(vtkPolyData* shell)
  {
    double volume = 0.;
    for (const auto& t : TrianglesOf(shell))
    {
      volume += MesoDot(PositionOf(shell, t[0]),
                  MesoCross(PositionOf(shell, t[1]), PositionOf(shell, t[2]))) /
        6.;
    }
    return volume;
  }
};
}

TEST_F(PrismShell, OfATorusHasNoOpening)
{
  const auto torus = ShapeMesh("torus", {}, vtkAlgorithm::SINGLE_PRECISION);
  vtkPolyData* shell = this->Shell(torus, 0.1);
  const vtkIdType triangles = torus->GetNumberOfPolys();
  EXPECT_EQ(shell->GetNumberOfPolys(), 8 * triangles);
  EXPECT_EQ(shell->GetNumberOfPoints(), 6 * triangles);
  EXPECT_EQ(this->LoneAndWrong(shell), (std::array<int, 2>{ 0, 0 }));
  EXPECT_EQ(this->FinTriangles(shell).size(), 3u * triangles); // two for each of 3/2 edges
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfSeamFins(), 0); // by whole tiles the map goes on
  EXPECT_TRUE(this->Filter->GetInvertedTriangles().empty());
  // Between tubes of radius 0.4 and 0.5: 2 pi^2 R (r1^2 - r0^2), less what facets cut off.
  const double volume = this->VolumeOf(shell);
  const double smooth = 2. * 9.8696 * (0.5 * 0.5 - 0.4 * 0.4);
  EXPECT_GT(volume, 0.95 * smooth);
  EXPECT_LT(volume, smooth);
}

TEST_F(PrismShell, PrismsKnowThoseBeyondTheirFins)
{
  for (const char* shape : { "torus", "plane", "sphere" })
  {
    vtkPolyData* shell = this->Shell(ShapeMesh(shape, {}), 0.05);
    vtkDataArray* table = shell->GetFieldData()->GetArray("MesoPrismTable");
    const vtkIdType prisms = table->GetNumberOfTuples() / 7;
    const auto beyond = [&](vtkIdType prism, int fin)
    { return static_cast<vtkIdType>(table->GetComponent(7 * prism + 6, 1 + fin)); };
    // The bottom's corners of a fin.
    const auto edge = [&](vtkIdType prism, int fin)
    {
      return std::set<MesoVector>{ PositionOf(shell, 6 * prism + fin),
        PositionOf(shell, 6 * prism + (fin + 1) % 3) };
    };
    vtkIdType open = 0;
    for (vtkIdType prism = 0; prism < prisms; ++prism)
    {
      for (int fin = 0; fin < 3; ++fin)
      {
        const vtkIdType other = beyond(prism, fin);
        ASSERT_LT(other, prisms);
        open += other < 0 ? 1 : 0;
        int shared = 0;
        for (int k = 0; k < 3 && other >= 0; ++k)
        {
          shared += beyond(other, k) == prism && edge(other, k) == edge(prism, fin) ? 1 : 0;
        }
        ASSERT_EQ(shared, other < 0 ? 0 : 1) << shape << " " << prism << " " << fin;
      }
    }
    EXPECT_EQ(open, this->Filter->GetNumberOfOpenFins());
    // The outside alone: bottoms, tops and open fins.
    this->Filter->InnerFinsOff();
    this->Filter->Update();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPolys(), 2 * prisms + 2 * open) << shape;
    this->Filter->InnerFinsOn();
  }
}

TEST_F(PrismShell, CornersAreWhereTheMapOfPrismsSays)
{
  const auto sphere = ShapeMesh("sphere", {});
  this->Filter->SetReference(0.25);
  vtkPolyData* shell = this->Shell(sphere, 0.2);
  vtkDataArray* table = shell->GetFieldData()->GetArray("MesoPrismTable");
  vtkDataArray* centre = shell->GetFieldData()->GetArray("MesoPrismCentre");
  for (vtkIdType point = 0; point < shell->GetNumberOfPoints(); ++point)
  {
    const bool top = point % 6 >= 3;
    ASSERT_NEAR(MesoLength(PositionOf(shell, point)), top ? 1.15 : 0.95, 1e-12);
    ASSERT_EQ(TupleOf(shell, "MesoPrism", point)[0], std::floor(point / 6.));
    ASSERT_EQ(TupleOf(shell, "MesoShellHeight", point)[0], top ? 1. : 0.);
    // The table holds the same: bottoms less the centre, rises, and texture coordinates.
    const vtkIdType row = point / 6 * 7 + point % 3;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double bottom = table->GetComponent(row, axis) + centre->GetComponent(0, axis);
      const double place = bottom + (top ? table->GetComponent(row + 3, axis) : 0.);
      ASSERT_NEAR(place, PositionOf(shell, point)[axis], 2e-7);
    }
    ASSERT_NEAR(table->GetComponent(row, 3), TupleOf(shell, "TextureCoordinates", point)[0], 1e-7);
    ASSERT_NEAR(
      table->GetComponent(row + 3, 3), TupleOf(shell, "TextureCoordinates", point)[1], 1e-7);
  }
}

TEST_F(PrismShell, AnOpenMeshIsClosedByItsFins)
{
  const auto plane = ShapeMesh("plane", { { "segments", { 3., 2. } } });
  vtkPolyData* shell = this->Shell(plane, 0.5);
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 10);
  EXPECT_EQ(this->LoneAndWrong(shell), (std::array<int, 2>{ 20, 0 }));
  double bounds[6];
  plane->GetBounds(bounds);
  EXPECT_NEAR(
    this->VolumeOf(shell), 0.5 * (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]), 1e-12);
  int ends = 0;
  for (vtkIdType prism = 0; prism < plane->GetNumberOfPolys(); ++prism)
  {
    for (int k = 0; k < 3; ++k)
    {
      ends += (this->FlagsOf(shell, prism) >> (3 + k)) & 1;
    }
  }
  EXPECT_EQ(ends, 10);
}

TEST_F(PrismShell, CountsPrismsNotTriangles)
{
  // Triangles without area have no prism: those after them have lower numbers than their triangles.
  const std::vector<MesoVector> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
    { 0., 1., 0. }, { 0.5, 0., 0. } };
  const std::vector<std::array<double, 2>> uv = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. },
    { 0.5, 0. } };
  vtkPolyData* shell =
    this->Shell(MakeMesh(points, uv, { { 0, 4, 1 }, { 0, 1, 2 }, { 0, 2, 3 } }), 0.1);
  EXPECT_EQ(this->Filter->GetNumberOfDegenerateTriangles(), 1);
  vtkFieldData* fields = shell->GetFieldData();
  ASSERT_EQ(fields->GetArray("MesoPrismTable")->GetNumberOfTuples(), 2 * 7);
  const auto beyond = [&](vtkIdType prism, int fin)
  { return fields->GetArray("MesoPrismTable")->GetComponent(7 * prism + 6, 1 + fin); };
  EXPECT_EQ(beyond(0, 2), 1.);
  EXPECT_EQ(beyond(1, 0), 0.);
  EXPECT_EQ(fields->GetArray("MesoPrismTriangle")->GetComponent(0, 0), 1.);
  EXPECT_EQ(fields->GetArray("MesoPrismTriangle")->GetComponent(1, 0), 2.);
}

TEST_F(PrismShell, SeamsAreCutAlikeWhateverTheirPointsNumbers)
{
  // A saddle of two triangles whose common edge has points of its own on either side, numbered the other
  // way round: by the points' numbers each would cut the fin along another diagonal.
  const std::vector<MesoVector> points = { { 0., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0.3 },
    { 1., 1., 0. }, { 0., 0., 0. }, { 1., 0., 0.3 } };
  const std::vector<std::array<double, 2>> uv = { { 0., 0. }, { 1., 1. }, { 0., 1. }, { 1., 1. },
    { 0., 0. }, { 1., 0. } };
  const auto mesh = MakeMesh(points, uv, { { 0, 1, 2 }, { 3, 4, 5 } });
  // Normals that are the same at both ends' points, and no two alike along the edge: the fin is bent.
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const double lean : { 0.6, -0.6, 0., -0.6, 0.6, 0. })
  {
    normals->InsertNextTuple3(lean, 0., std::sqrt(1. - lean * lean));
  }
  mesh->GetPointData()->SetNormals(normals);
  vtkPolyData* shell = this->Shell(mesh, 0.2);
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 4);
  EXPECT_EQ(this->LoneAndWrong(shell), (std::array<int, 2>{ 8, 0 }));
  EXPECT_NE(this->FlagsOf(shell, 0) & 1, this->FlagsOf(shell, 1) & 1);
}

TEST_F(PrismShell, BrokenTilesAreSeams)
{
  // A torus with 2 and a half tiles around: the map jumps where it closes.
  const auto torus = ShapeMesh("torus", { { "rings", { 12. } }, { "sides", { 8. } } });
  this->Filter->SetTiles(2.5, 1.);
  this->Shell(torus, 0.1);
  EXPECT_EQ(this->Filter->GetNumberOfSeamFins(), 2 * 8);
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 0);
  this->Filter->SetTiles(3., 1.);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetNumberOfSeamFins(), 0);
}

TEST_F(PrismShell, HardEdgesTJunctionsAndDuplicatesEndByFins)
{
  // A ridge of two squares at a right angle: smooth, it is one shell; with split normals, two.
  const std::vector<MesoVector> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
    { 0., 1., 0. }, { 1., 0., -1. }, { 1., 1., -1. } };
  const std::vector<std::array<double, 2>> uv = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. },
    { 2., 0. }, { 2., 1. } };
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(MakeMesh(points, uv, { { 0, 1, 2, 3 }, { 1, 4, 5, 2 } }));
  frames->Update();
  this->Shell(frames->GetOutput(), 0.1);
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 6);
  frames->SplitNormalsOn();
  frames->Update();
  EXPECT_EQ(
    this->LoneAndWrong(this->Shell(frames->GetOutput(), 0.1)), (std::array<int, 2>{ 16, 0 }));
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 8);

  // A T-junction: the edge from (0, 0) to (2, 0) on one side, in two parts on the other.
  const std::vector<MesoVector> tee = { { 0., 0., 0. }, { 2., 0., 0. }, { 1., 1., 0. },
    { 1., 0., 0. }, { 1., -1., 0. } };
  const std::vector<std::array<double, 2>> teeUv = { { 0., 0. }, { 1., 0. }, { 0.5, 0.5 },
    { 0.5, 0. }, { 0.5, -0.5 } };
  this->Shell(MakeMesh(tee, teeUv, { { 0, 1, 2 }, { 0, 4, 3 }, { 3, 4, 1 } }), 0.1);
  EXPECT_EQ(this->Filter->GetNumberOfOpenFins(), 2 + 1 + 2 + 2);

  // The same triangle twice, and one without area.
  this->Shell(MakeMesh(tee, teeUv, { { 0, 1, 2 }, { 0, 1, 2 }, { 0, 3, 1 } }), 0.1);
  EXPECT_EQ(this->Filter->GetNumberOfDegenerateTriangles(), 1);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPolys(), 16);
  // Neither of the two is beyond the other's fins.
  this->Filter->InnerFinsOff();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPolys(), 16);
}

TEST_F(PrismShell, ThicknessPastTheCurvatureIsTold)
{
  // Inward of a sphere of radius 1 there is room for 1.
  const auto sphere = ShapeMesh("sphere", {});
  this->Filter->SetReference(1.);
  this->Shell(sphere, 0.9);
  EXPECT_TRUE(this->Filter->GetInvertedTriangles().empty());
  EXPECT_EQ(this->Filter->GetLeastRise(), 1.);
  this->Shell(sphere, 1.2);
  EXPECT_EQ(this->Filter->GetInvertedTriangles().size(),
    std::size_t(sphere->GetNumberOfPolys() - this->Filter->GetNumberOfDegenerateTriangles()));
  this->Filter->ClampThicknessOn();
  this->Shell(sphere, 1.2);
  EXPECT_FALSE(this->Filter->GetInvertedTriangles().empty()); // those that would have
  EXPECT_LT(this->Filter->GetLeastRise(), 1. / 1.2);
  EXPECT_GT(this->Filter->GetLeastRise(), 0.6);
  // No corner is past the middle any more.
  vtkPolyData* clamped = this->Filter->GetOutput();
  for (vtkIdType i = 0; i < clamped->GetNumberOfPoints(); ++i)
  {
    const MesoVector normal = TupleOf(clamped, "Normals", i);
    ASSERT_GT(MesoDot(PositionOf(clamped, i), normal), 0.) << i;
  }

  // A corner whose normal leans over so far that one prism of a fan turns over at its top.
  auto plane = ShapeMesh("plane", { { "segments", { 2., 2. } }, { "size", { 2., 2. } } });
  vtkDataArray* normals = plane->GetPointData()->GetNormals();
  normals->SetTuple3(4, 0.9, 0., std::sqrt(1. - 0.81)); // the middle one
  this->Filter->ClampThicknessOff();
  this->Filter->SetReference(0.);
  this->Shell(plane, 0.2);
  EXPECT_TRUE(this->Filter->GetInvertedTriangles().empty());
  this->Shell(plane, 2.5);
  EXPECT_FALSE(this->Filter->GetInvertedTriangles().empty());
  EXPECT_LT(this->Filter->GetInvertedTriangles().size(), 8u);
}

TEST_F(PrismShell, SlicesAreSectionsOfThePrisms)
{
  const auto sphere = ShapeMesh("sphere", {});
  const vtkIdType prisms = this->Shell(sphere, 0.2)->GetNumberOfPolys() / 8;
  this->Filter->SetSlices(4);
  this->Filter->Update();
  vtkPolyData* slices = this->Filter->GetOutput();
  ASSERT_EQ(slices->GetNumberOfPolys(), 4 * prisms);
  ASSERT_EQ(slices->GetNumberOfPoints(), 12 * prisms);
  for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
  {
    const double z = (i / 3 % 4 + 0.5) / 4.;
    ASSERT_NEAR(MesoLength(PositionOf(slices, i)), 1. + 0.2 * z, 1e-12);
    ASSERT_EQ(TupleOf(slices, "MesoShellHeight", i)[0], z);
    ASSERT_EQ(TupleOf(slices, "MesoPrism", i)[0], std::floor(i / 12.));
  }
  // Wound as the mesh: their fronts are outside.
  EXPECT_GT(this->VolumeOf(slices), 0.);
}

TEST_F(PrismShell, TurnedTrianglesAreDrawnFromOutside)
{
  // All corners run the other way round than their normals say, as in a mirrored node: faces follow the
  // winding. One of many that does is turned back.
  const auto plane = ShapeMesh("plane", { { "segments", { 2., 2. } } });
  const double volume = this->VolumeOf(this->Shell(plane, 0.5));
  EXPECT_GT(volume, 0.);
  vtkNew<vtkCellArray> turned;
  vtkNew<vtkCellArray> one;
  const auto triangles = TrianglesOf(plane);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const vtkIdType corners[3] = { triangles[i][0], triangles[i][2], triangles[i][1] };
    turned->InsertNextCell(3, corners);
    one->InsertNextCell(3, i == 3 ? corners : triangles[i].data());
  }
  plane->SetPolys(turned);
  EXPECT_NEAR(this->VolumeOf(this->Shell(plane, 0.5)), -volume, 1e-12);
  plane->SetPolys(one);
  EXPECT_NEAR(this->VolumeOf(this->Shell(plane, 0.5)), volume, 1e-12);
}

TEST_F(PrismShell, RefusalsAreOneLineAndGiveNothing)
{
  ErrorRecorder recorder;
  recorder.Watch(this->Filter);
  const auto expect = [&](vtkPolyData* mesh, double thickness, const char* part)
  {
    recorder.Clear();
    EXPECT_EQ(this->Shell(mesh, thickness)->GetNumberOfPoints(), 0);
    ASSERT_EQ(recorder.Errors.size(), 1u) << part;
    EXPECT_NE(recorder.Errors[0].find(part), std::string::npos) << recorder.Errors[0];
    EXPECT_NE(this->Filter->GetErrorMessage().find(part), std::string::npos);
  };
  const auto plane = ShapeMesh("plane", {});
  expect(plane, 0., "Thickness must be more than 0");
  expect(plane, std::numeric_limits<double>::quiet_NaN(), "Thickness must be more than 0");
  const auto bare = ShapeMesh("plane", {});
  bare->GetPointData()->SetTCoords(nullptr);
  bare->GetPointData()->RemoveArray("TextureCoordinates");
  expect(bare, 0.1, "texture coordinates");
  const auto broken = ShapeMesh("plane", {});
  broken->GetPoints()->SetPoint(1, std::numeric_limits<double>::infinity(), 0., 0.);
  expect(broken, 0.1, "the position of point 1 is not finite");
  this->Filter->SetTiles(0., 1.);
  expect(plane, 0.1, "Tiles must be more than 0");
  this->Filter->SetTiles(1., 1.);
  recorder.Clear();
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(this->Shell(nothing, 0.1)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(recorder.Errors.empty());
}

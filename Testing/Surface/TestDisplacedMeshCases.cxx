// vtkMesoDisplacedMesh as a filter: what it takes and refuses, its budget, degenerate input, and that
// results depend on nothing but the input.

#include "DicedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoPatternSource.h"

#include "vtkCallbackCommand.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const std::vector<MesoVector> Square = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
  { 0., 1., 0. } };
const std::vector<std::array<double, 2>> Chart = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };

vtkSmartPointer<vtkPolyData> OneSquare()
{
  return MakeMesh(Square, Chart, { { 0, 1, 2, 3 } });
}

class DisplacedMeshCases : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Recorder.Watch(this->Filter);
    this->Filter->SetHeightMapData(PatternMap("smooth", 8));
    this->Filter->SetScale(0.1);
  }

  vtkPolyData* Run(vtkPolyData* mesh)
  {
    this->Recorder.Clear();
    this->Filter->SetInputData(mesh);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  void ExpectRefused(vtkPolyData* mesh, const std::string& part)
  {
    vtkPolyData* output = this->Run(mesh);
    ASSERT_EQ(this->Recorder.Errors.size(), 1u) << part;
    EXPECT_NE(this->Recorder.Errors[0].find(part), std::string::npos) << this->Recorder.Errors[0];
    EXPECT_NE(this->Filter->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }

  /// All numbers finite, normals unit, relief in [0,1]; and no error.
  void ExpectSound(vtkPolyData* mesh)
  {
    EXPECT_TRUE(this->Recorder.Errors.empty());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      EXPECT_TRUE(std::isfinite(MesoLength(PositionOf(mesh, i)))) << i;
      EXPECT_NEAR(MesoLength(TupleOf(mesh, "Normals", i)), 1., 1e-6) << i;
      const double relief = TupleOf(mesh, "MesoRelief", i)[0];
      EXPECT_TRUE(relief >= 0. && relief <= 1.) << i;
    }
  }

  ErrorRecorder Recorder;
  vtkNew<vtkMesoDisplacedMesh> Filter;
};

std::string BytesOf(vtkPolyData* mesh)
{
  std::string bytes;
  const auto add = [&](vtkDataArray* array)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      std::size_t(array->GetNumberOfValues()) * array->GetDataTypeSize());
  };
  add(mesh->GetPoints()->GetData());
  for (const char* name : { "Normals", "TextureCoordinates", "MesoRelief" })
  {
    add(mesh->GetPointData()->GetArray(name));
  }
  add(mesh->GetPolys()->GetConnectivityArray());
  return bytes;
}
}

TEST_F(DisplacedMeshCases, RefusesWhatItCannotUseInOneLine)
{
  this->ExpectRefused(MakeMesh(Square, {}, { { 0, 1, 2 } }), "no texture coordinates");
  auto chart = Chart;
  chart[2] = { 1., NaN };
  this->ExpectRefused(
    MakeMesh(Square, chart, { { 0, 1, 2, 3 } }), "texture coordinate of point 2 is not finite");
  auto positions = Square;
  positions[1][2] = NaN;
  this->ExpectRefused(
    MakeMesh(positions, Chart, { { 0, 1, 2, 3 } }), "position of point 1 is not finite");
  this->ExpectRefused(
    MakeMesh(Square, Chart, { { 0, 1, 2 }, { 0, 1, 4 } }), "polygon 1 names point 4");
  EXPECT_GT(this->Run(OneSquare())->GetNumberOfPolys(), 0);
}

TEST_F(DisplacedMeshCases, RefusesMapsThatAreNoHeights)
{
  const auto refused = [&](vtkImageData* map, const char* part)
  {
    this->Filter->SetHeightMapData(map);
    this->ExpectRefused(OneSquare(), part);
  };
  refused(MakeMap(4, 4, [](int i, int j) { return i == 3 && j == 2 ? NaN : 0.; }),
    "the height of texel (3, 2) is");
  refused(MakeMap(4, 4, [](int i, int j) { return i == 1 && j == 3 ? 1.5 : 0.; }),
    "the height of texel (1, 3) is 1.5, not in [0, 1]");
  vtkNew<vtkImageData> empty;
  refused(empty, "the height map is empty");
  vtkNew<vtkImageData> colours;
  colours->SetDimensions(2, 2, 1);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  refused(colours, "3 components of unsigned char, 1 of float is needed");
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  refused(volume, "2 slices");
}

TEST_F(DisplacedMeshCases, RefusesParametersOutOfRange)
{
  this->Filter->SetScale(-1.);
  this->ExpectRefused(OneSquare(), "Scale must be 0 or more, is -1");
  this->Filter->SetScale(NaN);
  this->ExpectRefused(OneSquare(), "Scale must be");
  this->Filter->SetScale(1.);
  this->Filter->SetTiles(1., 0.);
  this->ExpectRefused(OneSquare(), "Tiles along v must be more than 0, is 0");
  this->Filter->SetTiles(1., 1.);
  this->Filter->SetFacetsPerTexel(0.);
  this->ExpectRefused(OneSquare(), "FacetsPerTexel must be more than 0, is 0");
}

TEST_F(DisplacedMeshCases, RefusesMoreTrianglesThanItsBudget)
{
  // Two triangles of 16 segments an edge each.
  this->Filter->SetFacetsPerTexel(2.);
  this->Filter->SetMaximumNumberOfTriangles(2 * 16 * 16);
  EXPECT_EQ(this->Run(OneSquare())->GetNumberOfPolys(), 512);
  EXPECT_TRUE(this->Recorder.Errors.empty());
  this->Filter->SetMaximumNumberOfTriangles(2 * 16 * 16 - 1);
  this->ExpectRefused(OneSquare(), "dicing into 512 triangles is more than the limit of 511");
}

TEST_F(DisplacedMeshCases, RefusesTheImmenseWithoutTakingMemory)
{
  for (double facets : { 1e6, 1e12, 1e300 })
  {
    this->Filter->SetFacetsPerTexel(facets);
    this->ExpectRefused(OneSquare(), "more than the limit of 20000000");
  }
}

TEST_F(DisplacedMeshCases, TakesAnEmptyMesh)
{
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(this->Run(empty)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Recorder.Errors.empty());
  // Points that no cell uses are left out.
  EXPECT_EQ(this->Run(MakeMesh(Square, Chart, {}))->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Recorder.Errors.empty());
}

TEST_F(DisplacedMeshCases, CutsPolygonsAndStripsAndLeavesOutLines)
{
  const auto mesh = MakeMesh(Square, Chart, {});
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 3, 2 });
  mesh->SetStrips(strips);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  mesh->SetLines(lines);
  EXPECT_EQ(this->Run(mesh)->GetNumberOfPolys(), 2 * 8 * 8);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 2 * 8 * 8);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 9 * 9);
}

TEST_F(DisplacedMeshCases, OneTriangleAtEveryNumberOfSegments)
{
  for (int n : { 1, 2, 3, 4, 5, 6, 7, 40 })
  {
    for (int m : { 1, 2, 3, 4, 5, 6, 7, 41 })
    {
      // Edges of n, max(n, m) and m segments, of a map of 8 texels at a facet a texel.
      const auto mesh = MakeMesh({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. } },
        { { 0., 0. }, { n / 8., 0. }, { 0., m / 8. } }, { { 0, 1, 2 } });
      this->Filter->SetHeightMapData(MakeMap(8, 8, [](int, int) { return 1.; }));
      vtkPolyData* diced = this->Run(mesh);
      this->ExpectSound(diced);
      const int largest = std::max(n, m);
      const int least = std::min(n, m);
      if (n == m || least == 1)
      {
        EXPECT_EQ(diced->GetNumberOfPolys(), n == m ? n * n : n + m + largest - 2);
      }
      else
      {
        // About a triangle for each half of a square of segments, and never more than the grid's.
        EXPECT_GE(diced->GetNumberOfPolys(), largest * least);
        EXPECT_LE(diced->GetNumberOfPolys(), largest * (least + 2)) << n << " " << m;
      }
      // Its triangles cover the base once: all wound alike, and their areas add up.
      double area = 0.;
      for (const auto& t : TrianglesOf(diced))
      {
        const MesoVector cross =
          MesoCross(MesoDifference(PositionOf(diced, t[1]), PositionOf(diced, t[0])),
            MesoDifference(PositionOf(diced, t[2]), PositionOf(diced, t[0])));
        EXPECT_GT(cross[2], 0.) << n << " " << m;
        // No facet is longer than two segments, as no relief may be jumped over.
        for (int k = 0; k < 3; ++k)
        {
          const MesoVector edge =
            MesoDifference(PositionOf(diced, t[(k + 1) % 3]), PositionOf(diced, t[k]));
          EXPECT_LE(std::abs(edge[0]) * n, 2. + 1e-9) << n << " " << m;
          EXPECT_LE(std::abs(edge[1]) * m, 2. + 1e-9) << n << " " << m;
        }
        area += 0.5 * cross[2];
      }
      EXPECT_NEAR(area, 0.5, 1e-12) << n << " " << m;
      // Open edges are those of the triangle's rim.
      EXPECT_EQ(MergedEdges(diced).Wrong, n + m + largest) << n << " " << m;
    }
  }
}

TEST_F(DisplacedMeshCases, TextureCoordinatesWithoutArea)
{
  for (const auto& chart : std::vector<std::vector<std::array<double, 2>>>{
         { { 0.3, 0.3 }, { 0.3, 0.3 }, { 0.3, 0.3 }, { 0.3, 0.3 } },
         { { 0., 0. }, { 1., 0. }, { 1., 0. }, { 0., 0. } },
         { { 0., 0. }, { 1., 1. }, { 0.5, 0.5 }, { 0.25, 0.25 } } })
  {
    vtkPolyData* diced = this->Run(MakeMesh(Square, chart, { { 0, 1, 2, 3 } }));
    this->ExpectSound(diced);
    EXPECT_GT(diced->GetNumberOfPolys(), 0);
    for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(TupleOf(diced, "Normals", i), (MesoVector{ 0., 0., 1. }));
    }
  }
}

TEST_F(DisplacedMeshCases, HugeTinyAndFarMeshes)
{
  for (double size : { 1e-6, 1e6 })
  {
    auto positions = Square;
    for (MesoVector& p : positions)
    {
      p = MesoSum(MesoScaled(p, size), { 1e6 * size, 0., 0. });
    }
    this->Filter->SetScale(0.1 * size);
    vtkPolyData* diced = this->Run(MakeMesh(positions, Chart, { { 0, 1, 2, 3 } }));
    this->ExpectSound(diced);
    const auto texture = TextureOf(PatternMap("smooth", 8), MesoWrap::Repeat);
    for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
    {
      const MesoVector uv = TupleOf(diced, "TextureCoordinates", i);
      const double z = (texture.sampleHeight({ uv[0], uv[1] }) - 1.) * 0.1 * size;
      // A double holds 1e6 units to 1e-10 of one.
      EXPECT_NEAR(PositionOf(diced, i)[0], (1e6 + uv[0]) * size, 1e-9 * size);
      EXPECT_NEAR(PositionOf(diced, i)[2], z, 1e-12 * size);
    }
  }
}

TEST_F(DisplacedMeshCases, FlippedWindingKeepsTheNormalsSide)
{
  vtkPolyData* diced = this->Run(MakeMesh(Square, Chart, { { 3, 2, 1, 0 } }));
  // No normals are given: those of the winding point down, and so does the displacement.
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT(TupleOf(diced, "Normals", i)[2], -0.1);
    EXPECT_GE(PositionOf(diced, i)[2], 0.);
  }
  const auto turned = MakeMesh(Square, Chart, { { 3, 2, 1, 0 } });
  vtkNew<vtkDoubleArray> up;
  up->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    up->InsertNextTuple3(0., 0., 1.);
  }
  turned->GetPointData()->SetNormals(up);
  diced = this->Run(turned);
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    EXPECT_GT(TupleOf(diced, "Normals", i)[2], 0.1);
    EXPECT_LE(PositionOf(diced, i)[2], 0.);
  }
}

TEST_F(DisplacedMeshCases, OpposedNormalsGiveNoNaN)
{
  const auto mesh = OneSquare();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(0., 0., i % 2 == 0 ? 1. : -1.);
  }
  mesh->GetPointData()->SetNormals(normals);
  this->ExpectSound(this->Run(mesh));
}

TEST_F(DisplacedMeshCases, ResultsDependOnTheInputAlone)
{
  const auto torus = ShapeMesh("torus", { { "rings", { 12. } }, { "sides", { 8. } } });
  this->Filter->SetHeightMapData(PatternMap("brick", 64));
  this->Filter->SetTiles(3., 2.);
  std::string first;
  for (int threads : { 1, 2, 2 })
  {
    vtkSMPTools::Initialize(threads);
    this->Filter->Modified();
    const std::string bytes = BytesOf(this->Run(torus));
    first = first.empty() ? bytes : first;
    EXPECT_TRUE(bytes == first) << threads << " threads";
  }
  EXPECT_GT(first.size(), 100000u);
}

TEST_F(DisplacedMeshCases, AbortedUpdatesGiveNothing)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(filter);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3 ? 1 : 0);
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(this->Run(OneSquare())->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Recorder.Errors.empty());
}

TEST_F(DisplacedMeshCases, FollowsItsMapThroughThePipeline)
{
  vtkNew<vtkMesoPatternSource> source;
  source->SetPattern("noise");
  source->SetSize(16, 16);
  this->Filter->SetHeightMapConnection(source->GetOutputPort());
  const auto mesh = OneSquare();
  vtkNew<vtkStringArray> name;
  name->SetName("name");
  name->InsertNextValue("square");
  mesh->GetFieldData()->AddArray(name);
  vtkPolyData* diced = this->Run(mesh);
  EXPECT_EQ(diced->GetNumberOfPolys(), 2 * 16 * 16);
  EXPECT_NE(diced->GetFieldData()->GetAbstractArray("name"), nullptr);
  EXPECT_STREQ(diced->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_STREQ(diced->GetPointData()->GetTCoords()->GetName(), "TextureCoordinates");
  source->SetSize(8, 8);
  EXPECT_EQ(this->Run(mesh)->GetNumberOfPolys(), 2 * 8 * 8);
}

TEST_F(DisplacedMeshCases, CarriesTheArraysThatAreNamed)
{
  // A linear function of the position, in doubles and in integers, at corners, on edges and inside.
  const auto mesh = OneSquare();
  vtkNew<vtkDoubleArray> function;
  function->SetName("function");
  function->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> whole;
  whole->SetName("whole");
  for (const MesoVector& p : Square)
  {
    function->InsertNextTuple2(1. + 2. * p[0] - 3. * p[1], p[1]);
    whole->InsertNextValue(static_cast<int>(10. * p[0] + 20. * p[1]));
  }
  mesh->GetPointData()->AddArray(function);
  mesh->GetPointData()->AddArray(whole);
  this->Filter->AddCarriedArray("function");
  this->Filter->AddCarriedArray("whole");
  this->Filter->AddCarriedArray("Normals");
  vtkPolyData* diced = this->Run(mesh);
  ASSERT_EQ(diced->GetPointData()->GetNumberOfArrays(), 5);
  EXPECT_NE(TupleOf(diced, "Normals", 40), (MesoVector{ 0., 0., 1. }));
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    const MesoVector p = PositionOf(diced, i);
    EXPECT_NEAR(TupleOf(diced, "function", i)[0], 1. + 2. * p[0] - 3. * p[1], 1e-12);
    EXPECT_NEAR(TupleOf(diced, "function", i)[1], p[1], 1e-12);
    EXPECT_NEAR(TupleOf(diced, "whole", i)[0], 10. * p[0] + 20. * p[1], 1e-5);
  }
  this->ExpectRefused(OneSquare(), "no point array of numbers named function");
  this->Filter->ClearCarriedArrays();
  EXPECT_EQ(this->Run(mesh)->GetPointData()->GetNumberOfArrays(), 3);
}

TEST_F(DisplacedMeshCases, HasTheNormalsOfTheBaseWhereAsked)
{
  this->Filter->DetailNormalsOff();
  vtkPolyData* diced = this->Run(OneSquare());
  double deepest = 0.;
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(TupleOf(diced, "Normals", i), (MesoVector{ 0., 0., 1. }));
    deepest = std::min(deepest, PositionOf(diced, i)[2]);
  }
  EXPECT_LT(deepest, -0.05);
}

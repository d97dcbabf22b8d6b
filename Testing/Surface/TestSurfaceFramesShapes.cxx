// vtkMesoSurfaceFrames against the closed forms of the shapes: how its errors shrink with the mesh,
// and how frames follow changes of the model's scale and place and of the chart.

#include "SurfaceArrays.h"

#include "vtkMesoShapeSource.h"
#include "vtkMesoSurfaceFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace
{
using Coordinate = std::array<double, 2>;

vtkSmartPointer<vtkPolyData> Shape(const std::string& name, double finer)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape(name.c_str());
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  if (name == "plane")
  {
    source->SetParameter("segments", { 5. * finer, 3. * finer });
  }
  else
  {
    source->SetParameter("sides", { 24. * finer });
    source->SetParameter("rings", { 16. * finer });
  }
  source->Update();
  return source->GetOutput();
}

/// Frames of a shape's positions and texture coordinates alone, after they were changed.
vtkSmartPointer<vtkPolyData> FramesOf(
  vtkPolyData* shape, const std::function<void(MesoVector&, Coordinate&)>& change = nullptr)
{
  std::vector<MesoVector> positions;
  std::vector<Coordinate> coordinates;
  std::vector<std::vector<vtkIdType>> cells;
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    const MesoVector uv = TupleOf(shape, "TextureCoordinates", i);
    positions.push_back(PositionOf(shape, i));
    coordinates.push_back({ uv[0], uv[1] });
    if (change)
    {
      change(positions.back(), coordinates.back());
    }
  }
  for (const auto& triangle : TrianglesOf(shape))
  {
    cells.push_back({ triangle[0], triangle[1], triangle[2] });
  }
  vtkNew<vtkMesoSurfaceFrames> filter;
  filter->SetInputData(MakeMesh(positions, coordinates, cells));
  filter->Update();
  return filter->GetOutput();
}

MesoVector AlongU(vtkPolyData* mesh, vtkIdType i)
{
  return MesoScaled(TupleOf(mesh, "MesoTangent", i), TupleOf(mesh, "MesoTileScale", i)[0]);
}

MesoVector AlongV(vtkPolyData* mesh, vtkIdType i)
{
  return MesoScaled(TupleOf(mesh, "MesoBitangent", i), TupleOf(mesh, "MesoTileScale", i)[1]);
}

/// The largest distance between two meshes' vectors, relative to the largest of them.
double Difference(vtkPolyData* a, vtkPolyData* b,
  const std::function<MesoVector(vtkPolyData*, vtkIdType)>& vectorA,
  const std::function<MesoVector(vtkPolyData*, vtkIdType)>& vectorB)
{
  double distance = 0.;
  double length = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    distance = std::max(distance, DistanceOf(vectorA(a, i), vectorB(b, i)));
    length = std::max(length, MesoLength(vectorB(b, i)));
  }
  return distance / length;
}

/// Largest errors of normals, directions and relative scales, away from the chart's border, where
/// all triangles around a vertex count, and on it, where those of one side do.
struct Errors
{
  double Normal = 0.;
  double Inside[2] = { 0., 0. };
  double Border[2] = { 0., 0. };
};

Errors ErrorsOf(const std::string& name, double finer)
{
  const auto shape = Shape(name, finer);
  const auto frames = FramesOf(shape);
  Errors errors;
  EXPECT_EQ(frames->GetNumberOfPoints(), shape->GetNumberOfPoints());
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    const auto distance = [&](const char* array)
    { return DistanceOf(TupleOf(frames, array, i), TupleOf(shape, array, i)); };
    const MesoVector uv = TupleOf(shape, "TextureCoordinates", i);
    // Near a pole dp/du turns within a segment, however many there are.
    if (name == "sphere" && std::abs(uv[1] - 0.5) > 0.375)
    {
      continue;
    }
    const bool border = uv[0] == 0. || uv[0] == 1. || uv[1] == 0. || uv[1] == 1.;
    double* here = border ? errors.Border : errors.Inside;
    here[0] = std::max({ here[0], distance("MesoTangent"), distance("MesoBitangent") });
    for (int k = 0; k < 2; ++k)
    {
      const double exact = TupleOf(shape, "MesoTileScale", i)[k];
      here[1] = std::max(here[1], std::abs(TupleOf(frames, "MesoTileScale", i)[k] / exact - 1.));
    }
    errors.Normal = std::max(errors.Normal, distance("Normals"));
    EXPECT_EQ(TupleOf(frames, "MesoFrameValid", i)[0], 1.) << name << " point " << i;
  }
  return errors;
}

/// Whether halving the mesh's edges made the error at least this many times less, or it is only
/// rounding.
::testing::AssertionResult Shrinks(double coarse, double fine, double times)
{
  if (fine < 1e-12 || coarse > times * fine)
  {
    return ::testing::AssertionSuccess() << coarse << " to " << fine;
  }
  return ::testing::AssertionFailure() << coarse << " to " << fine;
}

class FramesOfShapes : public ::testing::TestWithParam<const char*>
{
};
}

TEST_P(FramesOfShapes, ConvergeToTheClosedForm)
{
  const Errors coarse = ErrorsOf(this->GetParam(), 1.);
  const Errors fine = ErrorsOf(this->GetParam(), 2.);
  EXPECT_TRUE(Shrinks(coarse.Normal, fine.Normal, 3.5));
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_TRUE(Shrinks(coarse.Inside[k], fine.Inside[k], 3.5));
    EXPECT_TRUE(Shrinks(coarse.Border[k], fine.Border[k], 3.5));
  }
}
INSTANTIATE_TEST_SUITE_P(
  All, FramesOfShapes, ::testing::Values("plane", "sphere", "cylinder", "torus"));

TEST(FramesOfPoles, AreThoseOfTheirMeridians)
{
  const auto shape = Shape("sphere", 1.);
  const auto frames = FramesOf(shape);
  for (vtkIdType i = 0; i < 24; ++i)
  {
    EXPECT_LT(DistanceOf(TupleOf(frames, "Normals", i), { 0., -1., 0. }), 1e-12);
    EXPECT_LT(
      DistanceOf(TupleOf(frames, "MesoTangent", i), TupleOf(shape, "MesoTangent", i)), 1e-9);
    EXPECT_LT(
      DistanceOf(TupleOf(frames, "MesoBitangent", i), TupleOf(shape, "MesoBitangent", i)), 1e-9);
    EXPECT_EQ(TupleOf(frames, "MesoFrameValid", i)[0], 1.);
  }
}

TEST_P(FramesOfShapes, ScaleWithTheModel)
{
  const auto shape = Shape(this->GetParam(), 1.);
  const auto frames = FramesOf(shape);
  for (double factor : { 1e-6, 1e+6 })
  {
    const auto scaled =
      FramesOf(shape, [&](MesoVector& p, Coordinate&) { p = MesoScaled(p, factor); });
    for (const char* array : { "Normals", "MesoTangent", "MesoBitangent", "MesoFrameValid" })
    {
      const auto get = [&](vtkPolyData* mesh, vtkIdType i) { return TupleOf(mesh, array, i); };
      EXPECT_LT(Difference(scaled, frames, get, get), 1e-12) << array << " at " << factor;
    }
    const auto get = [](vtkPolyData* mesh, vtkIdType i)
    { return TupleOf(mesh, "MesoTileScale", i); };
    const auto back = [&](vtkPolyData* mesh, vtkIdType i)
    { return MesoScaled(TupleOf(mesh, "MesoTileScale", i), 1. / factor); };
    EXPECT_LT(Difference(scaled, frames, back, get), 1e-12) << factor;
  }
}

TEST_P(FramesOfShapes, StayFarFromTheOrigin)
{
  const auto shape = Shape(this->GetParam(), 1.);
  const auto frames = FramesOf(shape);
  const auto moved = FramesOf(shape,
    [](MesoVector& p, Coordinate&) {
      p = MesoSum(p, { 1e+6, -1e+6, 1e+6 });
    });
  for (const char* array :
    { "Normals", "MesoTangent", "MesoBitangent", "MesoTileScale", "MesoFrameValid" })
  {
    const auto get = [&](vtkPolyData* mesh, vtkIdType i) { return TupleOf(mesh, array, i); };
    // Positions of 1e+6 are rounded to 1e-10, and the shortest edge is 0.04 long.
    EXPECT_LT(Difference(moved, frames, get, get), 1e-8) << array;
  }
}

// A linear change of the chart changes dp/du and dp/dv linearly, whatever the mesh.
TEST_P(FramesOfShapes, FollowLinearChangesOfTheChart)
{
  struct Change
  {
    const char* Name;
    double M[4]; ///< new u = M[0] u + M[1] v, new v = M[2] u + M[3] v
  };
  const auto shape = Shape(this->GetParam(), 1.);
  const auto frames = FramesOf(shape);
  for (const Change& change :
    { Change{ "mirrored", { -1., 0., 0., 1. } }, Change{ "sheared", { 1., 0.75, 0., 1. } },
      Change{ "much sheared", { 1., 30., 0., 1. } },
      Change{ "turned and mirrored", { 0., 1., 1., 0. } }, Change{ "1000:1", { 1., 0., 0., 1e-3 } },
      Change{ "1:1000", { 1e-3, 0., 0., 1. } }, Change{ "many tiles", { 1e4, 0., 0., 1e4 } } })
  {
    const double* m = change.M;
    const double determinant = m[0] * m[3] - m[1] * m[2];
    const auto changed = FramesOf(shape,
      [&](MesoVector&, Coordinate& t) {
        t = { m[0] * t[0] + m[1] * t[1], m[2] * t[0] + m[3] * t[1] };
      });
    const auto expectedU = [&](vtkPolyData* mesh, vtkIdType i)
    {
      return MesoSum(MesoScaled(AlongU(mesh, i), m[3] / determinant),
        MesoScaled(AlongV(mesh, i), -m[2] / determinant));
    };
    const auto expectedV = [&](vtkPolyData* mesh, vtkIdType i)
    {
      return MesoSum(MesoScaled(AlongU(mesh, i), -m[1] / determinant),
        MesoScaled(AlongV(mesh, i), m[0] / determinant));
    };
    EXPECT_LT(Difference(changed, frames, AlongU, expectedU), 1e-9) << change.Name;
    EXPECT_LT(Difference(changed, frames, AlongV, expectedV), 1e-9) << change.Name;
    for (vtkIdType i = 0; i < changed->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(TupleOf(changed, "MesoFrameValid", i)[0], 1.) << change.Name << " point " << i;
    }
  }
}

TEST_P(FramesOfShapes, HaveUnitAxesInTheTangentPlane)
{
  const auto frames =
    FramesOf(Shape(this->GetParam(), 1.), [](MesoVector&, Coordinate& t) { t[0] += 0.5 * t[1]; });
  for (vtkIdType i = 0; i < frames->GetNumberOfPoints(); ++i)
  {
    const MesoVector normal = TupleOf(frames, "Normals", i);
    for (const char* axis : { "MesoTangent", "MesoBitangent" })
    {
      ASSERT_NEAR(MesoLength(TupleOf(frames, axis, i)), 1., 1e-12);
      ASSERT_NEAR(MesoDot(TupleOf(frames, axis, i), normal), 0., 1e-12);
    }
  }
}

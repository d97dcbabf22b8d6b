// vtkMesoBaseImage: texels are the mesh's own points, axes close where the mesh does, what lies beside
// charts and what several charts share is told apart, and what cannot be baked is refused in one line.

#include "DicedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoBaseImage.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Baked
{
  vtkNew<vtkMesoBaseImage> Filter;
  vtkSmartPointer<vtkImageData> Image;

  Baked(vtkPolyData* mesh, int width, int height)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->SetSize(width, height);
    this->Filter->Update();
    this->Image = this->Filter->GetOutput();
  }

  std::array<double, 2> Field(const char* name) const
  {
    std::array<double, 2> values;
    this->Image->GetFieldData()->GetArray(name)->GetTuple(0, values.data());
    return values;
  }
  /// Texture coordinates of a texel's centre.
  std::array<double, 2> CoordinateOf(int x, int y) const
  {
    const auto scale = this->Field("MesoBaseScale");
    const auto offset = this->Field("MesoBaseOffset");
    return { (x - offset[0]) / scale[0], (y - offset[1]) / scale[1] };
  }
  std::array<double, 4> PositionAt(int x, int y) const
  {
    std::array<double, 4> value;
    double centre[3];
    this->Image->GetFieldData()->GetArray("MesoBaseCentre")->GetTuple(0, centre);
    this->Image->GetPointData()
      ->GetArray("MesoBasePosition")
      ->GetTuple(vtkIdType(y) * this->Image->GetDimensions()[0] + x, value.data());
    return { value[0] + centre[0], value[1] + centre[1], value[2] + centre[2], value[3] };
  }
  std::array<double, 4> NormalAt(int x, int y) const
  {
    std::array<double, 4> value;
    this->Image->GetPointData()
      ->GetArray("MesoBaseNormal")
      ->GetTuple(vtkIdType(y) * this->Image->GetDimensions()[0] + x, value.data());
    return value;
  }
};

vtkSmartPointer<vtkPolyData> Torus(int rings, int sides)
{
  return ShapeMesh("torus", { { "rings", { double(rings) } }, { "sides", { double(sides) } } });
}
}

TEST(BaseImage, OfATorusLiesOnItAndClosesBothWays)
{
  const int rings = 80;
  const int sides = 30;
  const auto torus = Torus(rings, sides);
  const Baked baked(torus, 160, 96);
  ASSERT_EQ(baked.Filter->GetErrorMessage(), "");
  EXPECT_EQ(baked.Field("MesoBaseWraps"), (std::array<double, 2>{ 1., 1. }));
  EXPECT_EQ(baked.Filter->GetNumberOfInsideTexels(), 160 * 96);
  EXPECT_EQ(baked.Filter->GetNumberOfAmbiguousTexels(), 0);
  const double around = 1.;
  const double tube = 0.4;
  // A facet lies this far from its arcs at most: below them, above where the torus is hollow.
  const double sagitta =
    tube * (1. - std::cos(Pi / sides)) + (around + tube) * (1. - std::cos(Pi / rings));
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 160; ++x)
    {
      const auto p = baked.PositionAt(x, y);
      const auto n = baked.NormalAt(x, y);
      ASSERT_EQ(p[3], 1.);
      const double fromAxis = std::hypot(p[0], p[2]);
      const double below = tube - std::hypot(fromAxis - around, p[1]);
      ASSERT_GT(below, -1.01 * sagitta) << x << " " << y;
      ASSERT_LT(below, 1.01 * sagitta) << x << " " << y;
      ASSERT_NEAR(std::hypot(std::hypot(n[0], n[1]), n[2]), 1., 1e-6);
      // The closed form's own place: u around the axis from -z, v around the tube from inside.
      const auto uv = baked.CoordinateOf(x, y);
      ASSERT_NEAR(
        std::remainder(std::atan2(p[0], p[2]) - 2. * Pi * (uv[0] + 0.5), 2. * Pi), 0., 0.01);
      ASSERT_NEAR(
        std::remainder(std::atan2(p[1], fromAxis - around) - 2. * Pi * (uv[1] + 0.5), 2. * Pi), 0.,
        0.02);
    }
  }
}

TEST(BaseImage, HasAMarginWhereAnAxisDoesNotClose)
{
  const auto plane = ShapeMesh("plane", { { "size", { 2., 3. } }, { "segments", { 4., 6. } } });
  const Baked baked(plane, 40, 40);
  EXPECT_EQ(baked.Field("MesoBaseWraps"), (std::array<double, 2>{ 0., 0. }));
  for (int y = 0; y < 40; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      const auto p = baked.PositionAt(x, y);
      const auto uv = baked.CoordinateOf(x, y);
      const bool inside = x >= 4 && x < 36 && y >= 4 && y < 36;
      ASSERT_EQ(p[3], inside ? 1. : 0.5) << x << " " << y;
      // The plane goes on beside itself.
      ASSERT_NEAR(p[0], 2. * (uv[0] - 0.5), 1e-6);
      ASSERT_NEAR(p[1], 3. * (uv[1] - 0.5), 1e-6);
    }
  }
  const Baked cylinder(ShapeMesh("cylinder", {}), 64, 40);
  EXPECT_EQ(cylinder.Field("MesoBaseWraps"), (std::array<double, 2>{ 1., 0. }));
}

TEST(BaseImage, DoesNotKnowWhatSeveralChartsShare)
{
  // A torus whose two halves are laid over each other.
  const auto torus = Torus(32, 16);
  vtkNew<vtkDoubleArray> folded;
  folded->SetName("TextureCoordinates");
  folded->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    double uv[2];
    torus->GetPointData()->GetTCoords()->GetTuple(i, uv);
    folded->InsertNextTuple2(std::min(uv[0], 1. - uv[0]), uv[1]);
  }
  torus->GetPointData()->SetTCoords(folded);
  const Baked baked(torus, 64, 64);
  EXPECT_GT(baked.Filter->GetNumberOfAmbiguousTexels(), 50 * 64);
  const auto p = baked.PositionAt(32, 32);
  EXPECT_EQ(p[3], 0.);
}

TEST(BaseImage, KeepsItsDigitsFarFromTheOrigin)
{
  auto torus = Torus(48, 24);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    double p[3];
    torus->GetPoint(i, p);
    points->InsertNextPoint(p[0] + 1e6, p[1] - 1e6, p[2] + 1e6);
  }
  const Baked near(torus, 64, 64);
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(torus);
  moved->SetPoints(points);
  const Baked far(moved, 64, 64);
  EXPECT_EQ(far.Field("MesoBaseWraps"), (std::array<double, 2>{ 1., 1. }));
  for (int k = 0; k < 64; ++k)
  {
    const auto p = near.PositionAt(k, k);
    const auto q = far.PositionAt(k, k);
    ASSERT_NEAR(q[0] - 1e6, p[0], 1e-6);
    ASSERT_NEAR(q[1] + 1e6, p[1], 1e-6);
  }
}

TEST(BaseImage, ChoosesASizeForTheMesh)
{
  vtkNew<vtkMesoBaseImage> image;
  image->SetSizeFor(Torus(80, 30), 1024);
  EXPECT_EQ(image->GetSize()[0], 80 * 8 + 8);
  EXPECT_EQ(image->GetSize()[1], 30 * 8 + 8);
  image->SetSizeFor(Torus(80, 30), 300);
  EXPECT_EQ(image->GetSize()[0], 300);
  image->SetSize(3, 1 << 20);
  EXPECT_EQ(image->GetSize()[0], 16);
  EXPECT_EQ(image->GetSize()[1], 8192);
}

TEST(BaseImage, RefusesWhatCannotBeBaked)
{
  const auto refusal = [](vtkPolyData* mesh)
  {
    vtkNew<vtkMesoBaseImage> filter;
    ErrorRecorder recorder;
    recorder.Watch(filter);
    filter->SetInputData(mesh);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(recorder.Errors.size(), 1u);
    return filter->GetErrorMessage();
  };
  const auto changed = [](const std::function<void(vtkPolyData*)>& change)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->DeepCopy(Torus(12, 8));
    change(mesh);
    return mesh;
  };
  EXPECT_EQ(refusal(changed([](vtkPolyData* mesh) { mesh->GetPointData()->SetNormals(nullptr); })),
    "the mesh has no point normals");
  EXPECT_EQ(refusal(changed([](vtkPolyData* mesh) { mesh->GetPointData()->SetTCoords(nullptr); })),
    "the mesh has no texture coordinates");
  EXPECT_EQ(refusal(changed(
              [](vtkPolyData* mesh)
              {
                for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
                {
                  mesh->GetPointData()->GetTCoords()->SetTuple2(i, 0.5, 0.5);
                }
              })),
    "the texture coordinates span no area");
  const std::string notFinite = refusal(changed([](vtkPolyData* mesh)
    { mesh->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 0., 0.); }));
  EXPECT_NE(notFinite.find("the position of point 5 is not finite"), std::string::npos)
    << notFinite;
  EXPECT_EQ(refusal(vtkNew<vtkPolyData>()), "the mesh has no point normals");
}

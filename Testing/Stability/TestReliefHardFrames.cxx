// Frames and matrices that strain the arithmetic: mirrored, sheared, stretched 1000 : 1 and collapsed
// charts; node matrices mirrored, sheared, non-uniform and singular; models a millionth and a million
// in size, and a million away from the origin.

#include "MesoAOVChecks.h"

#include "vtkMesoSurfaceFrames.h"

#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <functional>
#include <iterator>

namespace
{
class ReliefHardFrames : public MesoReliefAOVs
{
protected:
  void SetUp() override
  {
    this->Mapper->SetScale(0.05);
    this->Mapper->SetTiles(2., 2.);
  }

  /// A plane whose texture coordinates and points (in double) are changed, with frames made anew.
  static vtkSmartPointer<vtkPolyData> Plane(
    const std::function<std::array<double, 2>(double, double)>& coordinates,
    const std::function<std::array<double, 3>(const double*)>& place)
  {
    auto plane = MesoTestScene::Shape("plane", { { "segments", { 8., 8. } } });
    vtkNew<vtkPolyData> bare;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> tcoords;
    tcoords->SetName("TextureCoordinates");
    tcoords->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
    {
      double uv[2];
      plane->GetPointData()->GetTCoords()->GetTuple(i, uv);
      points->InsertNextPoint(place(plane->GetPoint(i)).data());
      tcoords->InsertNextTuple(coordinates(uv[0], uv[1]).data());
    }
    bare->SetPoints(points);
    bare->SetPolys(plane->GetPolys());
    bare->GetPointData()->SetTCoords(tcoords);
    vtkNew<vtkMesoSurfaceFrames> frames;
    frames->SetInputData(bare);
    frames->Update();
    return frames->GetOutput();
  }

  static std::array<double, 2> SameUV(double u, double v) { return { u, v }; }
  static std::array<double, 3> SamePlace(const double* p) { return { p[0], p[1], p[2] }; }
};
}

TEST_P(ReliefHardFrames, Charts)
{
  const std::function<std::array<double, 2>(double, double)> charts[] = {
    [](double u, double v) -> std::array<double, 2> {
      return { 1. - u, v };
    }, // mirrored
    [](double u, double v) -> std::array<double, 2> {
      return { u + 2. * v, v };
    }, // sheared
    [](double u, double v) -> std::array<double, 2> {
      return { 1000. * u, v };
    }, // stretched
    [](double u, double) -> std::array<double, 2> {
      return { u, 0. };
    }, // v collapsed
    [](double, double) -> std::array<double, 2> {
      return { 0.3, 0.7 };
    }, // both
    [](double u, double v) -> std::array<double, 2> {
      return { std::abs(u - 0.5), v };
    }, // folded
  };
  const MesoCurvedKind curved = this->GetParam().Curved;
  const bool hasImage = curved == MesoCurvedKind::Bent || curved == MesoCurvedKind::Surface;
  for (std::size_t i = 0; i < std::size(charts); ++i)
  {
    if (hasImage && (i == 3 || i == 4))
    {
      continue; // vtkMesoBaseImage refuses a chart that has no area
    }
    this->Use(Plane(charts[i], SamePlace));
    EXPECT_GT(this->Check(), 3000);
  }
}

TEST_P(ReliefHardFrames, MirroredChartShowsTheMirroredRelief)
{
  // The same relief lies on the plane when chart and map are both mirrored.
  this->Mapper->SetHeightMap(MesoTestScene::Pattern("step"));
  this->Mapper->SetTiles(1., 1.);
  this->Use(Plane(SameUV, SamePlace));
  this->Check();
  const auto depth = this->Pass->GetChannel("depth");
  const auto normal = this->Pass->GetChannel("normal.x");
  auto map = MesoTestScene::Pattern("step");
  auto* value = static_cast<float*>(map->GetScalarPointer());
  for (int row = 0; row < 64; ++row)
  {
    std::reverse(value + 64 * row, value + 64 * (row + 1));
  }
  this->Mapper->SetHeightMap(map);
  this->Use(Plane(
    [](double u, double v) -> std::array<double, 2> {
      return { 1. - u, v };
    },
    SamePlace));
  this->Check();
  const auto mirroredDepth = this->Pass->GetChannel("depth");
  const auto mirroredNormal = this->Pass->GetChannel("normal.x");
  int different = 0;
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    different +=
      std::abs(depth[i] - mirroredDepth[i]) > 1e-4 || std::abs(normal[i] - mirroredNormal[i]) > 1e-2
      ? 1
      : 0;
  }
  EXPECT_LT(different, 96 * 96 / 500);
}

TEST_P(ReliefHardFrames, Matrices)
{
  this->Use(MesoTestScene::Shape("torus"));
  this->Scene.LookFrom(0., 2., 5.);
  const double matrices[][16] = {
    { -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },    // mirrored
    { 1, 0.7, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },   // sheared
    { 1, 0, 0, 0, 0, 0.2, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, 1 }, // non-uniform
    { 1, 0, 0, 0, 0, 1e-6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },  // all but flat
  };
  for (const auto& elements : matrices)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(elements);
    this->Scene.Actor->SetUserMatrix(matrix);
    EXPECT_GT(this->Check(), 0);
  }
}

TEST_P(ReliefHardFrames, MatricesThatFlattenDrawNoNonsense)
{
  this->Use(MesoTestScene::Shape("torus"));
  this->Scene.LookFrom(0.4, 2., 5.);
  for (const int axis : { 0, 1, 2 })
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(axis, axis, 0.);
    this->Scene.Actor->SetUserMatrix(matrix);
    this->Check(); // whatever is drawn is sound
  }
}

TEST_P(ReliefHardFrames, SizeAndPlaceOfTheModelDoNotMatter)
{
  this->Use(Plane(SameUV, SamePlace));
  this->Check();
  const auto relief = this->Pass->GetChannel("relief");
  for (const double size : { 1e-7, 1e-6, 1e-3, 1e3, 1e6, 1e7 })
  {
    this->Use(Plane(SameUV,
      [&](const double* p) -> std::array<double, 3> {
        return { size * p[0], size * p[1], size * p[2] };
      }));
    this->Mapper->SetScale(0.05 * size);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.4 * size, -0.8 * size, 1.6 * size);
    camera->SetFocalPoint(0., 0., 0.);
    this->Scene.Renderer->ResetCameraClippingRange();
    EXPECT_GT(this->Check(), 3000) << size;
    const auto scaled = this->Pass->GetChannel("relief");
    int different = 0;
    for (std::size_t i = 0; i < relief.size(); ++i)
    {
      different += std::abs(relief[i] - scaled[i]) > 1e-3 ? 1 : 0;
    }
    EXPECT_LT(different, 96 * 96 / 200) << size;
  }
}

TEST_P(ReliefHardFrames, FarFromTheOrigin)
{
  this->Use(Plane(SameUV, SamePlace));
  this->Check();
  const auto relief = this->Pass->GetChannel("relief");
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  for (const double far : { 1e6, 1e7 })
  {
    this->Use(Plane(SameUV,
      [far](const double* p) -> std::array<double, 3> {
        return { p[0] + far, p[1] - far, p[2] + far };
      }));
    camera->SetPosition(far + 0.4, -far - 0.8, far + 1.6);
    camera->SetFocalPoint(far, -far, far);
    this->Scene.Renderer->ResetCameraClippingRange();
    EXPECT_GT(this->Check(), 3000) << far;
    const auto moved = this->Pass->GetChannel("relief");
    int different = 0;
    for (std::size_t i = 0; i < relief.size(); ++i)
    {
      different += std::abs(relief[i] - moved[i]) > 1e-2 ? 1 : 0;
    }
    EXPECT_LT(different, 96 * 96 / 50) << far;
  }
}

MESO_FOR_RELIEF_ARMS(ReliefHardFrames);

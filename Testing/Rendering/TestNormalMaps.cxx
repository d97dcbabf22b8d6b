// Normal maps: in tangent space on any chart, made of heights, in object space, for relief; which way green
// points; what 8 and 16 bits cost; and real geometry beside its normal-mapped twin.

#include "MesoBaseline.h"
#include "MesoChartPlane.h"

#include "vtkMesoBumpMapper.h"
#include "vtkMesoNormalMap.h"
#include "vtkMesoObjectNormalMap.h"
#include "vtkMesoReliefMapper.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyDataTangents.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using Vector = std::array<double, 3>;

const double Pi = std::acos(-1.);
constexpr int Size = 128;

Vector Unit(const Vector& v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  return { v[0] / length, v[1] / length, v[2] / length };
}

double Hill(double u, double v)
{
  return 0.5 + 0.3 * std::cos(2. * Pi * u) + 0.2 * std::cos(4. * Pi * v);
}

double HillU(double u)
{
  return -0.6 * Pi * std::sin(2. * Pi * u);
}

double HillV(double v)
{
  return -0.8 * Pi * std::sin(4. * Pi * v);
}

/// Directions that turn over the map, up to 40 degrees off the normal.
Vector Turning(double u, double v)
{
  return Unit({ 0.6 * std::sin(2. * Pi * u), 0.5 * std::cos(2. * Pi * v), 1. });
}

/// A direction in tangent space as one of the plane of a chart: its parts along the unit directions of
/// dp/du and dp/dv, and along n, are the stored ones.
Vector OnChart(const MesoChart& chart, const Vector& stored)
{
  const double lengthU = std::hypot(chart.A, chart.C);
  const double lengthV = std::hypot(chart.B, chart.D);
  const double tx = chart.A / lengthU;
  const double ty = chart.C / lengthU;
  const double bx = chart.B / lengthV;
  const double by = chart.D / lengthV;
  const double area = tx * by - ty * bx;
  return Unit({ (stored[0] * by - stored[1] * ty) / area, (stored[1] * tx - stored[0] * bx) / area,
    stored[2] });
}

MesoMesostructureOptions Options(MesoTechnique technique)
{
  MesoMesostructureOptions options;
  options.Technique = technique;
  return options;
}

/// The image with each number as an integer of 8 or 16 bits.
template <typename Integer>
vtkSmartPointer<vtkImageData> Quantised(vtkImageData* directions, int type, double white)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(directions->GetDimensions());
  image->AllocateScalars(type, 3);
  const auto* from = static_cast<const float*>(directions->GetScalarPointer());
  auto* to = static_cast<Integer*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < 3 * directions->GetNumberOfPoints(); ++i)
  {
    to[i] = static_cast<Integer>(std::lround((0.5 * double(from[i]) + 0.5) * white));
  }
  return image;
}

class NormalMapOnChart : public testing::TestWithParam<MesoChart>
{
protected:
  MesoChartPlane Plane;
  vtkNew<vtkMesoBumpMapper> Mapper;

  /// The largest angle between what is drawn and what a function of map coordinates expects.
  double Worst(const std::function<Vector(double, double)>& expected)
  {
    this->Plane.Actor->SetMapper(this->Mapper);
    this->Plane.Capture();
    double worst = 0.;
    const int covered = this->Plane.ForEachPixel(
      [&](int column, int row)
      {
        const double u = this->Plane.Pass->GetValue("texcoord.u", column, row);
        const double v = this->Plane.Pass->GetValue("texcoord.v", column, row);
        worst =
          std::max(worst, MesoDegreesBetween(this->Plane.NormalAt(column, row), expected(u, v)));
      });
    EXPECT_GT(covered, 1500);
    return worst;
  }
};
}

TEST_P(NormalMapOnChart, IsRelativeToItsTangents)
{
  const MesoChart chart = GetParam();
  this->Mapper->SetInputData(MesoChartMesh(chart));
  this->Mapper->SetOptions(Options(MesoTechnique::Normal));
  const auto map = MesoImageOf(Size, Size, 3, Turning);
  const auto expected = [&](double u, double v) { return OnChart(chart, Turning(u, v)); };
  this->Mapper->SetNormalMap(map);
  EXPECT_LT(this->Worst(expected), 0.05); // chords of 1/128 of a turn
  // The same with green the other way.
  MesoNormalMapMeaning down;
  down.Down = true;
  this->Mapper->SetNormalMap(map, down);
  EXPECT_GT(this->Worst(expected), 30.);
  this->Mapper->SetNormalMap(MesoImageOf(Size, Size, 3,
                               [](double u, double v)
                               {
                                 const Vector normal = Turning(u, v);
                                 return Vector{ normal[0], -normal[1], normal[2] };
                               }),
    down);
  EXPECT_LT(this->Worst(expected), 0.05);
}

TEST_P(NormalMapOnChart, MadeOfHeightsIsTheirNormal)
{
  const MesoChart chart = GetParam();
  constexpr double depth = 0.1;
  const auto expected = [&](double u, double v)
  { return chart.Normal(2. * HillU(u), 2. * HillV(v), depth); };
  this->Mapper->SetInputData(MesoChartMesh(chart, 4));
  const auto heights = MesoHeightsOf(Size, Size, Hill);
  MesoMesostructureOptions options = Options(MesoTechnique::Normal);
  options.Scale = depth;
  options.Tiles = { 2., 2. };
  this->Mapper->SetOptions(options);
  // Over a flat map of another depth than this one.
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(heights);
  filter->SetScale(0.25);
  filter->Update();
  MesoNormalMapMeaning meaning;
  meaning.Space = MesoNormalSpace::Relief;
  meaning.Depth = 0.25;
  this->Mapper->SetNormalMap(filter->GetOutput(), meaning);
  EXPECT_LT(this->Worst(expected), 0.15);

  // And in object space, where the map knows the chart.
  vtkNew<vtkMesoObjectNormalMap> ofObject;
  ofObject->SetInputData(0, heights);
  ofObject->SetInputData(1, this->Mapper->GetInput());
  ofObject->SetSize(2 * Size, 2 * Size);
  ofObject->SetScale(depth);
  ofObject->SetTiles(2., 2.);
  ofObject->Update();
  EXPECT_EQ(ofObject->GetNumberOfOverlaps(), 0);
  options.Technique = MesoTechnique::NormalObject;
  this->Mapper->SetOptions(options);
  meaning.Space = MesoNormalSpace::Object;
  this->Mapper->SetNormalMap(ofObject->GetOutput(), meaning);
  EXPECT_LT(this->Worst(expected), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Charts, NormalMapOnChart, testing::ValuesIn(MesoCharts),
  [](const testing::TestParamInfo<MesoChart>& info) { return std::string(info.param.Name); });

TEST(NormalMaps, InObjectSpaceFollowTheNodesMatrix)
{
  MesoChartPlane plane;
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(MesoChartMesh(MesoCharts[0]));
  mapper->SetOptions(Options(MesoTechnique::NormalObject));
  MesoNormalMapMeaning meaning;
  meaning.Space = MesoNormalSpace::Object;
  mapper->SetNormalMap(MesoImageOf(Size, Size, 3, Turning), meaning);
  plane.Actor->SetMapper(mapper);
  vtkNew<vtkTransform> transform;
  transform->RotateZ(30.);
  transform->Scale(1.5, 1., 0.5);
  plane.Actor->SetUserMatrix(transform->GetMatrix());
  plane.Capture();
  double worst = 0.;
  plane.ForEachPixel(
    [&](int column, int row)
    {
      const Vector n = Turning(plane.Pass->GetValue("texcoord.u", column, row),
        plane.Pass->GetValue("texcoord.v", column, row));
      const Vector scaled = { n[0] / 1.5, n[1], n[2] / 0.5 };
      const double c = std::cos(Pi / 6.);
      const double s = std::sin(Pi / 6.);
      worst = std::max(worst,
        MesoDegreesBetween(plane.NormalAt(column, row),
          Unit({ c * scaled[0] - s * scaled[1], s * scaled[0] + c * scaled[1], scaled[2] })));
    });
  EXPECT_LT(worst, 0.05);
}

TEST(NormalMaps, CostWhatTheirBitsCost)
{
  MesoChartPlane plane;
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(MesoChartMesh(MesoCharts[0]));
  mapper->SetOptions(Options(MesoTechnique::Normal));
  plane.Actor->SetMapper(mapper);
  const auto map = MesoImageOf(Size, Size, 3, Turning);
  const auto worstOf = [&](vtkImageData* image)
  {
    mapper->SetNormalMap(image);
    plane.Capture();
    double worst = 0.;
    plane.ForEachPixel(
      [&](int column, int row)
      {
        worst = std::max(worst,
          MesoDegreesBetween(plane.NormalAt(column, row),
            Turning(plane.Pass->GetValue("texcoord.u", column, row),
              plane.Pass->GetValue("texcoord.v", column, row))));
      });
    return worst;
  };
  const double exact = worstOf(map);
  const double of16 = worstOf(Quantised<unsigned short>(map, VTK_UNSIGNED_SHORT, 65535.));
  const double of8 = worstOf(Quantised<unsigned char>(map, VTK_UNSIGNED_CHAR, 255.));
  std::cout << "degrees: float " << exact << ", 16 bit " << of16 << ", 8 bit " << of8 << "\n";
  // Half a step of 2/255 in each of three numbers: sqrt(3) / 255 radians; and once more where the sampler
  // itself rounds what it filters, as llvmpipe's does.
  EXPECT_LT(of8, exact + 2. * 0.39);
  EXPECT_GT(of8, exact + 0.05);
  EXPECT_LT(of16, exact + 0.0016);
}

TEST(NormalMaps, AreReadWhereReliefIsHit)
{
  MesoTestScene scene(96, 96);
  vtkNew<vtkMesoAOVPass> pass;
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(MesoTestScene::Shape("plane"));
  mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  mapper->SetScale(0.1);
  mapper->SetNormalMap(MesoImageOf(Size, Size, 3, Turning));
  scene.Actor->SetMapper(mapper);
  scene.AddHeadlight();
  scene.LookFrom(0.8, -0.9, 1.2);
  scene.Renderer->SetPass(pass);
  scene.Window->Render();
  scene.Renderer->SetPass(nullptr);
  double worst = 0.;
  double moved = 0.;
  int covered = 0;
  for (int row = 0; row < 96; ++row)
  {
    for (int column = 0; column < 96; ++column)
    {
      const auto value = [&](const char* channel) { return pass->GetValue(channel, column, row); };
      if (value("coverage") > 0.f)
      {
        ++covered;
        moved = std::max<double>(moved, value("relief"));
        worst = std::max(worst,
          MesoDegreesBetween({ value("normal.x"), value("normal.y"), value("normal.z") },
            Turning(value("texcoord.u"), value("texcoord.v"))));
      }
    }
  }
  pass->ReleaseGraphicsResources(scene.Window);
  EXPECT_GT(covered, 1500);
  EXPECT_GT(moved, 0.5);
  EXPECT_LT(worst, 0.05);
}

TEST(NormalMaps, FlatOrAbsentAreTheBaseMesh)
{
  MesoTestScene scene;
  const auto torus = MesoTestScene::Shape("torus");
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(torus);
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(torus);
  scene.AddDirectionalLight(-1., -2., -1.);
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.LookFrom(1., 3., 5.);
  scene.Actor->SetMapper(plain);
  const auto expected = MesoGrabWindow(scene.Window);
  scene.Actor->SetMapper(mapper);
  const auto flat = MesoImageOf(4, 4, 3, [](double, double) { return Vector{ 0., 0., 1. }; });
  const auto nothing = MesoImageOf(4, 4, 3, [](double, double) { return Vector{ 0., 0., 0. }; });
  const auto tilted = MesoImageOf(4, 4, 3, [](double, double) { return Vector{ 0.6, 0., 0.8 }; });
  MesoNormalMapMeaning relief;
  relief.Space = MesoNormalSpace::Relief;
  relief.Depth = 0.1;
  const auto differs =
    [&](MesoTechnique technique, vtkImageData* map, const MesoNormalMapMeaning& meaning = {})
  {
    MesoMesostructureOptions options = Options(technique);
    options.Scale = 0.1;
    mapper->SetOptions(options);
    mapper->SetNormalMap(map, meaning);
    return !MesoCompareImages(MesoGrabWindow(scene.Window), expected, MesoImageLimits::Exact())
              .Within;
  };
  EXPECT_TRUE(differs(MesoTechnique::Normal, tilted));
  EXPECT_FALSE(differs(MesoTechnique::Normal, flat));
  EXPECT_FALSE(differs(MesoTechnique::Normal, flat, relief));
  EXPECT_FALSE(differs(MesoTechnique::Normal, nothing));
  EXPECT_FALSE(differs(MesoTechnique::Normal, nullptr));
  EXPECT_FALSE(differs(MesoTechnique::NormalObject, nullptr));
}

namespace
{
/// The hill as real geometry over a chart, with its own normals.
vtkSmartPointer<vtkPolyData> HillMesh(const MesoChart& chart, double depth)
{
  const auto mesh = MesoChartMesh(chart, 128);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double place[2];
    double point[3];
    mesh->GetPointData()->GetTCoords()->GetTuple(i, place);
    mesh->GetPoint(i, point);
    point[2] = depth * (Hill(place[0], place[1]) - 1.);
    mesh->GetPoints()->SetPoint(i, point);
    mesh->GetPointData()->GetNormals()->SetTuple(
      i, chart.Normal(HillU(place[0]), HillV(place[1]), depth).data());
  }
  return mesh;
}

/// Mean difference of two pictures' red channels, of 255.
double MeanDifference(vtkImageData* a, vtkImageData* b)
{
  const auto* p = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* q = static_cast<const unsigned char*>(b->GetScalarPointer());
  const int components = a->GetNumberOfScalarComponents();
  double sum = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    sum += std::abs(int(p[i * components]) - int(q[i * components]));
  }
  return sum / static_cast<double>(a->GetNumberOfPoints());
}
}

// The cells of the Khronos group's NormalTangentTest and NormalTangentMirrorTest, made anew: geometry and
// its normal-mapped twin on charts that are turned and mirrored.
TEST(NormalMaps, LookLikeTheGeometryTheyStandFor)
{
  constexpr double depth = 0.15;
  const MesoChart cells[] = { { "straight", 1., 0., 0., 1. }, { "turned", 0., -1., 1., 0. },
    { "mirrored in u", -1., 0., 0., 1. }, { "mirrored in v", 1., 0., 0., -1. },
    { "turned and mirrored", 0., 1., 1., 0. } };
  const auto directions = MesoImageOf(256, 256, 3,
    [](double u, double v) {
      return Unit({ -depth * HillU(u), -depth * HillV(v), 1. });
    });
  for (const MesoChart& chart : cells)
  {
    MesoChartPlane plane;
    plane.AddDirectionalLight(-0.4, 0.8, -0.8);
    const bool mirrored = chart.Determinant() < 0.;

    vtkNew<vtkMesoPolyDataMapper> geometry;
    geometry->SetInputData(HillMesh(chart, depth));
    vtkNew<vtkMesoBumpMapper> twin;
    twin->SetInputData(MesoChartMesh(chart));
    twin->SetOptions(Options(MesoTechnique::Normal));
    twin->SetNormalMap(directions);
    plane.Actor->SetMapper(geometry);
    plane.Capture();
    std::vector<Vector> normals;
    plane.ForEachPixel(
      [&](int column, int row) { normals.push_back(plane.NormalAt(column, row)); });
    const auto seen = MesoGrabWindow(plane.Window);
    plane.Actor->SetMapper(twin);
    plane.Capture();
    double worst = 0.;
    std::size_t pixel = 0;
    plane.ForEachPixel(
      [&](int column, int row)
      {
        ASSERT_LT(pixel, normals.size());
        worst = std::max(worst, MesoDegreesBetween(plane.NormalAt(column, row), normals[pixel++]));
      });
    EXPECT_EQ(pixel, normals.size()) << chart.Name;
    EXPECT_GT(pixel, 3000u) << chart.Name;
    EXPECT_LT(worst, 0.2) << chart.Name;
    const double ours = MeanDifference(MesoGrabWindow(plane.Window), seen);
    EXPECT_LT(ours, 0.5) << chart.Name;

    // VTK's own: its second tangent is n x t, whatever the chart.
    vtkNew<vtkPolyDataTangents> tangents;
    tangents->SetInputData(MesoChartMesh(chart));
    tangents->Update();
    vtkNew<vtkTexture> texture;
    texture->SetInputData(Quantised<unsigned char>(directions, VTK_UNSIGNED_CHAR, 255.));
    texture->SetColorModeToDirectScalars();
    texture->InterpolateOn();
    vtkNew<vtkPolyDataMapper> theirs;
    theirs->SetInputData(HillMesh(chart, depth));
    plane.Actor->SetMapper(theirs);
    plane.Actor->GetProperty()->SetInterpolationToPBR();
    plane.Actor->GetProperty()->SetRoughness(1.);
    const auto theirGeometry = MesoGrabWindow(plane.Window);
    theirs->SetInputData(tangents->GetOutput());
    plane.Actor->GetProperty()->SetNormalTexture(texture);
    const double others = MeanDifference(MesoGrabWindow(plane.Window), theirGeometry);
    std::cout << chart.Name << ": worst " << worst << " degrees, mean difference of 255: ours "
              << ours << ", VTK's " << others << "\n";
    if (mirrored)
    {
      EXPECT_GT(others, 10.) << chart.Name << ": VTK has learnt it";
    }
    else
    {
      EXPECT_LT(others, 1.) << chart.Name;
    }
  }
}

// A mesh that is bent with its frames refitted carries normals of tangent space along; those of object space
// stay as they were, off by as much as the mesh has turned.
TEST(NormalMaps, InObjectSpaceStayBehindWhereAMeshBends)
{
  constexpr double radius = 0.8;
  constexpr double depth = 0.05;
  const auto flat = MesoChartMesh(MesoCharts[0], 32);
  vtkNew<vtkPolyData> bent;
  bent->DeepCopy(flat);
  for (vtkIdType i = 0; i < bent->GetNumberOfPoints(); ++i)
  {
    double p[3];
    flat->GetPoint(i, p);
    const double turn = p[0] / radius;
    bent->GetPoints()->SetPoint(i, radius * std::sin(turn), p[1], radius * (std::cos(turn) - 1.));
    bent->GetPointData()->GetNormals()->SetTuple3(i, std::sin(turn), 0., std::cos(turn));
  }
  vtkNew<vtkMesoSurfaceFrames> refitted;
  refitted->SetInputData(bent);
  refitted->Update();

  const auto heights = MesoHeightsOf(Size, Size, Hill);
  vtkNew<vtkMesoNormalMap> ofTangents;
  ofTangents->SetInputData(heights);
  ofTangents->SetScale(depth);
  ofTangents->Update();
  vtkNew<vtkMesoObjectNormalMap> ofObject;
  ofObject->SetInputData(0, heights);
  ofObject->SetInputData(1, flat);
  ofObject->SetSize(Size, Size);
  ofObject->SetScale(depth);
  ofObject->Update();

  MesoChartPlane plane;
  vtkNew<vtkMesoBumpMapper> mapper;
  plane.Actor->SetMapper(mapper);
  mapper->SetInputData(refitted->GetOutput());
  // The mean angle, near the line along which the mesh has turned by so much, to the bent hill's normal.
  const auto offWhereTurned = [&](double turn)
  {
    plane.Capture();
    double sum = 0.;
    int count = 0;
    plane.ForEachPixel(
      [&](int column, int row)
      {
        const double u = plane.Pass->GetValue("texcoord.u", column, row);
        const double v = plane.Pass->GetValue("texcoord.v", column, row);
        const double here = (u - 0.5) / radius;
        if (std::abs(here - turn) < 0.05)
        {
          const Vector n = MesoCharts[0].Normal(HillU(u), HillV(v), depth);
          const Vector expected = { std::cos(here) * n[0] + std::sin(here) * n[2], n[1],
            std::cos(here) * n[2] - std::sin(here) * n[0] };
          sum += MesoDegreesBetween(plane.NormalAt(column, row), expected);
          ++count;
        }
      });
    EXPECT_GT(count, 50);
    return sum / count;
  };
  MesoNormalMapMeaning meaning;
  mapper->SetOptions(Options(MesoTechnique::Normal));
  mapper->SetNormalMap(ofTangents->GetOutput(), meaning);
  EXPECT_LT(offWhereTurned(0.), 1.5);
  EXPECT_LT(offWhereTurned(0.4), 1.5);
  meaning.Space = MesoNormalSpace::Object;
  mapper->SetOptions(Options(MesoTechnique::NormalObject));
  mapper->SetNormalMap(ofObject->GetOutput(), meaning);
  EXPECT_LT(offWhereTurned(0.), 3.); // within .05 of a turn there
  EXPECT_NEAR(offWhereTurned(0.4), 0.4 * 180. / Pi, 2.);
}

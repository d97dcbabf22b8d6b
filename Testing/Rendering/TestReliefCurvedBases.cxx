// The curved bases of relief-quadric and relief-quadric-exact: no relief is the plain picture, a sphere's
// outline is that of the sphere inside it, and what breaks every model stays finite.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"

#include "MesoKernels.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A technique and what it takes the base for.
struct Arm
{
  MesoTechnique Technique;
  MesoCurvedKind Curved;
};

void PrintTo(const Arm& arm, std::ostream* stream)
{
  *stream << MesoName(arm.Technique) << " " << MesoName(arm.Curved);
}

const Arm Arms[] = {
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Osculating },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Bent },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface },
  { MesoTechnique::ReliefQuadricExact, MesoCurvedKind::Quadric },
};

class ReliefCurvedBases : public testing::TestWithParam<Arm>
{
protected:
  static constexpr int Size = 100;
  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoReliefMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  void SetUp() override
  {
    MesoMesostructureOptions options;
    options.Technique = this->GetParam().Technique;
    options.Curved = this->GetParam().Curved;
    options.Quality = MesoQuality::Medium;
    options.Scale = 0.1;
    this->Mapper->SetOptions(options);
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -0.5, -0.7);
    this->Scene.AddHeadlight();
  }
  ~ReliefCurvedBases() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void Use(vtkPolyData* mesh)
  {
    const auto prepared = MesoTestScene::Prepared(mesh, this->GetParam().Technique);
    this->Mapper->SetInputData(prepared);
    this->Mapper->SetBaseImage(MesoTestScene::BaseImage(prepared));
  }
  int Capture()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }
};

vtkSmartPointer<vtkPolyData> Sphere(int rings, int sides)
{
  return MesoTestScene::Shape(
    "sphere", { { "rings", { double(rings) } }, { "sides", { double(sides) } } });
}

/// Where the outline of a round base of radius 1 lies in relief-quadric-exact, with the surface at
/// distance d: the rays that get just so deep across themselves. From the kernel's own distances.
double OutlineAcross(double d)
{
  const MesoKernels::Double::QuadricExact kernel;
  const glm::dvec3 quadric(0.5 / d, 0.5 / d, 0.); // in units of d
  const auto deepest = [&](double sine)
  {
    const glm::dvec3 view(sine, 0., std::sqrt(1. - sine * sine));
    const glm::dvec3 across = kernel.acrossView({ 0., 0., -1. }, view);
    const double end = view.z / (0.5 * sine * sine); // back at the quadric, in units of 1
    double most = 0.;
    for (int i = 1; i < 1000; ++i)
    {
      // Texture space here has the unit d.
      const double s =
        kernel.distanceAcross(quadric * d * d, across, glm::dvec3(view) * (end * i / 1000. / d));
      most = std::max(most, s);
    }
    return most;
  };
  double low = 0.5;
  double high = 1.;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (deepest(middle) > 1. ? low : high) = middle;
  }
  return low;
}
}

TEST_P(ReliefCurvedBases, NoReliefIsThePlainPicture)
{
  const auto torus = MesoTestScene::Shape("torus");
  this->Scene.LookFrom(1., 3., 5.);
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(torus);
  this->Scene.Actor->SetMapper(plain);
  const auto wanted = MesoGrabWindow(this->Scene.Window);
  this->Scene.Actor->SetMapper(this->Mapper);
  this->Use(torus);
  this->Mapper->SetHeightMap(MesoTestScene::Constant(1.f));
  const auto flat =
    MesoCompareImages(MesoGrabWindow(this->Scene.Window), wanted, MesoImageLimits::Exact());
  EXPECT_TRUE(flat.Within) << flat.Describe();
  this->Mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), wanted, {}).Within);
  this->Mapper->SetScale(0.);
  const auto shallow =
    MesoCompareImages(MesoGrabWindow(this->Scene.Window), wanted, MesoImageLimits::Exact());
  EXPECT_TRUE(shallow.Within) << shallow.Describe();
}

TEST_P(ReliefCurvedBases, OutlineOfASphere)
{
  constexpr double halfHeight = 1.1;
  constexpr double pixel = 2. * halfHeight / Size;
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(halfHeight);
  camera->SetPosition(0., 0., 5.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 1., 0.);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Use(Sphere(48, 96));
  this->Mapper->SetHeightMap(MesoTestScene::Constant(0.5f));
  for (const double depth : { 0.05, 0.2 })
  {
    this->Mapper->SetScale(2. * depth);
    const double radius = std::sqrt(this->Capture() * pixel * pixel / Pi);
    const bool exact = this->GetParam().Technique == MesoTechnique::ReliefQuadricExact;
    const bool bent = this->GetParam().Curved == MesoCurvedKind::Bent;
    // The bent ray is a chain of 64 tangents, which leaves the sphere a little too wide.
    EXPECT_NEAR(radius, exact ? OutlineAcross(depth) : 1. - depth, (bent ? 0.6 : 0.3) * pixel)
      << depth;
  }
}

TEST_P(ReliefCurvedBases, WhatBreaksEveryModelStaysFinite)
{
  this->Mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  struct Case
  {
    vtkSmartPointer<vtkPolyData> Mesh;
    double Scale;
  };
  const Case cases[] = {
    { Sphere(6, 8), 0.2 },                     // frames that turn by 60 degrees in a triangle
    { Sphere(24, 48), 1.5 },                   // D beyond the centre
    { MesoTestScene::Shape("torus"), 0.6 },    // and beyond the tube's
    { MesoTestScene::Shape("torus"), 1e-7 },   // all but flat
    { MesoTestScene::Shape("cylinder"), 0.3 }, // open
    { MesoTestScene::Shape("plane"), 0.3 },    // nothing turns
  };
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Quality = MesoQuality::Draft;
  this->Mapper->SetOptions(options);
  for (const Case& c : cases)
  {
    this->Use(c.Mesh);
    this->Mapper->SetScale(c.Scale);
    for (const double height : { 0.05, 3. }) // saddle directions and grazing views among them
    {
      this->Scene.LookFrom(0.3, height, 2.6);
      this->Capture();
    }
  }
}

TEST_P(ReliefCurvedBases, TakeNormalsInObjectSpace)
{
  this->Use(MesoTestScene::Shape("torus"));
  this->Mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  vtkNew<vtkImageData> map; // one normal everywhere
  map->SetDimensions(2, 2, 1);
  map->AllocateScalars(VTK_FLOAT, 3);
  for (int i = 0; i < 4; ++i)
  {
    map->GetPointData()->GetScalars()->SetTuple3(i, 0., 0.6, 0.8);
  }
  MesoNormalMapMeaning meaning;
  meaning.Space = MesoNormalSpace::Object;
  this->Mapper->SetNormalMap(map, meaning);
  this->Scene.LookFrom(0., 0., 5.); // the object's axes are the view's
  EXPECT_GT(this->Capture(), 1000);
  float worst = 0.f;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      if (this->Pass->GetValue("coverage", column, row) > 0.f)
      {
        worst = std::max(worst, std::abs(this->Pass->GetValue("normal.z", column, row) - 0.8f));
      }
    }
  }
  EXPECT_LT(worst, 1e-3f);
}

INSTANTIATE_TEST_SUITE_P(Arms, ReliefCurvedBases, testing::ValuesIn(Arms),
  [](const testing::TestParamInfo<Arm>& info)
  {
    return std::string(info.param.Technique == MesoTechnique::ReliefQuadricExact
        ? "Exact"
        : MesoName(info.param.Curved));
  });

TEST(ReliefBaseImage, IsAskedFor)
{
  MesoTestScene scene;
  vtkNew<vtkMesoReliefMapper> mapper;
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::ReliefQuadric;
  options.Curved = MesoCurvedKind::Surface;
  options.Scale = 0.1;
  mapper->SetOptions(options);
  mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  mapper->SetInputData(
    MesoTestScene::Prepared(MesoTestScene::Shape("torus"), MesoTechnique::ReliefQuadric));
  scene.Actor->SetMapper(mapper);
  scene.LookFrom(1., 3., 5.);
  MesoExpectedMessages expected("there is no image of the base, which vtkMesoBaseImage makes");
  scene.Window->Render();
}

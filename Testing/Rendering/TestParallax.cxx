// Parallax mapping: closed forms on flat-bottom maps, and the null cases.

#include "MesoBaseline.h"
#include "MesoTiltedPlane.h"

#include "vtkMesoBumpMapper.h"

#include <gtest/gtest.h>

namespace
{
/// The plane of MesoTiltedPlane with a parallax mapper.
struct ParallaxPlane : public MesoTiltedPlane
{
  vtkNew<vtkMesoBumpMapper> Parallax;

  ParallaxPlane(
    double degrees, double scale, vtkImageData* heights, MesoParallaxKind kind, MesoQuality quality)
    : MesoTiltedPlane(degrees, scale, heights, 48)
  {
    MesoMesostructureOptions options;
    options.Technique = MesoTechnique::Parallax;
    options.Parallax = kind;
    options.Quality = quality;
    options.Scale = scale;
    this->Parallax->SetOptions(options);
    this->Parallax->SetInputData(MesoTestScene::Shape("plane"));
    this->Parallax->SetHeightMap(heights);
    this->Actor->SetMapper(this->Parallax);
  }
};

constexpr double Depth = 0.1;
constexpr float Bottom = 0.25f; // height of the flat bottom
}

TEST(Parallax, OcclusionOnAFlatBottomIsExact)
{
  // The straight line between two samples of a flat map is the map.
  for (const double degrees : { 0., 30., 60., 75. })
  {
    ParallaxPlane plane(degrees, Depth, MesoTestScene::Constant(Bottom),
      MesoParallaxKind::Occlusion, MesoQuality::Draft);
    plane.Capture();
    for (int column = 4; column < 44; column += 4)
    {
      if (std::abs(plane.EntryU(column) - 0.5) > 0.45)
      {
        continue; // beside the plane
      }
      const double u = plane.EntryU(column) + plane.TravelU() * (1. - Bottom);
      EXPECT_NEAR(plane.Pass->GetValue("texcoord.u", column, 20), u, 2e-6) << degrees;
      EXPECT_NEAR(plane.Pass->GetValue("texcoord.v", column, 20), plane.EntryV(20), 2e-6);
      EXPECT_NEAR(plane.Pass->GetValue("relief", column, 20), 1. - Bottom, 1e-6);
      // The surface does not move, and neither does the depth buffer.
      const double distance = 5. + plane.ScreenX(column) * std::tan(plane.Angle);
      EXPECT_NEAR(plane.Pass->GetValue("depth", column, 20), distance, 2e-5) << degrees;
    }
  }
}

TEST(Parallax, OffsetOnAFlatBottomApproachesByTheCosine)
{
  // Each step leaves 1 - cos(view) of the way.
  for (const auto quality : { MesoQuality::Draft, MesoQuality::Medium, MesoQuality::High })
  {
    for (const double degrees : { 0., 30., 60. })
    {
      ParallaxPlane plane(
        degrees, Depth, MesoTestScene::Constant(Bottom), MesoParallaxKind::Offset, quality);
      plane.Capture();
      const int steps = MesoParallaxStepsOfQuality(quality).Offset;
      const double part = 1. - std::pow(1. - std::cos(plane.Angle), steps);
      const double u = plane.EntryU(20) + plane.TravelU() * (1. - Bottom) * part;
      EXPECT_NEAR(plane.Pass->GetValue("texcoord.u", 20, 20), u, 2e-6) << degrees << " " << steps;
      EXPECT_EQ(plane.Pass->GetValue("fetches", 20, 20), 5.f * steps + 1.f);
      EXPECT_EQ(plane.Pass->GetValue("iterations", 20, 20), float(steps));
    }
  }
}

TEST(Parallax, OffsetSeesSlopes)
{
  // A ramp that falls along the view: the plane of the slope, stepped to by the cosine of the view times
  // that of the slope. h = 1 - u/2, so depth = u/2.
  const int size = 64;
  vtkNew<vtkImageData> ramp;
  ramp->SetDimensions(size, 1, 1);
  ramp->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < size; ++i)
  {
    ramp->SetScalarComponentFromDouble(i, 0, 0, 0, 1. - 0.5 * (i + 0.5) / size);
  }
  ParallaxPlane plane(45., Depth, ramp, MesoParallaxKind::Offset, MesoQuality::Draft);
  plane.Capture();
  const double entry = plane.EntryU(20);
  const double upright = 1. / std::sqrt(1. + std::pow(0.5 * Depth, 2));
  const double expected = entry + plane.TravelU() * 0.5 * entry * std::cos(plane.Angle) * upright;
  EXPECT_NEAR(plane.Pass->GetValue("texcoord.u", 20, 20), expected, 1e-5);
}

TEST(Parallax, OcclusionConvergesToTheHit)
{
  // On a smooth map each doubling of steps brings the read closer to where the ray meets the map, which
  // relief mapping finds.
  const auto heights = MesoTestScene::Pattern("smooth");
  MesoTiltedPlane relief(60., Depth, heights, 48);
  relief.Capture();
  double before = 1.;
  for (const auto quality : { MesoQuality::Draft, MesoQuality::Medium, MesoQuality::High })
  {
    ParallaxPlane plane(60., Depth, heights, MesoParallaxKind::Occlusion, quality);
    plane.Capture();
    std::vector<double> apart;
    for (int row = 2; row < 46; ++row)
    {
      for (int column = 2; column < 46; ++column)
      {
        apart.push_back(std::abs(plane.Pass->GetValue("texcoord.u", column, row) -
          relief.Pass->GetValue("texcoord.u", column, row)));
      }
    }
    std::sort(apart.begin(), apart.end());
    const double error = apart[apart.size() * 9 / 10];
    EXPECT_LT(error, before / 2.);
    before = error;
  }
  EXPECT_LT(before * 64., 0.05); // texels
  EXPECT_GT(before * 64., 1e-4); // no exact refinement
}

TEST(Parallax, WithoutReliefIsTheBaseMesh)
{
  MesoTestScene scene;
  const auto torus = MesoTestScene::Shape("torus");
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(torus);
  scene.AddDirectionalLight(-1., -2., -1.);
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.LookFrom(1., 3., 5.);
  scene.Actor->SetMapper(plain);
  const auto expected = MesoGrabWindow(scene.Window);
  for (const auto kind : { MesoParallaxKind::Occlusion, MesoParallaxKind::Offset })
  {
    vtkNew<vtkMesoBumpMapper> mapper;
    mapper->SetInputData(torus);
    MesoMesostructureOptions options;
    options.Technique = MesoTechnique::Parallax;
    options.Parallax = kind;
    options.Scale = 0.1;
    mapper->SetOptions(options);
    scene.Actor->SetMapper(mapper);
    const auto same = [&]()
    {
      return MesoCompareImages(MesoGrabWindow(scene.Window), expected, MesoImageLimits::Exact())
        .Within;
    };
    EXPECT_TRUE(same()) << "no map";
    mapper->SetHeightMap(MesoTestScene::Constant(1.f));
    EXPECT_TRUE(same()) << "depth 0";
    mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
    EXPECT_FALSE(same());
    mapper->SetScale(0.);
    EXPECT_TRUE(same()) << "no depth";
  }
}

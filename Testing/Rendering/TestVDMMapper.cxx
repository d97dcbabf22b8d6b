// The technique vdm: nothing of it where there is no relief, closed forms, the table against relief mapping
// angle by angle, factors, and every choice of effects.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"
#include "MesoTestScene.h"
#include "MesoTestVDM.h"
#include "VDMPlane.h"

#include "vtkFieldData.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoReliefMapper.h"
#include "vtkMesoVDMMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
const double Pi = std::acos(-1.);
constexpr int Size = 64;

/// The torus with brick, plain and by a table.
class VDMOnTorus : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoPolyDataMapper> Plain;
  vtkNew<vtkMesoVDMMapper> VDM;
  vtkSmartPointer<vtkImageData> Heights = MesoTestScene::Pattern("brick");

  void SetUp() override
  {
    const auto torus = MesoTestScene::Shape("torus");
    this->Plain->SetInputData(torus);
    this->VDM->SetInputData(MesoTestScene::Prepared(torus, MesoTechnique::VDM));
    this->VDM->SetHeightMap(this->Heights);
    this->VDM->SetTable(MesoSmallVDM(this->Heights, 0.1));
    this->VDM->SetScale(0.06);
    this->VDM->SetTiles(10., 4.);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.AddHeadlight();
    this->Scene.LookFrom(1., 3., 5.);
  }

  vtkSmartPointer<vtkImageData> Picture(vtkMapper* mapper)
  {
    this->Scene.Actor->SetMapper(mapper);
    return MesoGrabWindow(this->Scene.Window);
  }

  void ExpectPlain(const MesoImageLimits& limits = MesoImageLimits::Exact())
  {
    const auto plain = this->Picture(this->Plain);
    const auto difference = MesoCompareImages(this->Picture(this->VDM), plain, limits);
    EXPECT_TRUE(difference.Within) << difference.Describe();
  }
};

/// Distances in texels between what two captures hit, sorted.
std::vector<double> Distances(const std::vector<float>& u0, const std::vector<float>& v0,
  const std::vector<float>& u1, const std::vector<float>& v1)
{
  std::vector<double> distances;
  for (std::size_t i = 0; i < u0.size(); ++i)
  {
    distances.push_back(Size * std::hypot(u0[i] - u1[i], v0[i] - v1[i]));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}
}

TEST_F(VDMOnTorus, IsSeenAtAll)
{
  const auto plain = this->Picture(this->Plain);
  EXPECT_FALSE(MesoCompareImages(this->Picture(this->VDM), plain, {}).Within);
}

TEST_F(VDMOnTorus, IsPlainWithoutDepth)
{
  this->VDM->SetScale(0.);
  this->ExpectPlain();
}

TEST_F(VDMOnTorus, IsPlainWhereTheMapIsHigh)
{
  for (const int rank : { 0, 4 })
  {
    vtkSmartPointer<vtkImageData> high = MesoTestScene::Constant(1.f);
    this->VDM->SetHeightMap(high);
    this->VDM->SetTable(MesoSmallVDM(high, 0.1, rank, 4));
    this->ExpectPlain(MesoImageLimits()); // a color's last bit may be rounded otherwise
  }
}

TEST_F(VDMOnTorus, IsPlainWithoutATable)
{
  this->VDM->SetTable(nullptr);
  this->ExpectPlain();
}

TEST_F(VDMOnTorus, IsPlainWithoutAMap)
{
  this->VDM->SetHeightMap(nullptr);
  this->ExpectPlain();
}

TEST_F(VDMOnTorus, IsPlainWithoutEffects)
{
  MesoMesostructureOptions options = this->VDM->GetOptions();
  options.Effects.Auto = false;
  this->VDM->SetOptions(options);
  this->ExpectPlain();
}

TEST_F(VDMOnTorus, RefusesWhatIsNoTable)
{
  {
    MesoExpectedMessages expected("no VDMSizes");
    this->VDM->SetTable(MesoTestScene::Constant(0.f));
    EXPECT_EQ(expected.GetCount(), 1);
  }
  this->ExpectPlain();
  const auto table = MesoSmallVDM(this->Heights, 0.1, 4);
  table->GetFieldData()->RemoveArray("VDMFunctions");
  MesoExpectedMessages expected("has no VDMFunctions");
  this->VDM->SetTable(table);
  EXPECT_EQ(expected.GetCount(), 1);
}

TEST_F(VDMOnTorus, DrawsEveryChoiceOfEffects)
{
  const MesoEffect effects[] = { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow,
    MesoEffect::Depth, MesoEffect::Silhouette, MesoEffect::Curvature };
  const auto plain = this->Picture(this->Plain);
  for (const int rank : { 0, 3 })
  {
    this->VDM->SetTable(MesoSmallVDM(this->Heights, 0.1, rank));
    for (const MesoEffect left : effects)
    {
      MesoMesostructureOptions options = this->VDM->GetOptions();
      options.Effects.Auto = false;
      for (const MesoEffect effect : effects)
      {
        options.Effects.Named.Set(effect, effect != left);
      }
      this->VDM->SetOptions(options);
      EXPECT_FALSE(MesoCompareImages(this->Picture(this->VDM), plain, {}).Within)
        << rank << " without " << MesoName(left);
    }
  }
}

TEST_F(VDMOnTorus, LooksUpAtMostFourteenTimes)
{
  vtkNew<vtkMesoAOVPass> pass;
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.AddDirectionalLight(-1., -2., -1.);
  this->VDM->SetTable(MesoSmallVDM(this->Heights, 0.1, 8));
  MesoMesostructureOptions options = this->VDM->GetOptions();
  options.Rank = { 8, 4 };
  this->VDM->SetOptions(options);
  this->Scene.Actor->SetMapper(this->VDM);
  MesoCapture(this->Scene, pass);
  EXPECT_GT(MesoCheckEveryPixel(pass), 1000);
  const std::vector<float> fetches = pass->GetChannel("fetches");
  EXPECT_LE(*std::max_element(fetches.begin(), fetches.end()), 14.f);
  pass->ReleaseGraphicsResources(this->Scene.Window);
}

TEST_F(VDMOnTorus, CurvatureMayBeTakenAtTheVertices)
{
  const auto atPixels = this->Picture(this->VDM);
  MesoMesostructureOptions options = this->VDM->GetOptions();
  options.CurvatureAt = MesoCurvatureAt::Vertex;
  this->VDM->SetOptions(options);
  const auto atVertices = this->Picture(this->VDM);
  // The same but for some pixels at edges, and not the same.
  MesoImageLimits limits;
  limits.SmallDifference = 16;
  limits.SmallFraction = 0.05;
  limits.LargeDifference = 255;
  const auto difference = MesoCompareImages(atVertices, atPixels, limits);
  EXPECT_TRUE(difference.Within) << difference.Describe();
  EXPECT_FALSE(MesoCompareImages(atVertices, atPixels, MesoImageLimits::Exact()).Within);
  // With a geometry stage in between, which hands it on.
  this->Scene.Actor->GetProperty()->EdgeVisibilityOn();
  EXPECT_FALSE(
    MesoCompareImages(this->Picture(this->VDM), this->Picture(this->Plain), limits).Within);
  this->Scene.Actor->GetProperty()->EdgeVisibilityOff();
  // A parallel camera's rays have one direction everywhere.
  this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(1.6);
  const auto parallel = this->Picture(this->VDM);
  options.CurvatureAt = MesoCurvatureAt::Pixel;
  this->VDM->SetOptions(options);
  const auto other = MesoCompareImages(parallel, this->Picture(this->VDM), limits);
  EXPECT_TRUE(other.Within) << other.Describe();
}

TEST_F(VDMOnTorus, CurvatureAtTheVerticesOfAPlaneIsThatOfItsPixels)
{
  this->VDM->SetInputData(
    MesoTestScene::Prepared(MesoTestScene::Shape("plane"), MesoTechnique::VDM));
  this->Scene.LookFrom(0.3, 1., 2.);
  const auto atPixels = this->Picture(this->VDM);
  MesoMesostructureOptions options = this->VDM->GetOptions();
  options.CurvatureAt = MesoCurvatureAt::Vertex;
  this->VDM->SetOptions(options);
  EXPECT_TRUE(MesoCompareImages(this->Picture(this->VDM), atPixels, MesoImageLimits()).Within);
}

TEST_F(VDMOnTorus, FarAwayNormalsAreAveraged)
{
  // Nearer to the mean of many pixels than without levels, though that is of what the table draws, and not the truth.
  for (const int rank : { 0, 8 })
  {
    const auto noise = MesoTestScene::Pattern("noise");
    this->VDM->SetHeightMap(noise);
    this->VDM->SetTable(MesoSmallVDM(noise, 0.05, rank, Size));
    this->VDM->SetScale(0.02);
    const auto meanDifference = [&](MesoFilter filter, double distance)
    {
      MesoMesostructureOptions options = this->VDM->GetOptions();
      this->Scene.LookFrom(distance / 6., distance / 2., distance * 5. / 6.);
      options.Filter = MesoFilter::None;
      this->VDM->SetOptions(options);
      constexpr int factor = 6;
      this->Scene.Window->SetSize(50 * factor, 50 * factor);
      const auto fine = this->Picture(this->VDM);
      this->Scene.Window->SetSize(50, 50);
      options.Filter = filter;
      this->VDM->SetOptions(options);
      const auto coarse = this->Picture(this->VDM);
      double sum = 0.;
      for (int row = 0; row < 50; ++row)
      {
        for (int column = 0; column < 50; ++column)
        {
          double mean = 0.;
          for (int i = 0; i < factor * factor; ++i)
          {
            mean += fine->GetScalarComponentAsDouble(
              column * factor + i % factor, row * factor + i / factor, 0, 0);
          }
          const double apart =
            coarse->GetScalarComponentAsDouble(column, row, 0, 0) - mean / (factor * factor);
          sum += apart * apart;
        }
      }
      return std::sqrt(sum / 2500.);
    };
    EXPECT_LT(meanDifference(MesoFilter::Auto, 9.), 0.85 * meanDifference(MesoFilter::None, 9.))
      << rank;
  }
}

TEST(VDMMapper, MeetsALevelWhereItIs)
{
  const auto level = MesoTestScene::Constant(0.25f);
  for (const int rank : { 0, 8 })
  {
    vtkNew<vtkMesoVDMMapper> mapper;
    mapper->SetHeightMap(level);
    mapper->SetTable(MesoSmallVDM(level, 0.2, rank, 4)); // the plane's relief is 0.1 tiles deep
    for (const double degrees : { 0., 40., 75. })
    {
      VDMPlane plane(degrees, 0.7);
      plane.Capture(mapper);
      const std::vector<float> relief = plane.Values("relief");
      const std::vector<float> depth = plane.Values("depth");
      const std::vector<float> coverage = plane.Values("coverage");
      for (std::size_t i = 0; i < relief.size(); ++i)
      {
        ASSERT_EQ(coverage[i], 1.f);
        // 8 bits of each weight, then 16 of the table.
        ASSERT_NEAR(relief[i], 0.75, rank > 0 ? 1e-3 : 1e-4) << degrees;
      }
      // The middle of the picture: 5 to the plane, and on to the level.
      const std::size_t middle = relief.size() / 2 + 50;
      EXPECT_NEAR(depth[middle], 5. + 0.0375 / std::cos(degrees * Pi / 180.), 3e-3) << degrees;
    }
  }
}

TEST(VDMMapper, AgreesWithReliefMappingAngleByAngle)
{
  // What 8 polar angles leave between them, in texels: median and 95th percentile.
  struct Case
  {
    double Degrees;
    double Median;
    double Ninetyfifth;
  };
  const auto heights = MesoTestScene::Pattern("smooth", Size, Size);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  vdm->SetTable(MesoSmallVDM(heights, 0.1, 0, Size, 32));
  const auto relief = CertifiedRelief(heights);
  for (const Case& one : { Case{ 0., 0.02, 0.05 }, Case{ 30., 0.05, 0.1 }, Case{ 50., 0.05, 0.3 },
         Case{ 70., 0.2, 1.5 }, Case{ 80., 1., 6. } })
  {
    VDMPlane plane(one.Degrees, 3.6); // both steps over the map are negative
    plane.Capture(relief);
    const auto u = plane.Values("texcoord.u");
    const auto v = plane.Values("texcoord.v");
    const auto shadow = plane.Values("shadow.0");
    plane.Capture(vdm);
    const auto distances = Distances(u, v, plane.Values("texcoord.u"), plane.Values("texcoord.v"));
    EXPECT_LT(distances[distances.size() / 2], one.Median) << one.Degrees;
    EXPECT_LT(distances[distances.size() * 95 / 100], one.Ninetyfifth) << one.Degrees;
    const auto looked = plane.Values("shadow.0");
    std::size_t different = 0;
    for (std::size_t i = 0; i < shadow.size(); ++i)
    {
      different += shadow[i] == looked[i] ? 0 : 1;
    }
    EXPECT_LT(different, shadow.size() / 20) << one.Degrees;
  }
}

TEST(VDMMapper, AlongTheNormalTheMapItselfIsMet)
{
  // The first of 8 angles is at 7 degrees, and what it stores would be met at another depth.
  constexpr int Texels = 24;
  const auto heights = MesoTestScene::Pattern("smooth", Texels, Texels);
  const auto relief = CertifiedRelief(heights);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  VDMPlane plane(0., 3.6);
  plane.Capture(relief, 0.15);
  const auto searched = plane.Values("depth");
  for (const int rank : { 0, 12 })
  {
    vdm->SetTable(MesoSmallVDM(heights, 0.3, rank));
    plane.Capture(vdm, 0.15);
    const auto looked = plane.Values("depth");
    for (std::size_t i = 0; i < looked.size(); ++i)
    {
      ASSERT_NEAR(looked[i], searched[i], 1e-5) << rank;
    }
  }
}

TEST(VDMMapper, NearestOutlinesAreThoseOfTexelsAroundTheirCentres)
{
  // Rings around a cylinder: map and shape are symmetric about its middle, and so is the outline.
  vtkSmartPointer<vtkImageData> heights = MesoTestScene::Pattern("brick", 4, 8);
  for (int texel = 0; texel < 32; ++texel)
  {
    const int row = texel / 4;
    static_cast<float*>(heights->GetScalarPointer())[texel] = row < 2 || row > 5 ? 0.f : 1.f;
  }
  heights->Modified();
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  vdm->SetTable(MesoSmallVDM(heights, 0.2, 0, 8));
  vdm->SetInputData(MesoTestScene::Prepared(MesoTestScene::Shape("cylinder"), MesoTechnique::VDM));
  vdm->SetTiles(4., 2.);
  vdm->SetScale(0.25);
  MesoTestScene scene(150, 200);
  scene.Actor->SetMapper(vdm);
  scene.LookFrom(0., 0., 6.);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.2);
  for (const bool nearest : { false, true })
  {
    vdm->SetNearestOutlines(nearest);
    vtkNew<vtkMesoAOVPass> pass;
    MesoCapture(scene, pass);
    int covered = 0;
    int unlike = 0;
    for (int row = 0; row < 100; ++row)
    {
      for (int column = 0; column < 150; ++column)
      {
        const float above = pass->GetValue("coverage", column, row);
        const float below = pass->GetValue("coverage", column, 199 - row);
        covered += above > 0.f ? 1 : 0;
        unlike += above != below ? 1 : 0;
      }
    }
    pass->ReleaseGraphicsResources(scene.Window);
    EXPECT_GT(covered, 2000) << nearest;
    EXPECT_LT(unlike, 20) << nearest;
  }
}

TEST(VDMMapper, HasNoSeamBetweenTheLastAzimuthAndTheFirst)
{
  const auto heights = MesoTestScene::Pattern("smooth", Size, Size);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  for (const int rank : { 0, 8 })
  {
    vdm->SetTable(MesoSmallVDM(heights, 0.1, rank));
    VDMPlane before(50., -0.002);
    before.Capture(vdm);
    VDMPlane after(50., 0.002);
    after.Capture(vdm);
    const auto distances = Distances(before.Values("texcoord.u"), before.Values("texcoord.v"),
      after.Values("texcoord.u"), after.Values("texcoord.v"));
    EXPECT_LT(distances.back(), 1.); // the view itself turned by 0.23 degrees
  }
}

TEST(VDMMapper, MoreFactorsAreNearerToTheTable)
{
  const auto heights = MesoTestScene::Pattern("brick", Size, Size);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  vdm->SetTable(MesoSmallVDM(heights, 0.1));
  VDMPlane plane(55., 0.3);
  plane.Capture(vdm);
  const auto u = plane.Values("texcoord.u");
  const auto v = plane.Values("texcoord.v");
  vdm->SetTable(MesoSmallVDM(heights, 0.1, 12));
  double before = 1e9;
  for (const auto quality :
    { MesoQuality::Draft, MesoQuality::Low, MesoQuality::Medium, MesoQuality::High })
  {
    MesoMesostructureOptions options = vdm->GetOptions();
    options.Quality = quality;
    vdm->SetOptions(options);
    plane.Capture(vdm);
    const auto distances = Distances(u, v, plane.Values("texcoord.u"), plane.Values("texcoord.v"));
    double mean = 0.;
    for (const double distance : distances)
    {
      mean += distance / double(distances.size());
    }
    EXPECT_LT(mean, before) << MesoName(quality);
    before = mean;
  }
  EXPECT_LT(before, 0.5);
}

TEST(VDMMapper, HardViewsGiveNumbers)
{
  // Grazing, from very near, along the normal, and curvatures beyond the table's.
  const auto heights = MesoTestScene::Pattern("spikes", Size, Size);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  for (const int rank : { 0, 8 })
  {
    vdm->SetTable(MesoSmallVDM(heights, 0.25, rank));
    for (const char* shape : { "torus", "sphere", "undulating", "plane" })
    {
      vdm->SetInputData(MesoTestScene::Prepared(MesoTestScene::Shape(shape), MesoTechnique::VDM));
      vdm->SetTiles(2., 2.);
      for (const double scale : { 0.01, 0.3 })
      {
        vdm->SetScale(scale);
        for (const auto& from : { std::array<double, 3>{ 3., 0.02, 0. }, { 0., 0., 1.2 },
               { 0.6, 0.7, 0.8 }, { 0., 3., 0. } })
        {
          MesoTestScene scene(64, 64);
          vtkNew<vtkMesoAOVPass> pass;
          scene.Actor->SetMapper(vdm);
          scene.AddDirectionalLight(0.2, 1., 0.05);
          scene.LookFrom(from[0], from[1], from[2]);
          MesoCapture(scene, pass);
          MesoCheckEveryPixel(pass);
          pass->ReleaseGraphicsResources(scene.Window);
        }
      }
    }
  }
}

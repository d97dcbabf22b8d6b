// The mapper's searches as users meet them: each compiles with whatever effects are on, cones follow the
// map, and steps can be set apart from the quality.

#include "MesoExpectedMessages.h"
#include "MesoTiltedPlane.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
constexpr int Size = 60;
constexpr int Texels = 64;

struct Plane : public MesoTiltedPlane
{
  explicit Plane(vtkImageData* heights)
    : MesoTiltedPlane(60., 0.1, heights, Size)
  {
    this->AddDirectionalLight(-1., 0.4, -1.);
  }

  void Use(MesoSearch search, const MesoEffectChoice& effects = {})
  {
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.Search = search;
    options.Effects = effects;
    this->Mapper->SetOptions(options);
  }

  /// The relief's depths.
  std::vector<float> Depths()
  {
    this->Capture();
    EXPECT_EQ(this->Mapper->GetWhyPlain(), "");
    return this->Pass->GetInterleaved({ "relief" });
  }
};

const MesoSearch AllSearches[] = { MesoSearch::LinearBinary, MesoSearch::LinearSecant,
  MesoSearch::Cone, MesoSearch::Certified };
}

TEST(ReliefSearches, GoWithEveryChoiceOfEffects)
{
  const auto heights = MesoTestScene::Pattern("smooth", Texels, Texels);
  for (const MesoTechnique technique : { MesoTechnique::Relief, MesoTechnique::ReliefQuadric })
  {
    for (const MesoEffects effects : { MesoEffects{ MesoEffect::Shading },
           MesoEffects{ MesoEffect::Occlusion }, MesoEffects{ MesoEffect::SelfShadow },
           MesoEffects{ MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::Depth } })
    {
      std::vector<float> before;
      for (const MesoSearch search : AllSearches)
      {
        Plane plane(heights);
        plane.Mapper->SetInputData(
          MesoTestScene::Prepared(MesoTestScene::Shape("plane"), technique));
        MesoMesostructureOptions options = plane.Mapper->GetOptions();
        options.Technique = technique;
        plane.Mapper->SetOptions(options);
        plane.Use(search, { false, effects });
        const std::vector<float> depths = plane.Depths();
        ASSERT_EQ(plane.Pass->GetValue("coverage", Size / 2, Size / 2), 1.f);
        for (std::size_t i = 0; i < before.size(); ++i)
        {
          // A smooth map: nothing is missed by any, and all agree to float's rounding and, by
          // secants, to what four of them leave.
          ASSERT_NEAR(depths[i], before[i], 1e-3) << MesoName(search);
        }
        before = depths;
      }
    }
  }
}

TEST(ReliefSearches, ConesFollowTheMapAndItsWrap)
{
  const auto heights = MesoTestScene::Pattern("brick", Texels, Texels);
  Plane plane(heights);
  plane.Use(MesoSearch::LinearBinary);
  plane.Depths();
  const std::size_t without = plane.Mapper->GetGPUBytes();
  plane.Use(MesoSearch::Certified);
  const std::vector<float> first = plane.Depths();
  // Four cones of two bytes a texel and the heights once more, and half of both for the pyramid's levels.
  EXPECT_EQ(plane.Mapper->GetGPUBytes(), without + Texels * Texels * (8 + 4 + 4 + 2));
  MesoMesostructureOptions unfiltered = plane.Mapper->GetOptions();
  unfiltered.Filter = MesoFilter::None;
  const auto bytesBy = [&](MesoSearch search)
  {
    Plane alone(heights);
    unfiltered.Search = search;
    alone.Mapper->SetOptions(unfiltered);
    alone.Depths();
    return alone.Mapper->GetGPUBytes();
  };
  EXPECT_EQ(
    bytesBy(MesoSearch::Certified), bytesBy(MesoSearch::LinearBinary) + Texels * Texels * 8);

  // A wall that old cones would let rays through.
  auto* values = vtkFloatArray::SafeDownCast(heights->GetPointData()->GetScalars());
  for (int row = 0; row < Texels; ++row)
  {
    values->SetValue(row * Texels + Texels / 2, 1.f);
  }
  heights->GetPointData()->GetScalars()->Modified();
  heights->Modified();
  const std::vector<float> second = plane.Depths();
  EXPECT_NE(first, second);
  Plane fresh(heights);
  fresh.Use(MesoSearch::Certified);
  EXPECT_EQ(fresh.Depths(), second);

  for (const MesoWrap wrap : { MesoWrap::Clamp, MesoWrap::Mirror })
  {
    MesoMesostructureOptions options = plane.Mapper->GetOptions();
    options.Wrap = wrap;
    options.Tiles = { 3., 3. };
    plane.Mapper->SetOptions(options);
    Plane other(heights);
    other.Mapper->SetOptions(options);
    EXPECT_EQ(plane.Depths(), other.Depths()) << MesoName(wrap);
  }
}

TEST(ReliefSearches, SayWhereAMapIsTooLargeForCones)
{
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(9000, 1, 1); // twice that is more than llvmpipe's 16384
  heights->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 9000; ++i)
  {
    heights->GetPointData()->GetScalars()->SetComponent(i, 0, 0.5);
  }
  Plane plane(heights);
  plane.Use(MesoSearch::LinearBinary);
  plane.Depths();
  if (vtkTextureObject::GetMaximumTextureSize(plane.Window) >= 18000)
  {
    GTEST_SKIP() << "this device takes them";
  }
  plane.Use(MesoSearch::Certified);
  MesoExpectedMessages expected("9000 x 1 is larger than the 8192");
  plane.Capture();
  EXPECT_NE(plane.Mapper->GetWhyPlain().find("search by cones"), std::string::npos);
}

TEST(ReliefSearches, TakeStepsInPlaceOfTheQualitys)
{
  const auto heights = MesoTestScene::Pattern("brick", Texels, Texels);
  Plane plane(heights);
  plane.Use(MesoSearch::LinearBinary);
  const auto most = [&]()
  {
    plane.Capture();
    const std::vector<float> iterations = plane.Pass->GetInterleaved({ "iterations" });
    return *std::max_element(iterations.begin(), iterations.end());
  };
  EXPECT_GT(most(), 60.f); // of 128 + 8
  plane.Mapper->SetSearchSteps(8, 3);
  EXPECT_LE(most(), 8.f + 3.f);
  plane.Mapper->SetSearchSteps(0, 0);
  EXPECT_GT(most(), 60.f);
}

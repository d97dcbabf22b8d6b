// Relief without relief is the base mesh: D = 0, a depth map that is 0 everywhere, no map at all, and
// an input that lacks frames (with one warning that says what to add).

#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"
#include "MesoReliefTechniques.h"

#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

namespace
{
class ReliefNullCases : public testing::TestWithParam<MesoTechnique>
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoPolyDataMapper> Plain;
  vtkNew<vtkMesoReliefMapper> Relief;

  void SetUp() override
  {
    const auto torus = MesoTestScene::Shape("torus");
    this->Plain->SetInputData(torus);
    MesoUse(this->Relief, this->GetParam(), torus);
    this->Relief->SetHeightMap(MesoTestScene::Pattern("brick"));
    this->Relief->SetScale(0.1);
    this->Relief->SetTiles(6., 3.);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.AddHeadlight();
    this->Scene.Actor->GetProperty()->SetSpecular(0.3);
    this->Scene.Actor->GetProperty()->SetSpecularPower(20.);
    this->Scene.LookFrom(1., 3., 5.);
  }

  MesoImageDifference Compare(const MesoImageLimits& limits)
  {
    this->Scene.Actor->SetMapper(this->Plain);
    const auto plain = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->SetMapper(this->Relief);
    return MesoCompareImages(MesoGrabWindow(this->Scene.Window), plain, limits);
  }
};
}

TEST_P(ReliefNullCases, ReliefIsSeenAtAll)
{
  EXPECT_FALSE(this->Compare({}).Within);
}

TEST_P(ReliefNullCases, ZeroScale)
{
  this->Relief->SetScale(0.);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefNullCases, DepthMapOfZero)
{
  this->Relief->SetHeightMap(MesoTestScene::Constant(1.f));
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefNullCases, DepthMapOfZeroTextured)
{
  this->Relief->SetHeightMap(MesoTestScene::Constant(1.f));
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const unsigned char colours[] = { 250, 20, 20, 20, 250, 20, 20, 20, 250, 250, 250, 20 };
  std::copy(
    std::begin(colours), std::end(colours), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  this->Scene.Actor->SetTexture(texture);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefNullCases, NoHeightMap)
{
  this->Relief->SetHeightMap(nullptr);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefNullCases, SeenFromBehind)
{
  const auto plane = MesoTestScene::Shape("plane");
  this->Plain->SetInputData(plane);
  MesoUse(this->Relief, this->GetParam(), plane);
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  this->Scene.LookFrom(0.5, 0.4, -2.);
  this->Scene.AddDirectionalLight(0.3, 0.2, 1.);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefNullCases, NoEffects)
{
  MesoMesostructureOptions options = this->Relief->GetOptions();
  options.Effects.Auto = false;
  this->Relief->SetOptions(options);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
  EXPECT_TRUE(this->Relief->GetEffectsDrawn().Empty());
}

TEST_P(ReliefNullCases, MissingFramesAreSaidOnce)
{
  this->Relief->GetInput()->GetPointData()->RemoveArray("MesoTangent");
  MesoExpectedMessages expected("lacks MesoTangent");
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
  this->Scene.Window->Render();
  EXPECT_EQ(expected.GetCount(), 1);
  EXPECT_NE(this->Relief->GetWhyPlain().find("lacks MesoTangent"), std::string::npos);
}

TEST_P(ReliefNullCases, BoundsHoldTheRelief)
{
  double plain[6];
  double relief[6];
  this->Plain->GetBounds(plain);
  this->Relief->GetBounds(relief);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_DOUBLE_EQ(relief[i], plain[i] + (i % 2 == 0 ? -0.1 : 0.1));
  }
  this->Relief->SetHeightMap(nullptr);
  this->Relief->GetBounds(relief);
  EXPECT_EQ(relief[0], plain[0]);
}

TEST_P(ReliefNullCases, AnotherWindowAndBackAgain)
{
  this->Scene.Actor->SetMapper(this->Relief);
  const auto first = MesoGrabWindow(this->Scene.Window);
  {
    MesoTestScene other;
    other.Actor->SetMapper(this->Relief);
    other.AddDirectionalLight(-1., -2., -1.);
    other.LookFrom(1., 3., 5.);
    other.Window->Render();
  }
  const auto again = MesoGrabWindow(this->Scene.Window);
  EXPECT_TRUE(MesoCompareImages(again, first, MesoImageLimits::Exact()).Within);
}

TEST_P(ReliefNullCases, OptionsTakeEffectBetweenFrames)
{
  this->Scene.Actor->SetMapper(this->Relief);
  this->Scene.Window->Render();
  EXPECT_TRUE(this->Relief->GetEffectsDrawn().Has(MesoEffect::SelfShadow));
  MesoMesostructureOptions options = this->Relief->GetOptions();
  options.Effects.Auto = false;
  options.Effects.Named = { MesoEffect::Shading };
  this->Relief->SetOptions(options);
  const auto shading = MesoGrabWindow(this->Scene.Window);
  EXPECT_EQ(this->Relief->GetEffectsDrawn(), MesoEffects({ MesoEffect::Shading }));
  this->Relief->SetHeightMap(MesoTestScene::Pattern("noise"));
  const auto noise = MesoGrabWindow(this->Scene.Window);
  EXPECT_FALSE(MesoCompareImages(noise, shading).Within) << "the new map is not seen";
}

TEST_P(ReliefNullCases, WrongOptionsAreRefused)
{
  MesoMesostructureOptions options = this->Relief->GetOptions();
  options.Scale = -1.;
  {
    MesoExpectedMessages expected("Scale must be at least 0");
    this->Relief->SetOptions(options);
  }
  EXPECT_EQ(this->Relief->GetScale(), 0.1);
  MesoExpectedMessages expected("does not provide the effect shading");
  options.Scale = 0.1;
  options.Effects.Auto = false;
  options.Effects.Named = { MesoEffect::Shading };
  this->Plain->SetOptions(options);
}

TEST_P(ReliefNullCases, TechniquesTakeTurnsOnOneMapper)
{
  this->Relief->SetInputData(
    MesoTestScene::Prepared(MesoTestScene::Shape("torus"), MesoTechnique::ReliefQuadric));
  this->Scene.Actor->SetMapper(this->Relief);
  const auto grab = [this](MesoTechnique technique)
  {
    MesoMesostructureOptions options = this->Relief->GetOptions();
    options.Technique = technique;
    this->Relief->SetOptions(options);
    return MesoGrabWindow(this->Scene.Window);
  };
  const MesoTechnique other = this->GetParam() == MesoTechnique::Relief
    ? MesoTechnique::ReliefQuadric
    : MesoTechnique::Relief;
  const auto first = grab(this->GetParam());
  EXPECT_FALSE(MesoCompareImages(grab(other), first).Within);
  EXPECT_TRUE(MesoCompareImages(grab(this->GetParam()), first, MesoImageLimits::Exact()).Within);
}

MESO_FOR_RELIEF_TECHNIQUES(ReliefNullCases);

// Options that were made for another mapper, or with their defaults, name another technique.
TEST(ReliefMapper, DrawsReliefWhateverOtherTechniqueTheOptionsName)
{
  MesoTestScene scene;
  vtkNew<vtkMesoReliefMapper> mapper;
  MesoUse(mapper, MesoTechnique::Relief, MesoTestScene::Shape("torus"));
  mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
  scene.Actor->SetMapper(mapper);
  scene.AddHeadlight();
  scene.LookFrom(1., 3., 5.);
  MesoMesostructureOptions options;
  options.Scale = 0.1;
  options.Technique = MesoTechnique::Relief;
  mapper->SetOptions(options);
  const auto relief = MesoGrabWindow(scene.Window);
  for (const MesoTechnique technique : { MesoTechnique::Plain, MesoTechnique::Tessellated })
  {
    options.Technique = technique;
    mapper->SetOptions(options);
    const auto drawn = MesoGrabWindow(scene.Window);
    EXPECT_TRUE(MesoCompareImages(drawn, relief, MesoImageLimits::Exact()).Within)
      << MesoName(technique);
    EXPECT_EQ(mapper->GetEffectsDrawn(),
      MesoEffectsOfTechnique(MesoTechnique::Relief).Without({ MesoEffect::CastShadow }));
  }
}

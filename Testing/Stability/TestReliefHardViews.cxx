// Views and lights that strain the arithmetic: along the normal, grazing, inside the relief, across
// the near plane, very wide, far, near; lights at the horizon, behind, inside, many. Every pixel's
// numbers stay finite and the mesh has no holes.

#include "MesoAOVChecks.h"

namespace
{
class ReliefHardViews : public MesoReliefAOVs
{
protected:
  void SetUp() override
  {
    this->Mapper->SetTiles(4., 4.);
    this->UseShape("plane");
  }

  void UseShape(const std::string& shape)
  {
    this->Bends = shape != "plane" && MesoBendsRelief(this->GetParam().Technique);
    this->Use(MesoTestScene::Shape(shape));
  }

  /// Checks every pixel; relief must cover just what the base mesh covers, or where the outline is
  /// the relief's, most of it and no more.
  int Check()
  {
    const int covered = this->MesoReliefAOVs::Check();
    const auto relief = this->Pass->GetChannel("coverage");
    const double scale = this->Mapper->GetScale();
    this->Mapper->SetScale(0.);
    MesoCapture(this->Scene, this->Pass);
    const auto base = this->Pass->GetChannel("coverage");
    if (this->Bends)
    {
      int outside = 0;
      for (std::size_t i = 0; i < relief.size(); ++i)
      {
        outside += relief[i] > base[i] ? 1 : 0;
      }
      EXPECT_EQ(outside, 0);
      EXPECT_GT(covered, 0.8 * std::count(base.begin(), base.end(), 1.f));
    }
    else
    {
      EXPECT_EQ(base, relief) << "holes";
    }
    this->Mapper->SetScale(scale);
    MesoCapture(this->Scene, this->Pass);
    return covered;
  }

  bool Bends = false; ///< outlines are those of the relief

  /// Seen from an elevation above the plane, in degrees.
  void LookAt(double elevation, double distance = 1.5)
  {
    const double angle = elevation * std::acos(-1.) / 180.;
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0., -distance * std::cos(angle), distance * std::sin(angle));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., elevation > 89. ? 1. : 0., elevation > 89. ? 0. : 1.);
    this->Scene.Renderer->ResetCameraClippingRange();
  }
};
}

TEST_P(ReliefHardViews, AlongTheNormal)
{
  this->LookAt(90.);
  EXPECT_GT(this->Check(), 5000);
}

TEST_P(ReliefHardViews, Grazing)
{
  for (double elevation : { 5., 1., 0.1, 0.01 })
  {
    this->LookAt(elevation);
    this->Check();
  }
}

TEST_P(ReliefHardViews, EveryAngleOnATorus)
{
  this->UseShape("torus");
  this->Scene.LookFrom(0., 1.2, 5.);
  EXPECT_GT(this->Check(), 1000);
  this->Scene.LookFrom(0., 6., 0.);
  EXPECT_GT(this->Check(), 1000);
}

TEST_P(ReliefHardViews, PolesOfASphere)
{
  this->UseShape("sphere");
  this->Scene.LookFrom(0., 4.5, 0.);
  EXPECT_GT(this->Check(), 2000);
  this->Scene.LookFrom(0., -4.5, 0.);
  EXPECT_GT(this->Check(), 2000);
}

TEST_P(ReliefHardViews, EyeInsideTheRelief)
{
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(0., -0.2, -0.05);
  camera->SetFocalPoint(0., 1., -0.05);
  camera->SetViewUp(0., 0., 1.);
  camera->SetClippingRange(0.001, 10.);
  this->Check();
}

TEST_P(ReliefHardViews, AcrossTheNearPlane)
{
  this->LookAt(30., 0.3);
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.25, 10.);
  EXPECT_GT(this->Check(), 1000);
}

TEST_P(ReliefHardViews, VeryWideAngle)
{
  this->LookAt(40., 0.5);
  this->Scene.Renderer->GetActiveCamera()->SetViewAngle(170.);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Check();
}

TEST_P(ReliefHardViews, FarAway)
{
  this->LookAt(40., 20.);
  EXPECT_GT(this->Check(), 5);
}

TEST_P(ReliefHardViews, OneTexelFillsTheScreen)
{
  this->LookAt(60., 0.004);
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(1e-4, 1.);
  EXPECT_EQ(this->Check(), 96 * 96);
}

TEST_P(ReliefHardViews, ParallelProjection)
{
  this->LookAt(30.);
  this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(0.4);
  this->Scene.Renderer->ResetCameraClippingRange();
  EXPECT_GT(this->Check(), 4000);
}

TEST_P(ReliefHardViews, NearToFarOneToTenMillion)
{
  this->LookAt(40.);
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 1e4);
  EXPECT_GT(this->Check(), 1000);
}

TEST_P(ReliefHardViews, LightsFromEverywhere)
{
  this->LookAt(50.);
  this->Scene.Renderer->RemoveAllLights();
  const double directions[][3] = { { 0., 0., -1. }, { 0., 0., 1. }, { 1., 0., 0. },
    { 1., 0., -1e-6 }, { 1., 0., 1e-6 }, { 1., 1., -1. } };
  for (const auto& direction : directions)
  {
    this->Scene.AddDirectionalLight(direction[0], direction[1], direction[2]);
  }
  // Inside the relief, and exactly on the base.
  for (double z : { -0.05, 0. })
  {
    vtkLight* light = this->Scene.AddDirectionalLight(0., 0., -1.);
    light->PositionalOn();
    light->SetConeAngle(90.);
    light->SetPosition(0., 0., z);
    light->SetFocalPoint(0., 0., z - 1.);
  }
  EXPECT_GT(this->Check(), 1000);
  // Along the normal nothing is in shadow but what faces away; from behind, everything is.
  int lit = 0;
  for (float shadow : this->Pass->GetChannel("shadow.0"))
  {
    lit += shadow == 0.f ? 1 : 0;
  }
  EXPECT_GT(lit, 96 * 96 * 9 / 10);
  const auto coverage = this->Pass->GetChannel("coverage");
  EXPECT_EQ(this->Pass->GetChannel("shadow.1"), coverage);
}

TEST_P(ReliefHardViews, WithoutALight)
{
  this->LookAt(50.);
  this->Scene.Renderer->RemoveAllLights();
  EXPECT_GT(this->Check(), 1000);
  for (const std::string& channel : this->Pass->GetChannelNames())
  {
    EXPECT_NE(channel, "shadow.0");
  }
}

TEST_P(ReliefHardViews, AHeadlightSeesNoShadowOfItsOwn)
{
  this->LookAt(50.);
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.AddHeadlight(); // directional, along the view's axis
  this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(0.3);
  this->Scene.Renderer->ResetCameraClippingRange();
  const int covered = this->Check();
  EXPECT_GT(covered, 4000);
  const auto shadow = this->Pass->GetChannel("shadow.0");
  EXPECT_LT(std::count(shadow.begin(), shadow.end(), 1.f), covered / 40); // walls seen edge-on
}

TEST_P(ReliefHardViews, SpotAtItsConesEdge)
{
  this->LookAt(60.);
  this->Scene.Renderer->RemoveAllLights();
  vtkLight* light = this->Scene.AddDirectionalLight(0., 0., -1.);
  light->PositionalOn();
  light->SetPosition(0., 0., 1.);
  light->SetConeAngle(std::atan(0.3) * 180. / std::acos(-1.));
  this->Check();
}

TEST_P(ReliefHardViews, TwelveLightsAndNoMore)
{
  this->LookAt(60.);
  this->Scene.Renderer->RemoveAllLights();
  for (int i = 0; i < 12; ++i)
  {
    this->Scene.AddDirectionalLight(std::cos(i), std::sin(i), -1.);
  }
  EXPECT_GT(this->Check(), 1000);
  EXPECT_EQ(this->Pass->GetChannelNames().back(), "shadow.11");
}

MESO_FOR_RELIEF_ARMS(ReliefHardViews);

#ifndef MesoAOVChecks_h
#define MesoAOVChecks_h

/**
 * @file MesoAOVChecks.h
 * @brief What must hold of every pixel's numbers, however hard the case.
 */

#include "MesoReliefTechniques.h"

#include "vtkMesoAOVPass.h"

#include <cmath>
#include <gtest/gtest.h>

/// Render a scene's AOVs once.
inline void MesoCapture(MesoTestScene& scene, vtkMesoAOVPass* pass)
{
  scene.Renderer->SetPass(pass);
  scene.Window->Render();
  scene.Renderer->SetPass(nullptr);
}

/**
 * Every value of every channel finite; relief, coverage and shadows in [0,1]; normals unit where
 * covered; 0 where not. Gives the number of covered pixels.
 */
inline int MesoCheckEveryPixel(const vtkMesoAOVPass* pass)
{
  int covered = 0;
  int wrong = 0;
  for (const std::string& channel : pass->GetChannelNames())
  {
    for (float value : pass->GetChannel(channel))
    {
      const bool fraction =
        channel == "coverage" || channel == "relief" || channel.compare(0, 7, "shadow.") == 0;
      if (!std::isfinite(value) || (fraction && (value < 0.f || value > 1.f)))
      {
        ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << channel;
    wrong = 0;
  }
  for (int row = 0; row < pass->GetHeight(); ++row)
  {
    for (int column = 0; column < pass->GetWidth(); ++column)
    {
      const auto value = [&](const char* channel) { return pass->GetValue(channel, column, row); };
      const double length = std::hypot(value("normal.x"), value("normal.y"), value("normal.z"));
      const bool hit = value("coverage") > 0.f;
      covered += hit ? 1 : 0;
      wrong += std::abs(length - (hit ? 1. : 0.)) > 1e-4 ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0) << "normals that are not unit";
  return covered;
}

/// One shape with relief in a technique over a base, and its AOVs.
class MesoReliefAOVs : public testing::TestWithParam<MesoReliefArm>
{
protected:
  MesoTestScene Scene{ 96, 96 };
  vtkNew<vtkMesoReliefMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  MesoReliefAOVs()
  {
    this->Mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
    this->Mapper->SetScale(0.1);
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(1., 1., -2.);
    this->Scene.LookFrom(0.4, -0.8, 1.6);
  }

  ~MesoReliefAOVs() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void Use(vtkPolyData* mesh) { MesoUse(this->Mapper, this->GetParam(), mesh); }

  /// Captures and checks every pixel; gives the number of covered ones.
  int Check()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }
};

#endif

// What must not change what the technique vdm draws, and what must: depths of the bake, whole tiles, slow pans,
// matrices, lights, and tables, maps and actors that change.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoTestScene.h"
#include "MesoTestVDM.h"
#include "vtkMesoVDMMapper.h"

#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The table itself, 0, or factors.
class VDMInvariance : public testing::TestWithParam<int>
{
protected:
  static constexpr int Size = 80;

  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoVDMMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  void SetUp() override
  {
    this->UseMap(MesoTestScene::Pattern("smooth", 24, 24), 0.1);
    this->Mapper->SetScale(0.06);
    this->Mapper->SetTiles(10., 4.);
    this->UseShape("torus");
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }
  void TearDown() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void UseMap(vtkImageData* heights, double depth)
  {
    this->Mapper->SetHeightMap(heights);
    this->Mapper->SetTable(MesoSmallVDM(heights, depth, this->GetParam()));
  }
  void UseShape(const std::string& shape)
  {
    this->Mapper->SetInputData(
      MesoTestScene::Prepared(MesoTestScene::Shape(shape), MesoTechnique::VDM));
  }
  vtkSmartPointer<vtkImageData> Picture() { return MesoGrabWindow(this->Scene.Window); }
  int Check()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }
  /// As a parallel camera sees the upper side, moved across its view.
  void LookInParallel(double across)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    camera->SetPosition(across, 3., 5.);
    camera->SetFocalPoint(across, 0., 0.);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  static bool AreEqual(vtkImageData* one, vtkImageData* other)
  {
    return MesoCompareImages(one, other, MesoImageLimits::Exact()).Within;
  }
};
}

TEST_P(VDMInvariance, ADepthUnlikeTheBakesPutsHitsOnAPlaneWhereTheyAre)
{
  // Rays of (u, v, depth) know no unit of depth: what is baked for a relief twice as deep serves, between other
  // angles.
  this->UseShape("plane");
  this->Mapper->SetTiles(4., 4.);
  this->Scene.LookFrom(0.2, -0.6, 1.);
  const auto heights = MesoTestScene::Pattern("smooth", 24, 24);
  const auto capture = [&](double depth)
  {
    this->UseMap(heights, depth);
    EXPECT_GT(this->Check(), 1000);
    return std::pair{ this->Pass->GetChannel("texcoord.u"), this->Pass->GetChannel("texcoord.v") };
  };
  const auto [u, v] = capture(0.12);
  for (const double depth : { 0.06, 0.24 })
  {
    const auto [otherU, otherV] = capture(depth);
    std::vector<double> texels;
    for (std::size_t i = 0; i < u.size(); ++i)
    {
      texels.push_back(24. * std::hypot(u[i] - otherU[i], v[i] - otherV[i]));
    }
    std::sort(texels.begin(), texels.end());
    EXPECT_LT(texels[texels.size() * 95 / 100], 0.3) << depth;
    EXPECT_GT(texels.back(), 0.) << depth;
  }
}

TEST_P(VDMInvariance, WholeTilesDoNotMatter)
{
  const auto still = this->Picture();
  vtkDataArray* coordinates = this->Mapper->GetInput()->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, coordinates->GetComponent(i, 0) + 2.);
    coordinates->SetComponent(i, 1, coordinates->GetComponent(i, 1) - 3.);
  }
  coordinates->Modified();
  this->Mapper->GetInput()->Modified();
  MesoImageLimits limits;
  limits.SmallDifference = 2;
  limits.SmallFraction = 0.01;
  limits.LargeDifference = 255;
  const auto difference = MesoCompareImages(this->Picture(), still, limits);
  EXPECT_TRUE(difference.Within) << difference.Describe();
  // And ten thousand of them give numbers.
  this->Mapper->SetTiles(1e4, 1e4);
  EXPECT_GT(this->Check(), 500);
}

TEST_P(VDMInvariance, ASlowPanEndsAPixelOn)
{
  const double pixel = 3. / Size;
  this->LookInParallel(0.);
  const auto first = this->Picture();
  auto before = first;
  constexpr int Frames = 8;
  for (int frame = 1; frame <= Frames; ++frame)
  {
    this->LookInParallel(pixel * frame / Frames);
    const auto picture = this->Picture();
    // An eighth of a pixel changes few pixels by much: nothing pops.
    MesoImageLimits limits;
    limits.SmallDifference = 100;
    limits.SmallFraction = 0.08;
    limits.LargeDifference = 255;
    const auto difference = MesoCompareImages(picture, before, limits);
    EXPECT_TRUE(difference.Within) << frame << ": " << difference.Describe();
    before = picture;
  }
  int different = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column + 1 < Size; ++column)
    {
      different += std::abs(before->GetScalarComponentAsDouble(column, row, 0, 0) -
                     first->GetScalarComponentAsDouble(column + 1, row, 0, 0)) > 8.
        ? 1
        : 0;
    }
  }
  EXPECT_LT(different, Size * Size / 50);
}

TEST_P(VDMInvariance, MatricesOfAllKindsGiveNumbers)
{
  const double matrices[][16] = {
    { -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },    // mirrored
    { 1, 0.7, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },   // sheared
    { 1, 0, 0, 0, 0, 0.2, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, 1 }, // non-uniform
    { 1, 0, 0, 0, 0, 1e-6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },  // all but flat
    { 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },     // flat
  };
  for (const auto& elements : matrices)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(elements);
    this->Scene.Actor->SetUserMatrix(matrix);
    this->Scene.Renderer->ResetCameraClippingRange();
    const int covered = this->Check();
    EXPECT_GE(covered, elements[5] > 1e-3 ? 200 : 0);
  }
}

TEST_P(VDMInvariance, NoLightManyLightsAndTheEdgeOfACone)
{
  this->Scene.Renderer->RemoveAllLights();
  EXPECT_GT(this->Check(), 500);
  this->Scene.AddHeadlight();
  EXPECT_GT(this->Check(), 500);
  const auto headlight = this->Picture();
  // A spot whose cone ends on the torus: lit within, dark beyond.
  this->Scene.Renderer->RemoveAllLights();
  vtkLight* spot = this->Scene.AddDirectionalLight(0., 0., -1.);
  spot->PositionalOn();
  spot->SetPosition(1., 3., 5.);
  spot->SetFocalPoint(1., 0., 0.);
  spot->SetConeAngle(8.);
  EXPECT_GT(this->Check(), 500);
  const auto cone = this->Picture();
  spot->SetConeAngle(80.);
  EXPECT_FALSE(AreEqual(cone, this->Picture()));
  for (int i = 0; i < 7; ++i)
  {
    this->Scene.AddDirectionalLight(std::cos(i), -1., std::sin(i));
  }
  EXPECT_GT(this->Check(), 500);
}

TEST_P(VDMInvariance, WhatChangesBetweenFramesIsSeen)
{
  const auto first = this->Picture();
  EXPECT_TRUE(AreEqual(this->Picture(), first)); // twice is the same
  this->UseMap(MesoTestScene::Pattern("brick", 24, 24), 0.1);
  const auto bricks = this->Picture();
  EXPECT_FALSE(AreEqual(bricks, first));
  this->UseShape("sphere");
  EXPECT_FALSE(AreEqual(this->Picture(), bricks));
  this->UseShape("torus");
  EXPECT_TRUE(AreEqual(this->Picture(), bricks));
  // Another table of the same map, with nothing in its factors' or numbers' place.
  this->Mapper->SetTable(MesoSmallVDM(MesoTestScene::Constant(1.f), 0.1, this->GetParam(), 8));
  EXPECT_FALSE(AreEqual(this->Picture(), bricks));
  this->UseMap(MesoTestScene::Pattern("smooth", 24, 24), 0.1);
  EXPECT_TRUE(AreEqual(this->Picture(), first));
}

TEST_P(VDMInvariance, OneMapperServesTwoActorsPointsAndLines)
{
  vtkNew<vtkActor> second;
  second->SetMapper(this->Mapper);
  second->SetPosition(0.9, 0., 0.);
  second->SetProperty(this->Scene.Actor->GetProperty());
  const int alone = this->Check();
  this->Scene.Renderer->AddActor(second);
  EXPECT_GT(this->Check(), alone + 100);
  this->Scene.Renderer->RemoveActor(second);
  const auto surface = this->Picture();
  this->Scene.Actor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_FALSE(AreEqual(this->Picture(), surface));
  this->Scene.Actor->GetProperty()->SetRepresentationToPoints();
  EXPECT_FALSE(AreEqual(this->Picture(), surface));
  this->Scene.Actor->GetProperty()->SetRepresentationToSurface();
  EXPECT_TRUE(AreEqual(this->Picture(), surface));
}

INSTANTIATE_TEST_SUITE_P(Tables, VDMInvariance, testing::Values(0, 8),
  [](const auto& info) { return std::string(info.param > 0 ? "Factors" : "Table"); });

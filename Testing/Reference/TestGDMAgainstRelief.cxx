// A height field on a plane, where rays are straight in texture space and relief of the quality certified misses
// nothing: gdm's picture of the solid below it differs by what its table says between samples, which grows
// with the angle of view; shell-sdf's by next to nothing.

#include "MesoHeightVolume.h"
#include "MesoTestScene.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoGDMTable.h"
#include "vtkMesoMovedMesh.h"
#include "vtkMesoPrismShell.h"
#include "vtkMesoReliefMapper.h"
#include "vtkMesoShellMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int Size = 96;
constexpr int Texels = 16;
constexpr double Tiles = 4.;
constexpr double Thickness = 0.25; // of a tile, as the volume of a map is deep

/// A pixel's hit: texels of the map, and heights of the relief.
struct Hits
{
  std::vector<float> Numbers; // coverage, texcoord.u, texcoord.v, relief
  float At(int pixel, int number) const { return this->Numbers[4 * std::size_t(pixel) + number]; }
};

/// How far hits are apart, at the median and at the 95th percentile, and the part of them that only one has.
struct Apart
{
  double Texels50;
  double Texels95;
  double Height95;
  double Missing;
};

class GDMAgainstRelief : public testing::Test
{
protected:
  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoAOVPass> Pass;
  vtkNew<vtkMesoReliefMapper> Relief;
  vtkNew<vtkMesoShellMapper> Shell;
  MesoMesostructureOptions Options;

  GDMAgainstRelief()
  {
    this->Scene.AddDirectionalLight(0.4, 0.3, -1.);
    const auto heights = MesoTestScene::Pattern("smooth", Texels, Texels);
    std::vector<std::string> warnings;
    const auto volume = MesoVolumeOfHeights(heights, "test", warnings);
    // The volume's ground and top keep off the shell's by 0.55 voxels of 32.
    auto* height = static_cast<float*>(heights->GetScalarPointer());
    std::transform(height, height + Texels * Texels, height,
      [](float h) { return 0.5f + (1.f - 1.1f / 32.f) * (h - 0.5f); });
    const auto plane = MesoTestScene::Shape("plane", { { "size", { Tiles, Tiles } } });
    this->Options.Scale = Thickness;
    this->Options.Tiles = { Tiles, Tiles };
    vtkNew<vtkMesoMovedMesh> moved;
    moved->SetInputData(plane);
    moved->SetDistance(Thickness);
    moved->Update();
    this->Options.Technique = MesoTechnique::Relief;
    this->Options.Quality = MesoQuality::Certified;
    this->Relief->SetOptions(this->Options);
    this->Relief->SetHeightMap(heights);
    this->Relief->SetInputData(moved->GetOutput());
    vtkNew<vtkMesoPrismShell> prisms;
    prisms->SetInputData(plane);
    prisms->SetThickness(Thickness);
    prisms->SetTiles(Tiles, Tiles);
    prisms->Update();
    vtkNew<vtkMesoGDMTable> table;
    table->SetInputData(volume);
    table->SetRank(16);
    table->SetCautious(true);
    table->Update();
    this->Shell->SetVolume(volume);
    this->Shell->SetTable(table->GetOutput());
    this->Shell->SetInputData(prisms->GetOutput());
  }

  ~GDMAgainstRelief() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Parallel rays, so many degrees off the plane's normal.
  void LookFrom(double degrees)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const double angle = degrees * 3.14159265358979 / 180.;
    camera->SetPosition(
      3. * std::sin(angle), -5. * std::sin(angle), std::hypot(3., 5.) * std::cos(angle));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., degrees == 0. ? 1. : 0., degrees == 0. ? 0. : 1.);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.6);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  Hits See(vtkMesoPolyDataMapper* mapper)
  {
    this->Scene.Actor->SetMapper(mapper);
    this->Scene.Renderer->SetPass(this->Pass);
    this->Scene.Window->Render();
    this->Scene.Renderer->SetPass(nullptr);
    return { this->Pass->GetInterleaved({ "coverage", "texcoord.u", "texcoord.v", "relief" }) };
  }

  Hits See(MesoTechnique technique, MesoQuality quality)
  {
    this->Options.Technique = technique;
    this->Options.Quality = quality;
    this->Shell->SetOptions(this->Options);
    return this->See(this->Shell);
  }

  /// Over the plane's middle, from where no ray leaves it.
  static Apart Compare(const Hits& truth, const Hits& hits)
  {
    std::vector<double> texels;
    std::vector<double> heights;
    int missing = 0;
    for (int pixel = 0; pixel < Size * Size; ++pixel)
    {
      const bool isInside = truth.At(pixel, 0) > 0.f &&
        std::abs(truth.At(pixel, 1) - 0.5f * float(Tiles)) < 1.f &&
        std::abs(truth.At(pixel, 2) - 0.5f * float(Tiles)) < 1.f;
      if (isInside && hits.At(pixel, 0) > 0.f)
      {
        texels.push_back(Texels *
          std::hypot(
            truth.At(pixel, 1) - hits.At(pixel, 1), truth.At(pixel, 2) - hits.At(pixel, 2)));
        heights.push_back(std::abs(truth.At(pixel, 3) - hits.At(pixel, 3)));
      }
      missing += isInside && !(hits.At(pixel, 0) > 0.f) ? 1 : 0;
    }
    EXPECT_GT(missing + texels.size(), 1500u);
    std::sort(texels.begin(), texels.end());
    std::sort(heights.begin(), heights.end());
    const auto at = [](const std::vector<double>& sorted, double part)
    { return sorted[static_cast<std::size_t>(part * double(sorted.size() - 1))]; };
    return { at(texels, 0.5), at(texels, 0.95), at(heights, 0.95),
      double(missing) / double(missing + texels.size()) };
  }
};
}

TEST_F(GDMAgainstRelief, OnAPlaneTheyAgreeAtEveryAngle)
{
  struct Limit
  {
    double Degrees;
    Apart Table;
  };
  // Once and a half what was measured. Along the normal both see the same texels.
  const Limit limits[] = { { 0., { 1e-4, 1e-4, 0.005, 0. } }, { 30., { 0.0035, 0.03, 0.013, 0. } },
    { 60., { 0.018, 0.125, 0.018, 0. } }, { 75., { 0.042, 0.25, 0.017, 0. } } };
  for (const auto& [degrees, limit] : limits)
  {
    this->LookFrom(degrees);
    const Hits truth = this->See(this->Relief);
    const Apart exact = Compare(truth, this->See(MesoTechnique::ShellSDF, MesoQuality::High));
    const Apart apart = Compare(truth, this->See(MesoTechnique::GDM, MesoQuality::Medium));
    const Apart bare = Compare(truth, this->See(MesoTechnique::GDM, MesoQuality::Draft));
    for (const Apart* one : { &exact, &apart, &bare })
    {
      std::cout << degrees
                << (one == &exact      ? " shell-sdf"
                       : one == &apart ? " gdm"
                                       : " look-up")
                << ": texels p50 " << one->Texels50 << ", p95 " << one->Texels95 << ", heights p95 "
                << one->Height95 << ", missing " << one->Missing << "\n";
    }
    EXPECT_LT(apart.Texels50, limit.Texels50) << degrees;
    EXPECT_LT(apart.Texels95, limit.Texels95) << degrees;
    EXPECT_LT(apart.Height95, limit.Height95) << degrees;
    EXPECT_EQ(apart.Missing, 0.) << degrees;
  }
}

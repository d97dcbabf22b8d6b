// What the technique `tessellated` costs at each quality, on a torus of 2304 triangles with bricks of
// 64 x 64 texels, 12 x 4 tiles, at 512 x 512: time to dice (the best of three), time to draw beside
// the plain mesh (interleaved), bytes on the GPU; and how far its pixels are from those of twice the
// finest quality: depth in D and map coordinate in texels, where both cover.

#include "MesoFrameCost.h"
#include "MesoTestScene.h"

#include "vtkMesoAOVPass.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoTessellatedMapper.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double Scale = 0.06;
constexpr std::array<double, 2> Tiles = { 12., 4. };
constexpr int Texels = 64;

struct Level
{
  std::string Name;
  vtkSmartPointer<vtkMesoPolyDataMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  double Seconds = 0.;
  std::vector<float> Pixels; ///< coverage, depth, u, v
};

double SecondsToDice(vtkMesoDisplacedMesh* filter)
{
  double best = 1e9;
  for (int i = 0; i < 3; ++i)
  {
    filter->Modified();
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    best = std::min(
      best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

Level MakeLevel(const std::string& name, double facets, vtkPolyData* base, vtkImageData* map)
{
  Level level;
  level.Name = name;
  if (facets > 0.)
  {
    vtkNew<vtkMesoDisplacedMesh> filter;
    filter->SetInputData(base);
    filter->SetHeightMapData(map);
    filter->SetScale(Scale);
    filter->SetTiles(Tiles[0], Tiles[1]);
    filter->SetFacetsPerTexel(facets);
    level.Seconds = SecondsToDice(filter);
    level.Mapper = vtkSmartPointer<vtkMesoTessellatedMapper>::New();
    level.Mapper->SetInputData(filter->GetOutput());
  }
  else
  {
    level.Mapper = vtkSmartPointer<vtkMesoPolyDataMapper>::New();
    level.Mapper->SetInputData(base);
  }
  level.Mapper->SetTiles(Tiles[0], Tiles[1]);
  level.Actor = vtkSmartPointer<vtkActor>::New();
  level.Actor->SetMapper(level.Mapper);
  level.Actor->GetProperty()->SetInterpolationToPhong();
  level.Actor->GetProperty()->BackfaceCullingOn();
  return level;
}

double Quantile(std::vector<double>& values, double part)
{
  if (values.empty())
  {
    return 0.;
  }
  const auto at = values.begin() + static_cast<long>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Depth and coordinate at their 95th percentiles, and the pixels that one alone covers.
void PrintDifference(const std::vector<float>& level, const std::vector<float>& finest)
{
  std::vector<double> depths;
  std::vector<double> texels;
  int alone = 0;
  for (std::size_t i = 0; i < level.size(); i += 4)
  {
    if (level[i] != finest[i])
    {
      ++alone;
    }
    else if (level[i] > 0.f)
    {
      depths.push_back(std::abs(level[i + 1] - finest[i + 1]) / Scale);
      double distance = 0.;
      for (int k = 2; k < 4; ++k)
      {
        const double tiles = level[i + k] - finest[i + k];
        distance = std::hypot(distance, Texels * (tiles - std::round(tiles)));
      }
      texels.push_back(distance);
    }
  }
  std::printf(" %10.5f %10.5f %10.4f %10.4f %7d", Quantile(depths, 0.5), Quantile(depths, 0.95),
    Quantile(texels, 0.5), Quantile(texels, 0.95), alone);
}
}

int main()
{
  MesoTestScene scene(512, 512);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.AddDirectionalLight(-1., -1.2, -1.);
  scene.LookFrom(0., 3.2, 4.8);
  const auto base = MesoTestScene::Shape("torus");
  const auto map = MesoTestScene::Pattern("brick", Texels, Texels);
  std::vector<Level> levels = { MakeLevel("plain", 0., base, map) };
  for (MesoQuality quality :
    { MesoQuality::Draft, MesoQuality::Low, MesoQuality::Medium, MesoQuality::High })
  {
    levels.push_back(MakeLevel(MesoName(quality), MesoFacetsPerTexel(quality), base, map));
  }
  levels.push_back(MakeLevel("twice high", 2. * MesoFacetsPerTexel(MesoQuality::High), base, map));

  std::vector<std::vector<vtkProp*>> groups;
  for (Level& level : levels)
  {
    scene.Renderer->AddActor(level.Actor);
    vtkNew<vtkMesoAOVPass> pass;
    scene.Renderer->SetPass(pass);
    scene.Window->Render();
    level.Pixels = pass->GetInterleaved({ "coverage", "depth", "texcoord.u", "texcoord.v" });
    scene.Renderer->SetPass(nullptr);
    pass->ReleaseGraphicsResources(scene.Window);
    scene.Renderer->RemoveActor(level.Actor);
  }
  for (Level& level : levels)
  {
    scene.Renderer->AddActor(level.Actor);
    groups.push_back({ level.Actor });
  }
  const auto costs = MesoMeasureFrames(scene.Window, groups, 2, 10);
  std::printf("%s; %s\n", scene.Window->GetGLRenderer().c_str(), costs.front().Clock.c_str());
  std::printf("%-11s %10s %8s %10s %8s %8s %10s %10s %10s %10s %7s\n", "", "triangles", "dice s",
    "draw ms", "x plain", "MB", "depth p50", "p95 (D)", "texel p50", "p95", "outline");
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    std::printf("%-11s %10lld %8.3f %10.2f %8.1f %8.2f", levels[i].Name.c_str(),
      static_cast<long long>(levels[i].Mapper->GetInput()->GetNumberOfPolys()), levels[i].Seconds,
      costs[i].Gpu.Median, costs[i].Gpu.Median / costs[0].Gpu.Median,
      static_cast<double>(levels[i].Mapper->GetGPUBytes()) / 1e6);
    PrintDifference(levels[i].Pixels, levels.back().Pixels);
    std::printf("\n");
  }
  return 0;
}

#include "BenchScaling.h"

#include "BenchAnalysis.h"
#include "BenchProgress.h"
#include "BenchTruth.h"
#include "MesoFrameCost.h"
#include "MesoSceneBuilder.h"
#include "RenderResults.h"
#include "vtkActor.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <map>

namespace
{
using Json = BenchResults::Json;

/// One drawing of the torus.
struct Setting
{
  int Width = 256;
  int Height = 192;
  int Rings = 48; ///< and half as many sides
  int MapSize = 256;
  int Lights = 1;
};

int SettingsOfSeries(const BenchSettings& settings)
{
  return settings.Quick ? 3 : 4;
}

struct Series
{
  const char* What;
  std::vector<Setting> Settings;
};

std::vector<Series> AllSeries(int numberOfSettings)
{
  std::vector<Series> series = { { "pixels", {} }, { "triangles", {} }, { "texels", {} },
    { "lights", {} } };
  for (int factor = 1; factor <= numberOfSettings; ++factor)
  {
    Setting larger;
    larger.Width = 128 * factor;
    larger.Height = 96 * factor;
    series[0].Settings.push_back(larger);
    Setting finer;
    finer.Rings = 24 << (2 * factor - 2);
    series[1].Settings.push_back(finer);
    Setting detailed;
    detailed.MapSize = 32 << (2 * factor - 2);
    series[2].Settings.push_back(detailed);
    Setting lit;
    lit.Lights = factor;
    series[3].Settings.push_back(lit);
  }
  return series;
}

MesoScene SceneOf(const Setting& setting)
{
  Json lights = Json::array();
  for (int light = 0; light < setting.Lights; ++light)
  {
    lights.push_back({ { "type", "directional" }, { "direction", { -1. + light, -1., -0.8 } },
      { "intensity", 1. / setting.Lights } });
  }
  const Json node = {
    { "mesh",
      { { "shape", "torus" }, { "rings", setting.Rings }, { "sides", setting.Rings / 2 } } },
    { "mesostructure",
      { { "technique", "relief" }, { "quality", "medium" }, { "scale", 0.06 },
        { "tiles", { 8, 3 } },
        { "height_map",
          { { "pattern", "brick" }, { "size", { setting.MapSize, setting.MapSize } } } } } }
  };
  const Json scene = { { "meso", 1 }, { "camera", { { "position", { 0, 2.2, 4 } } } },
    { "lights", lights }, { "nodes", { node } } };
  return MesoParseScene(scene.dump(), "scaling");
}

double ValueOf(const std::string& what, const Setting& setting, double covered)
{
  if (what == "pixels")
  {
    return covered;
  }
  if (what == "triangles")
  {
    return double(setting.Rings) * setting.Rings; // two for each of rings x sides
  }
  return what == "texels" ? double(setting.MapSize) * setting.MapSize : setting.Lights;
}

/// The techniques of the bench that search, and plain, the floor.
std::vector<MesoTechnique> TechniquesOf(const BenchSettings& settings)
{
  std::vector<MesoTechnique> techniques = { MesoTechnique::Plain };
  for (const BenchArm& arm : settings.Arms)
  {
    // A diced mesh grows with the map, not with what is varied here.
    if (arm.Technique != MesoTechnique::Tessellated && arm.Technique != techniques.back())
    {
      techniques.push_back(arm.Technique);
    }
  }
  return techniques;
}

/// Milliseconds of each technique, and the pixels that the torus covers.
std::vector<double> Measure(const Setting& setting, const std::vector<MesoTechnique>& techniques,
  const BenchSettings& settings, double& covered)
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(setting.Width, setting.Height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  const MesoScene scene = SceneOf(setting);
  std::vector<MesoSceneBuilder> builders(techniques.size());
  std::vector<std::vector<vtkProp*>> groups;
  for (std::size_t i = 0; i < techniques.size(); ++i)
  {
    vtkNew<vtkRenderer> apart;
    builders[i].Build(
      WithTechnique(scene, techniques[i], std::nullopt), i == 0 ? renderer.Get() : apart.Get());
    groups.emplace_back();
    for (const auto& object : builders[i].GetObjects())
    {
      renderer->AddActor(object.Actor);
      object.Actor->SetVisibility(i == 0);
      groups.back().push_back(object.Actor);
    }
  }
  vtkNew<vtkMesoAOVPass> pass;
  CaptureAOVs(renderer, builders.front(), pass);
  covered = 0.;
  for (const float value : pass->GetChannel("coverage"))
  {
    covered += value;
  }
  pass->ReleaseGraphicsResources(window);
  std::vector<double> milliseconds;
  for (const MesoFrameCost& cost :
    MesoMeasureFrames(window, groups, settings.WarmUp, settings.Runs))
  {
    milliseconds.push_back(cost.Gpu.Median);
  }
  return milliseconds;
}
}

double StepsOfScaling(const BenchSettings& settings)
{
  return 4. * SettingsOfSeries(settings);
}

std::string KeyOfScaling(const BenchSettings& settings, const std::string& device)
{
  std::string text = device + "\n" + std::to_string(settings.WarmUp) + "\n" +
    std::to_string(settings.Runs) + "\n" + MESO_VERSION + "\n" +
    std::to_string(SettingsOfSeries(settings));
  for (const MesoTechnique technique : TechniquesOf(settings))
  {
    text += std::string("\n") + MesoName(technique);
  }
  return BenchKey(text);
}

Json MeasureScaling(const BenchSettings& settings, BenchProgress& progress)
{
  const std::vector<MesoTechnique> techniques = TechniquesOf(settings);
  Json scaling = Json::array();
  for (const Series& series : AllSeries(SettingsOfSeries(settings)))
  {
    std::vector<std::vector<std::pair<double, double>>> points(techniques.size());
    for (const Setting& setting : series.Settings)
    {
      progress.Begin(std::string("scaling: ") + series.What, 1.);
      double covered = 0.;
      const std::vector<double> milliseconds = Measure(setting, techniques, settings, covered);
      for (std::size_t i = 0; i < techniques.size(); ++i)
      {
        points[i].emplace_back(ValueOf(series.What, setting, covered), milliseconds[i]);
      }
    }
    for (std::size_t i = 0; i < techniques.size(); ++i)
    {
      const auto slope = BenchSlope(points[i]);
      scaling.push_back({ { "what", series.What }, { "technique", MesoName(techniques[i]) },
        { "points", points[i] }, { "ns_per_unit", slope ? Json(1e6 * *slope) : Json() } });
    }
  }
  return scaling;
}

// What each search of a height map costs and misses: a plane under four views, with four maps, by every
// search and quality; certified beside the cheapest linear + binary search that is no worse; and how time
// grows with the map. Errors are those against the technique's own model, solved exactly. Times of a view
// are interleaved in one process, as ratios to the plain mesh.
//
//   BenchSearches [width height rounds]          everything
//   BenchSearches growth [width height rounds]   how time grows with the map alone

#include "MesoAOVs.h"
#include "MesoFrameCost.h"
#include "MesoGeometryError.h"
#include "MesoImageFile.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "MesoTechniqueModel.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoReliefMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
constexpr int MapSize = 256;

/// Maps that no pattern makes, as files in a folder of this run.
class MapFiles
{
public:
  MapFiles()
    : Folder(std::filesystem::temp_directory_path() / ("BenchSearches" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Folder);
    this->Write("spikes", [](int i, int j) { return i % 16 == 8 && j % 16 == 8 ? 1.f : 0.f; });
    this->Write("checkerboard", [](int i, int j) { return float((i + j) % 2); });
  }
  ~MapFiles() { std::filesystem::remove_all(this->Folder); }
  std::string Name(const std::string& map) const
  {
    return (this->Folder / (map + ".png")).string();
  }

private:
  template <typename HeightOf>
  void Write(const std::string& map, const HeightOf& heightOf) const
  {
    std::vector<float> heights;
    for (int row = 0; row < MapSize; ++row)
    {
      for (int column = 0; column < MapSize; ++column)
      {
        heights.push_back(heightOf(column, row));
      }
    }
    MesoWriteImage(
      this->Name(map), MapSize, MapSize, 1, MesoImageHeader::Type::UnsignedChar, heights.data());
  }

  std::filesystem::path Folder;
};

/// A plane of tiles half a unit wide, a tenth as deep, seen at an angle off its normal.
MesoScene MakeScene(const std::string& map, double degrees, const std::string& technique)
{
  const double angle = degrees * std::acos(-1.) / 180.;
  const auto number = [](double value) { return std::to_string(value); };
  const double length = std::ceil(1.2 / std::cos(angle)) + 1.;
  return MesoParseScene("{\"meso\": 1, \"camera\": {\"position\": [0, " +
      number(-10. * std::sin(angle)) + ", " + number(10. * std::cos(angle)) +
      "], \"focal_point\": [0, 0, 0], \"view_up\": [0, 1, 0.01], \"parallel_scale\": 0.5}," +
      "\"lights\": [{\"type\": \"directional\", \"direction\": [0.8, -0.7, -0.9]}]," +
      "\"nodes\": [{\"mesh\": {\"shape\": \"plane\", \"size\": [2, " + number(length) + "]}," +
      "\"mesostructure\": {\"technique\": \"" + technique + "\", \"scale\": 0.05, \"tiles\": [4, " +
      number(2. * length) + "]" +
      (technique == "plain" ? "" : ", \"effects\": [\"shading\", \"occlusion\", \"depth\"]") +
      ", \"height_map\": " + map + "}}]}",
    "scene.json");
}

std::string PatternOf(const std::string& name, int size)
{
  return "{\"pattern\": \"" + name + "\", \"size\": [" + std::to_string(size) + ", " +
    std::to_string(size) + "]}";
}

/// One way to search.
struct Arm
{
  std::string Name;
  MesoSearch Search = MesoSearch::LinearBinary;
  MesoQuality Quality = MesoQuality::Medium;
  int Linear = 0; ///< 0: as the quality says
  int Binary = 0;

  MesoSceneBuilder Builder;
  MesoErrorSpread Error;
  double Fetches = 0.;
  double MostFetches = 0.;
};

/// One view of one map.
class View
{
public:
  View(int width, int height)
    : Width(width)
    , Height(height)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
  }

  /// Adds the actors of a scene.
  void Add(MesoSceneBuilder& builder, const MesoScene& scene)
  {
    vtkNew<vtkRenderer> apart;
    builder.Build(scene, this->HasCamera ? apart.Get() : this->Renderer.Get());
    this->HasCamera = true;
    for (const auto& object : builder.GetObjects())
    {
      this->Renderer->AddActor(object.Actor);
    }
  }
  /// Adds an arm and judges it.
  void Add(Arm& arm, MesoScene scene, const MesoAOVs& model)
  {
    scene.Nodes[0].Mesostructure.Search = arm.Search;
    scene.Nodes[0].Mesostructure.Quality = arm.Quality;
    this->Add(arm.Builder, scene);
    if (arm.Linear > 0)
    {
      vtkMesoReliefMapper::SafeDownCast(arm.Builder.GetObjects()[0].Mapper)
        ->SetSearchSteps(arm.Linear, arm.Binary);
    }
    vtkNew<vtkMesoAOVPass> pass;
    pass->SetObjectNumber(arm.Builder.GetObjects()[0].Actor, 1);
    this->Renderer->SetPass(pass);
    this->Window->Render();
    this->Renderer->SetPass(nullptr);
    MesoExrImage image;
    image.Width = this->Width;
    image.Height = this->Height;
    image.ChannelNames = pass->GetChannelNames();
    image.Data = pass->GetInterleaved(image.ChannelNames);
    image.Attributes = MesoAttributesOfScene(
      arm.Builder, this->Renderer, double(this->Width) / double(this->Height));
    const std::vector<float> fetches = pass->GetInterleaved({ "fetches" });
    pass->ReleaseGraphicsResources(this->Window);
    arm.Error = MesoCompareGeometry(model, MesoAOVsOfImage(image)).Texcoord;
    for (float count : fetches)
    {
      arm.Fetches += double(count) / double(fetches.size());
      arm.MostFetches = std::max(arm.MostFetches, double(count));
    }
    this->Show(arm.Builder, false);
  }
  void Show(const MesoSceneBuilder& builder, bool visible)
  {
    for (const auto& object : builder.GetObjects())
    {
      object.Actor->SetVisibility(visible);
    }
  }
  /// Milliseconds of each: the least of its frames less the least of empty ones, which other work on the
  /// machine disturbs least.
  std::vector<double> Time(const std::vector<const MesoSceneBuilder*>& builders, int rounds)
  {
    std::vector<std::vector<vtkProp*>> groups(1);
    for (const MesoSceneBuilder* builder : builders)
    {
      groups.push_back({ builder->GetObjects()[0].Actor.Get() });
    }
    const std::vector<MesoFrameCost> costs = MesoMeasureFrames(this->Window, groups, 1, rounds);
    std::vector<double> times;
    for (std::size_t i = 1; i < costs.size(); ++i)
    {
      times.push_back(costs[i].Frame.Minimum - costs[0].Frame.Minimum);
    }
    return times;
  }
  /// The camera of MakeScene's view at an angle.
  void LookFrom(double degrees)
  {
    const double angle = degrees * std::acos(-1.) / 180.;
    this->Renderer->GetActiveCamera()->SetPosition(
      0., -10. * std::sin(angle), 10. * std::cos(angle));
    this->Renderer->ResetCameraClippingRange();
  }
  /// Mean over the pixels of a number of AOVs.
  double MeanOf(const MesoSceneBuilder& builder, const std::string& channel)
  {
    vtkNew<vtkMesoAOVPass> pass;
    this->Show(builder, true);
    pass->SetObjectNumber(builder.GetObjects()[0].Actor, 1);
    this->Renderer->SetPass(pass);
    this->Window->Render();
    this->Renderer->SetPass(nullptr);
    double sum = 0.;
    const std::vector<float> values = pass->GetInterleaved({ channel });
    for (float value : values)
    {
      sum += double(value);
    }
    pass->ReleaseGraphicsResources(this->Window);
    this->Show(builder, false);
    return sum / double(values.size());
  }
  vtkMesoEGLRenderWindow* GetWindow() { return this->Window; }
  std::string Device() { return this->Window->GetGLRenderer(); }

private:
  int Width;
  int Height;
  vtkNew<vtkMesoEGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  bool HasCamera = false;
};

std::vector<std::unique_ptr<Arm>> MakeArms()
{
  std::vector<std::unique_ptr<Arm>> arms;
  const MesoQuality qualities[] = { MesoQuality::Draft, MesoQuality::Low, MesoQuality::Medium,
    MesoQuality::High };
  for (MesoSearch search : { MesoSearch::LinearBinary, MesoSearch::LinearSecant, MesoSearch::Cone })
  {
    for (MesoQuality quality : qualities)
    {
      arms.push_back(std::make_unique<Arm>());
      arms.back()->Name = std::string(MesoName(search)) + " " + MesoName(quality);
      arms.back()->Search = search;
      arms.back()->Quality = quality;
    }
  }
  arms.push_back(std::make_unique<Arm>());
  arms.back()->Name = "certified";
  arms.back()->Search = MesoSearch::Certified;
  return arms;
}

/// The cheapest linear + binary setting that is no worse than `bound` in texels, none where all are.
std::unique_ptr<Arm> CheapestLinear(
  View& view, const MesoScene& scene, const MesoAOVs& model, double bound)
{
  for (int linear : { 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512 })
  {
    for (int binary : { 3, 5, 8 })
    {
      auto arm = std::make_unique<Arm>();
      arm->Name = std::to_string(linear) + " + " + std::to_string(binary);
      arm->Linear = linear;
      arm->Binary = binary;
      view.Add(*arm, scene, model);
      if (arm->Error.P99 <= bound)
      {
        return arm;
      }
    }
  }
  return nullptr;
}

struct Case
{
  std::string Map;
  double Degrees;
};

void MeasureCase(const Case& each, const std::string& map, int width, int height, int rounds,
  std::vector<std::string>& equal)
{
  const MesoScene scene = MakeScene(map, each.Degrees, "relief");
  const MesoAOVs model = MesoAOVsOfImage(MesoTechniqueModel(scene).Render(width, height));
  View view(width, height);
  MesoSceneBuilder plain;
  view.Add(plain, MakeScene(map, each.Degrees, "plain"));
  view.Show(plain, false);
  auto arms = MakeArms();
  for (auto& arm : arms)
  {
    view.Add(*arm, scene, model);
  }
  const double exact = arms.back()->Error.P99;
  const auto strict = CheapestLinear(view, scene, model, exact);
  const double practical = std::max(exact, 0.01);
  const auto loose = CheapestLinear(view, scene, model, practical);

  std::vector<const MesoSceneBuilder*> builders = { &plain };
  for (const auto& arm : arms)
  {
    builders.push_back(&arm->Builder);
  }
  for (const auto* arm : { strict.get(), loose.get() })
  {
    if (arm)
    {
      builders.push_back(&arm->Builder);
    }
  }
  const std::vector<double> times = view.Time(builders, rounds);
  for (std::size_t i = 0; i < arms.size(); ++i)
  {
    const Arm& arm = *arms[i];
    std::printf("%-13s %3.0f  %-22s %7.1f %5.0f %7.2f %10.6f %10.6f %10.6f %8.3f\n",
      each.Map.c_str(), each.Degrees, arm.Name.c_str(), arm.Fetches, arm.MostFetches,
      times[i + 1] / times[0], arm.Error.P50, arm.Error.P95, arm.Error.P99, arm.Error.Maximum);
  }
  const double certified = times[arms.size()] / times[0];
  std::size_t next = arms.size() + 1;
  const auto describe = [&](const Arm* arm)
  {
    char text[80];
    if (!arm)
    {
      return std::string("          none           ");
    }
    const double ratio = times[next++] / times[0];
    std::snprintf(
      text, sizeof(text), "%9s %7.2f %7.2f", arm->Name.c_str(), ratio, certified / ratio);
    return std::string(text);
  };
  char head[80];
  std::snprintf(head, sizeof(head), "%-13s %3.0f  %10.6f %7.2f  ", each.Map.c_str(), each.Degrees,
    exact, certified);
  const std::string ofStrict = describe(strict.get());
  equal.push_back(head + ofStrict + "   " + describe(loose.get()));
  std::fflush(stdout);
}

/// Processor time of all threads that a frame of each takes, ms, the least of some rounds: what does not
/// depend on what else the machine does.
std::vector<double> ProcessorTimes(vtkRenderWindow* window,
  const std::vector<std::unique_ptr<MesoSceneBuilder>>& builders, int rounds)
{
  const auto now = []
  {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
  };
  std::vector<double> least(builders.size(), HUGE_VAL);
  for (int round = 0; round <= rounds; ++round) // the first prepares
  {
    for (std::size_t i = 0; i < builders.size(); ++i)
    {
      const auto& actor = builders[i]->GetObjects()[0].Actor;
      actor->VisibilityOn();
      const double start = now();
      window->Render();
      window->WaitForCompletion();
      least[i] = round > 0 ? std::min(least[i], now() - start) : least[i];
      actor->VisibilityOff();
    }
  }
  return least;
}

/// How a frame's time grows with the map in the same views: of one map, searches and filters side by side.
/// The plane is the longest that a view needs, in all of them.
void MeasureGrowth(const std::string& map, int width, int height, int rounds)
{
  const double steepest = 85.;
  const int sizes[] = { MapSize, 16 * MapSize };
  View view(width, height);
  std::vector<std::unique_ptr<MesoSceneBuilder>> builders;
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const char* technique, MesoSearch search,
                     MesoFilter filter, int size)
  {
    MesoScene scene = MakeScene(PatternOf(map, size), steepest, technique);
    scene.Nodes[0].Mesostructure.Search = search;
    scene.Nodes[0].Mesostructure.Filter = filter;
    builders.push_back(std::make_unique<MesoSceneBuilder>());
    view.Add(*builders.back(), scene);
    view.Show(*builders.back(), false);
    names.push_back(name);
  };
  add("plain", "plain", MesoSearch::LinearBinary, MesoFilter::None, MapSize);
  for (MesoFilter filter : { MesoFilter::None, MesoFilter::Auto })
  {
    for (MesoSearch search : { MesoSearch::LinearBinary, MesoSearch::Certified })
    {
      for (int size : sizes)
      {
        add(std::string(MesoName(search)) + ", filter " + MesoName(filter), "relief", search,
          filter, size);
      }
    }
  }
  for (double degrees : { 0., 45., 75., 85. })
  {
    view.LookFrom(degrees);
    const std::vector<double> times = ProcessorTimes(view.GetWindow(), builders, rounds);
    std::vector<double> fetches;
    for (const auto& builder : builders)
    {
      fetches.push_back(view.MeanOf(*builder, "fetches"));
    }
    for (std::size_t i = 1; i + 1 < builders.size(); i += 2)
    {
      const double small = times[i] - times[0];
      const double large = times[i + 1] - times[0];
      std::printf("%-6s %3.0f  %-28s %6.1f %6.1f %7.2f   %6.1f %6.1f %6.2f\n", map.c_str(),
        degrees, names[i].c_str(), small, large, large / small, fetches[i], fetches[i + 1],
        fetches[i + 1] / fetches[i]);
    }
    std::fflush(stdout);
  }
}

void MeasureGrowth(int width, int height, int rounds)
{
  std::printf("\nFrom a map of 256 x 256 to one of 4096 x 4096: processor ms beside the plain mesh's, "
              "and samples\n%-6s %3s  %-28s %6s %6s %7s   %6s %6s %6s\n",
    "map", "deg", "search", "256", "4096", "ratio", "256", "4096", "ratio");
  for (const char* map : { "brick", "noise" })
  {
    MeasureGrowth(map, width, height, rounds);
  }
}
}

int main(int argc, char** argv)
{
  const bool growthAlone = argc > 1 && std::strcmp(argv[1], "growth") == 0;
  argc -= growthAlone ? 1 : 0;
  argv += growthAlone ? 1 : 0;
  const int width = argc > 1 ? std::atoi(argv[1]) : 240;
  const int height = argc > 2 ? std::atoi(argv[2]) : 180;
  const int rounds = argc > 3 ? std::atoi(argv[3]) : 9;
  if (growthAlone)
  {
    MeasureGrowth(width, height, rounds);
    return 0;
  }
  const MapFiles files;
  {
    View view(16, 16);
    std::printf("%s, %d x %d pixels, maps of %d x %d texels, a tile a tenth as deep as wide\n",
      view.Device().c_str(), width, height, MapSize, MapSize);
  }
  std::printf("Errors: solver_texcoord, texels. Time: ratio to the plain mesh, least of %d.\n\n"
              "%-13s %3s  %-22s %7s %5s %7s %10s %10s %10s %8s\n",
    rounds, "map", "deg", "search", "fetches", "most", "time", "p50", "p95", "p99", "worst");
  std::vector<std::string> equal;
  for (const char* map : { "brick", "spikes", "noise", "checkerboard" })
  {
    const std::string name = map;
    const bool isFile = name == "spikes" || name == "checkerboard";
    for (double degrees : { 0., 45., 75., 85. })
    {
      MeasureCase({ name, degrees },
        isFile ? "\"" + files.Name(name) + "\"" : PatternOf(name, MapSize), width, height, rounds,
        equal);
    }
  }
  std::printf("\nCertified beside the cheapest linear + binary search (8 to 512 steps, 3, 5 or 8 "
              "halvings) whose p99 is no larger\nthan its own, or than .01 texel: setting, time, "
              "certified's time over that\n\n%-13s %3s  %10s %7s  %9s %7s %7s   %9s %7s %7s\n",
    "map", "deg", "p99", "time", "as exact", "time", "ratio", ".01 texel", "time", "ratio");
  for (const std::string& line : equal)
  {
    std::printf("%s\n", line.c_str());
  }
  MeasureGrowth(width, height, rounds);
  return 0;
}

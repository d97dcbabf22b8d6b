// What a frame of vdm costs at equal error: beside the cheapest relief-quadric, its linear steps and
// halvings swept, that has no larger 95th percentile of texture coordinates, and beside the cheapest that
// has no larger error of shadows either. Times are processor time of all threads, which other work on the
// machine disturbs less than the clock: the least of ROUNDS rounds, in each of which every setting is drawn.
//
//   BenchVDMRatio WIDTH HEIGHT ROUNDS TABLE FILTER SCENE...
//
// measures the first nodes of scenes of Data/Bench, by a table of TEXELSxAZIMUTHSxPOLARS; FILTER: `none`, so
// that what is judged is the map itself, or `auto`.

#include "MesoGeometryError.h"
#include "VDMDrawn.h"
#include "vtkMesoReliefMapper.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace VDMDrawn;

/// One way to draw.
struct Arm
{
  std::string Name;
  MesoScene Scene;
  int Linear = 0; ///< steps of a search; 0: as the quality says
  int Binary = 0;
  vtkSmartPointer<vtkImageData> Table; ///< of a table's technique

  MesoGeometryError Error;
  double Fetches = 0.; ///< a covered pixel
  double MostFetches = 0.;
  double Time = 0.; ///< milliseconds
  MesoSceneBuilder Builder;

  void Set(const MesoSceneBuilder& builder) const
  {
    if (this->Table)
    {
      MapperOf(builder)->SetTable(this->Table);
    }
    auto* mapper = vtkMesoReliefMapper::SafeDownCast(builder.GetObjects()[0].Mapper);
    if (mapper && this->Linear > 0)
    {
      mapper->SetSearchSteps(this->Linear, this->Binary);
    }
  }
};

using Arms = std::vector<std::unique_ptr<Arm>>;

/// Of a scene whose filter is that of all arms.
Arm& Add(Arms& arms, const MesoScene& scene, MesoTechnique technique, MesoQuality quality,
  const std::string& name)
{
  arms.push_back(std::make_unique<Arm>());
  Arm& arm = *arms.back();
  arm.Name = name;
  arm.Scene = scene;
  arm.Scene.Nodes[0].Mesostructure.Technique = technique;
  arm.Scene.Nodes[0].Mesostructure.Quality = quality;
  return arm;
}

Arms MakeArms(const MesoScene& scene, const Size& size)
{
  Arms arms;
  Add(arms, scene, MesoTechnique::Plain, MesoQuality::Medium, "plain");
  for (const int rank : { 2, 4, 8, 12, 0 })
  {
    vtkNew<vtkMesoVDM> table;
    BakeAtSize(table, scene, size, rank);
    Arm& arm = Add(arms, scene, MesoTechnique::VDM, MesoQuality::Medium,
      rank > 0 ? "vdm " + std::to_string(rank) : "vdm full");
    arm.Scene = SceneAtRank(scene, rank);
    arm.Scene.Nodes[0].Mesostructure.Filter = scene.Nodes[0].Mesostructure.Filter;
    arm.Table = table->GetOutput();
  }
  for (const int linear : { 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32 })
  {
    for (const int binary : { 1, 2, 3, 5 })
    {
      Arm& arm = Add(arms, scene, MesoTechnique::ReliefQuadric, MesoQuality::Medium,
        std::to_string(linear) + " + " + std::to_string(binary));
      arm.Linear = linear;
      arm.Binary = binary;
    }
  }
  Add(arms, scene, MesoTechnique::ReliefQuadric, MesoQuality::Certified, "certified");
  return arms;
}

void Judge(Arm& arm, const MesoAOVs& truth, int width, int height)
{
  const MesoExrImage image = DrawnImage(
    arm.Scene, width, height, [&](const MesoSceneBuilder& builder) { arm.Set(builder); });
  const auto channelOf = [&](const char* name)
  {
    const auto& names = image.ChannelNames;
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::size_t coverage = channelOf("coverage");
  const std::size_t fetches = channelOf("fetches");
  double covered = 0.;
  for (std::size_t i = 0; i < image.Data.size(); i += image.ChannelNames.size())
  {
    covered += image.Data[i + coverage];
    arm.Fetches += image.Data[i + fetches];
    arm.MostFetches = std::max(arm.MostFetches, double(image.Data[i + fetches]));
  }
  arm.Fetches /= std::max(covered, 1.);
  arm.Error = MesoCompareGeometry(truth, MesoAOVsOfImage(image));
}

/// Milliseconds of the processor, for drawing what a renderer has.
double TimeOf(vtkRenderWindow* window, vtkRenderer* renderer)
{
  renderer->DrawOn();
  const std::clock_t start = std::clock();
  window->Render();
  window->WaitForCompletion();
  const std::clock_t end = std::clock();
  renderer->DrawOff();
  return 1e3 * double(end - start) / CLOCKS_PER_SEC;
}

/// The least of each arm's frames less the least of empty ones. A renderer each, for VTK makes the shader of
/// an actor anew that is shown and hidden.
void Time(const Arms& arms, int width, int height, int rounds)
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  const auto addRenderer = [&]
  {
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    renderer->DrawOff();
    return vtkSmartPointer<vtkRenderer>(renderer);
  };
  const vtkSmartPointer<vtkRenderer> nothing = addRenderer();
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  for (const auto& arm : arms)
  {
    renderers.push_back(addRenderer());
    arm->Builder.Build(arm->Scene, renderers.back());
    arm->Set(arm->Builder);
    TimeOf(window, renderers.back()); // builds its shader
    arm->Time = 1e9;
  }
  double empty = 1e9;
  for (int round = 0; round < rounds; ++round)
  {
    empty = std::min(empty, TimeOf(window, nothing));
    for (std::size_t i = 0; i < arms.size(); ++i)
    {
      arms[i]->Time = std::min(arms[i]->Time, TimeOf(window, renderers[i]));
    }
  }
  for (const auto& arm : arms)
  {
    arm->Time -= empty;
  }
}

void Compare(const Arms& arms)
{
  for (const auto& arm : arms)
  {
    const MesoGeometryError& error = arm->Error;
    std::printf("  %-10s %7.2f ms, look-ups %5.1f, most %3.0f, texels %6.3f / %6.3f, overlap %.4f, "
                "shadows %.4f\n",
      arm->Name.c_str(), arm->Time, arm->Fetches, arm->MostFetches, error.Texcoord.P50,
      error.Texcoord.P95, error.CoverageIou, error.ShadowCast);
  }
  for (const auto& arm : arms)
  {
    if (arm->Scene.Nodes[0].Mesostructure.Technique != MesoTechnique::VDM)
    {
      continue;
    }
    const auto cheapest = [&](bool shadows)
    {
      const Arm* found = nullptr;
      for (const auto& other : arms)
      {
        const bool searched =
          other->Scene.Nodes[0].Mesostructure.Technique == MesoTechnique::ReliefQuadric;
        if (searched && other->Error.Texcoord.P95 <= arm->Error.Texcoord.P95 &&
          (!shadows || other->Error.ShadowCast <= arm->Error.ShadowCast) &&
          (!found || other->Time < found->Time))
        {
          found = other.get();
        }
      }
      return found ? std::to_string(arm->Time / found->Time).substr(0, 5) + " of " + found->Name
                   : std::string("none");
    };
    std::printf("  %-10s at equal error: %-22s and shadows: %s\n", arm->Name.c_str(),
      cheapest(false).c_str(), cheapest(true).c_str());
  }
}
}

int main(int argc, char** argv)
{
  Size size;
  const std::string filter = argc > 5 ? argv[5] : "";
  if (argc < 7 || !size.Parse(argv[4]) || (filter != "none" && filter != "auto"))
  {
    std::fprintf(
      stderr, "BenchVDMRatio WIDTH HEIGHT ROUNDS TEXELSxAZIMUTHSxPOLARS none|auto SCENE...\n");
    return 2;
  }
  const int width = std::atoi(argv[1]);
  const int height = std::atoi(argv[2]);
  const int rounds = std::atoi(argv[3]);
  for (int i = 6; i < argc; ++i)
  {
    MesoScene scene = MesoReadScene(argv[i]);
    scene.Nodes[0].Mesostructure.Filter = filter == "auto" ? MesoFilter::Auto : MesoFilter::None;
    const Arms arms = MakeArms(scene, size);
    const MesoAOVs truth = TruthOf(scene, width, height);
    for (const auto& arm : arms)
    {
      Judge(*arm, truth, width, height);
    }
    Time(arms, width, height, rounds);
    std::printf("%s, table %s, filter %s, against the %s surface\n",
      std::filesystem::path(argv[i]).stem().c_str(), argv[4], filter.c_str(),
      HasSmoothSurface(scene) ? "smooth" : "mesh's");
    Compare(arms);
    std::fflush(stdout);
  }
  return 0;
}

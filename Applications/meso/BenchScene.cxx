#include "BenchScene.h"

#include "BenchPictures.h"
#include "BenchProgress.h"
#include "CommandLine.h"
#include "FiguresJson.h"
#include "MesoBootstrap.h"
#include "MesoFrameCost.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "RenderResults.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

namespace
{
using Json = BenchResults::Json;

constexpr double StepsOfTruth = 4.;
constexpr double StepsOfTiming = 1.; // an arm

std::string BytesOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// The bytes of all files that nodes name; a file that cannot be read is told when it is needed.
std::string BytesOfFiles(const std::vector<MesoSceneNode>& nodes)
{
  std::string bytes;
  for (const MesoSceneNode& node : nodes)
  {
    for (const std::string& name : { node.Mesh ? node.Mesh->File : "",
           node.Map ? node.Map->File : "", node.Volume ? node.Volume->File : "", node.Baked,
           node.Material.ColorMap, node.Material.NormalMap })
    {
      bytes += "\n" + (name.empty() ? "" : BytesOf(name));
    }
    bytes += BytesOfFiles(node.Children);
  }
  return bytes;
}

Json ToJson(const std::optional<MesoInterval>& interval)
{
  return interval ? Json{ interval->Low, interval->High } : Json();
}

/// All that a technique shows but one effect.
void SwitchOff(std::vector<MesoSceneNode>& nodes, MesoEffect effect)
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    options.Effects.Named = MesoEffectsOn(options).Without({ effect });
    options.Effects.Auto = false;
    SwitchOff(node.Children, effect);
  }
}

/// A truth of an earlier run; empty where its files are not there or are broken.
std::optional<MesoRendering> ReadKeptTruth(const std::string& stem)
{
  try
  {
    return ReadTruth(stem);
  }
  catch (const MesoInputError&)
  {
    return std::nullopt;
  }
}

void SetVisible(const MesoSceneBuilder& builder, bool visible)
{
  for (const auto& object : builder.GetObjects())
  {
    object.Actor->SetVisibility(visible);
  }
}

std::vector<vtkProp*> PropsOf(const MesoSceneBuilder& builder)
{
  std::vector<vtkProp*> props;
  for (const auto& object : builder.GetObjects())
  {
    props.push_back(object.Actor);
  }
  return props;
}

/// What the window shows, as a picture and as what its pixels know.
MesoRendering RenderAndCapture(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer,
  const MesoSceneBuilder& builder, vtkMesoAOVPass* pass)
{
  MesoRendering rendering;
  rendering.Picture = MesoPictureOfImage(RenderPicture(window, renderer, 1, [](double) {}));
  for (const auto& object : builder.GetObjects())
  {
    if (!object.Mapper->GetWhyPlain().empty())
    {
      throw MesoInputError("node " + std::to_string(object.Number) + " '" + object.Name +
        "': " + object.Mapper->GetWhyPlain());
    }
  }
  CaptureAOVs(renderer, builder, pass);
  MesoExrImage aovs;
  aovs.Width = pass->GetWidth();
  aovs.Height = pass->GetHeight();
  aovs.ChannelNames = pass->GetChannelNames();
  aovs.Data = pass->GetInterleaved(aovs.ChannelNames);
  aovs.Attributes =
    MesoAttributesOfScene(builder, renderer, double(aovs.Width) / double(aovs.Height));
  rendering.AOVs = MesoAOVsOfImage(aovs);
  return rendering;
}
}

BenchSurface SurfaceOfTechnique(MesoTechnique technique, bool hasSmooth)
{
  const std::string name = MesoName(technique);
  const bool models = name.rfind("relief-quadric", 0) == 0 || name == "vdm";
  return hasSmooth && models ? BenchSurface::Smooth : BenchSurface::Mesh;
}

/// An arm while it is measured.
struct BenchScene::Arm
{
  BenchArm Choice;
  MesoSceneBuilder Builder;
  double PrepareSeconds = 0.;
  Json Row;
};

BenchScene::BenchScene(
  const BenchSettings& settings, const std::string& file, const std::string& device)
  : Settings(settings)
  , File(file)
  , SceneName(std::filesystem::path(file).stem().string())
  , Device(device)
  , Scene(MesoReadScene(file))
{
  this->Content = BytesOf(file) + BytesOfFiles(this->Scene.Nodes);
  std::copy_if(settings.Arms.begin(), settings.Arms.end(), std::back_inserter(this->Arms),
    [this](const BenchArm& arm)
    { return CanDraw(this->Scene, arm.Technique, this->Settings.MapsAsVolumes); });
}

double BenchScene::Steps() const
{
  return StepsOfTruth * (HasSmoothSurface(this->Scene) ? 2. : 1.) +
    (1. + StepsOfTiming) * double(this->Arms.size() + this->AblationArms().size());
}

std::string BenchScene::KeyOfScene() const
{
  return BenchKey(this->Content + "\n" + std::to_string(this->Settings.Size[0]) + "x" +
    std::to_string(this->Settings.Size[1]) + "\n" + MESO_VERSION);
}

std::string BenchScene::KeyOfArm(const BenchArm& arm) const
{
  return BenchKey(this->KeyOfScene() + "\n" + arm.Name() + "\n" + this->Device + "\n" +
    std::to_string(this->Settings.WarmUp) + "\n" + std::to_string(this->Settings.Runs));
}

std::string BenchScene::PathOf(const std::string& name) const
{
  return this->Settings.Folder + "/" + this->SceneName + "/" + name;
}

BenchScene::Truths BenchScene::MakeTruths(BenchResults& results, BenchProgress& progress) const
{
  std::vector<BenchSurface> surfaces = { BenchSurface::Mesh };
  if (HasSmoothSurface(this->Scene))
  {
    surfaces.push_back(BenchSurface::Smooth);
  }
  const std::string key = this->KeyOfScene();
  const Json* before = results.FindScene(this->SceneName, key);
  const bool done = before && before->value("status", "") == "ok";
  Truths truths;
  Json names;
  for (const BenchSurface surface : surfaces)
  {
    const std::string stem = this->PathOf(std::string("truth-") + MesoName(surface));
    std::optional<MesoRendering> kept = done ? ReadKeptTruth(stem) : std::nullopt;
    if (kept)
    {
      progress.Skip(StepsOfTruth);
    }
    else
    {
      progress.Begin(this->SceneName + ": truth", StepsOfTruth);
      WriteTruth(this->Scene, surface, this->Settings.Size, stem);
    }
    truths.Surfaces[surface] = kept ? std::move(*kept) : ReadTruth(stem);
    names.push_back(MesoName(surface));
  }
  Json scene = { { "scene", this->SceneName }, { "file", this->File }, { "key", key },
    { "size", this->Settings.Size }, { "status", "ok" }, { "reason", nullptr }, { "truths", names },
    { "surfaces", nullptr } };
  if (truths.Surfaces.size() == 2)
  {
    scene["surfaces"] = JsonOfError(MesoCompareRenderings(
      truths.Surfaces[BenchSurface::Smooth], truths.Surfaces[BenchSurface::Mesh]));
  }
  results.SetScene(scene);
  results.Save();
  return truths;
}

Json BenchScene::StartOfRow(const BenchArm& arm) const
{
  Json row = { { "scene", this->SceneName }, { "technique", arm.TechniqueName() },
    { "quality", arm.QualityName() }, { "search", arm.SearchName() },
    { "key", this->KeyOfArm(arm) }, { "status", "ok" }, { "reason", nullptr },
    { "size", this->Settings.Size }, { "device", this->Device }, { "version", MESO_VERSION } };
  if (arm.IsAblation)
  {
    row["without"] = arm.WithoutName();
  }
  return row;
}

void BenchScene::Judge(Arm& arm, const MesoRendering& rendering, Truths& truths) const
{
  const BenchSurface judge = SurfaceOfTechnique(arm.Choice.Technique, truths.Surfaces.size() == 2);
  arm.Row["judged_by"] = MesoName(judge);
  for (const auto& truth : truths.Surfaces)
  {
    const MesoImageError error = MesoCompareRenderings(truth.second, rendering);
    arm.Row["errors"][MesoName(truth.first)] = JsonOfError(error);
    if (truth.first == judge)
    {
      const std::string name = this->SceneName + "/" + arm.Choice.Name();
      WriteStrip(*truth.second.Picture, *rendering.Picture, error,
        this->Settings.Folder + "/" + name + ".png");
      arm.Row["picture"] = name + ".png";
      if (error.Geometry->Texcoord.Count > 0)
      {
        WriteWorst(*truth.second.Picture, *rendering.Picture, error,
          this->Settings.Folder + "/" + name + "-worst.png");
        arm.Row["worst_picture"] = name + "-worst.png";
      }
    }
  }

  const MesoTechnique technique = arm.Choice.Technique;
  if (arm.Choice.IsAblation)
  {
    return; // its model would be another one
  }
  if (!truths.Models.count(technique))
  {
    truths.Models[technique] = SolveModel(this->Scene, technique, this->Settings.Size);
  }
  if (truths.Models[technique])
  {
    arm.Row["errors"]["solver"] = JsonOfError(MesoCompareRenderings(
      { "the model of " + arm.Choice.TechniqueName(), std::nullopt, truths.Models[technique] },
      { arm.Choice.Name(), std::nullopt, rendering.AOVs }));
  }
}

std::unique_ptr<BenchScene::Arm> BenchScene::Render(const BenchArm& choice,
  vtkMesoEGLRenderWindow* window, vtkRenderer* renderer, Truths& truths) const
{
  auto arm = std::make_unique<Arm>();
  arm->Choice = choice;
  arm->Row = this->StartOfRow(choice);
  vtkNew<vtkMesoAOVPass> pass;
  try
  {
    const auto start = std::chrono::steady_clock::now();
    vtkNew<vtkRenderer> apart; // which takes what a job that fails leaves
    MesoScene scene = WithTechnique(this->Scene, choice.Technique, choice.Quality, choice.Search);
    if (choice.Without)
    {
      SwitchOff(scene.Nodes, *choice.Without);
    }
    arm->Builder.Build(scene, apart);
    arm->PrepareSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const auto& object : arm->Builder.GetObjects())
    {
      renderer->AddActor(object.Actor);
    }
    if (!scene.Camera.ClippingRange)
    {
      renderer->ResetCameraClippingRange(); // as a rendering of the arm alone has it
    }
    this->Judge(*arm, RenderAndCapture(window, renderer, arm->Builder, pass), truths);
    for (const std::string channel : { "fetches", "texel_reads" })
    {
      const PixelCounts counts = CountsOfChannel(pass, channel);
      arm->Row[channel + "_mean"] = counts.Mean;
      arm->Row[channel + "_max"] = counts.Maximum;
    }
  }
  catch (const std::exception& problem)
  {
    arm->Row["status"] = "refused";
    arm->Row["reason"] = problem.what();
    for (const auto& object : arm->Builder.GetObjects())
    {
      renderer->RemoveActor(object.Actor);
    }
  }
  pass->ReleaseGraphicsResources(window);
  SetVisible(arm->Builder, false);
  return arm;
}

void BenchScene::Time(const std::vector<std::unique_ptr<Arm>>& arms, const MesoSceneBuilder& floor,
  vtkMesoEGLRenderWindow* window) const
{
  std::vector<std::vector<vtkProp*>> groups = { PropsOf(floor) };
  for (const auto& arm : arms)
  {
    groups.push_back(PropsOf(arm->Builder));
  }
  const std::vector<MesoFrameCost> costs =
    MesoMeasureFrames(window, groups, this->Settings.WarmUp, this->Settings.Runs);
  const double floorMilliseconds = costs.front().Gpu.Median;
  for (std::size_t i = 0; i < arms.size(); ++i)
  {
    const MesoFrameCost& cost = costs[i + 1];
    const SceneSize size = SizeOfScene(arms[i]->Builder);
    Json& row = arms[i]->Row;
    row["gpu_ms"] = JsonOfMilliseconds(cost.Gpu);
    row["frame_ms"] = JsonOfMilliseconds(cost.Frame);
    row["gpu_ms"]["interval"] = ToJson(MesoMedianInterval(cost.GpuRounds));
    row["ratio_to_floor"] =
      floorMilliseconds > 0. ? Json(cost.Gpu.Median / floorMilliseconds) : Json();
    row["ratio_interval"] = ToJson(MesoRatioInterval(cost.GpuRounds, costs.front().GpuRounds));
    row["clock"] = cost.Clock;
    row["runs"] = cost.Runs;
    row["gpu_bytes"] = size.GpuBytes;
    row["prepare_s"] = arms[i]->PrepareSeconds;
    row["triangles"] = size.Triangles;
  }
}

bool BenchScene::Run(BenchResults& results, BenchProgress& progress) const
{
  Truths truths;
  try
  {
    std::error_code problem; // of a folder that cannot be made, the files' own messages tell
    std::filesystem::create_directories(this->PathOf(""), problem);
    truths = this->MakeTruths(results, progress);
  }
  catch (const std::exception& problem) // memory and the ray tracer's own as well: the others go on
  {
    results.SetScene({ { "scene", this->SceneName }, { "file", this->File },
      { "key", this->KeyOfScene() }, { "size", this->Settings.Size }, { "status", "failed" },
      { "reason", problem.what() }, { "truths", Json::array() }, { "surfaces", nullptr } });
    results.Save();
    return false;
  }

  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(this->Settings.Size[0], this->Settings.Size[1]);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  MesoSceneBuilder floor; // gives the renderer its lights and camera as well
  floor.Build(WithTechnique(this->Scene, MesoTechnique::Plain, std::nullopt), renderer);
  SetVisible(floor, false);

  this->RunArms(this->Arms, floor, window, renderer, truths, results, progress);
  this->RunArms(this->AblationArms(), floor, window, renderer, truths, results, progress);
  results.Save();
  return true;
}

std::vector<BenchArm> BenchScene::AblationArms() const
{
  if (!this->Settings.Ablation)
  {
    return {};
  }
  // One quality of each technique tells the effects' shares: medium, else the last there is.
  std::map<MesoTechnique, BenchArm> chosen;
  for (const BenchArm& choice : this->Arms)
  {
    const auto before = chosen.find(choice.Technique);
    if (choice.Quality && (before == chosen.end() || before->second.Quality != MesoQuality::Medium))
    {
      chosen[choice.Technique] = choice;
    }
  }
  std::vector<BenchArm> arms;
  for (const auto& choice : chosen)
  {
    BenchArm arm = choice.second;
    arm.IsAblation = true;
    arms.push_back(arm);
    for (const std::string& name : MesoEffectsOfTechnique(arm.Technique).Names())
    {
      arm.Without = MesoEffectFromName(name);
      arms.push_back(arm);
    }
  }
  return arms;
}

void BenchScene::RunArms(const std::vector<BenchArm>& choices, const MesoSceneBuilder& floor,
  vtkMesoEGLRenderWindow* window, vtkRenderer* renderer, Truths& truths, BenchResults& results,
  BenchProgress& progress) const
{
  std::vector<std::unique_ptr<Arm>> arms; // to be timed
  for (const BenchArm& choice : choices)
  {
    if (results.FindRow(this->KeyOfArm(choice)))
    {
      progress.Skip(1. + StepsOfTiming);
      continue;
    }
    progress.Begin(this->SceneName + ": " + choice.Name(), 1.);
    auto arm = this->Render(choice, window, renderer, truths);
    if (arm->Row["status"] == "ok")
    {
      arms.push_back(std::move(arm));
      continue;
    }
    results.SetRow(arm->Row);
    progress.Skip(StepsOfTiming);
  }
  if (!arms.empty())
  {
    progress.Begin(this->SceneName + ": timing", StepsOfTiming * double(arms.size()));
    this->Time(arms, floor, window);
    SetVisible(floor, false); // timing leaves all visible
    for (const auto& arm : arms)
    {
      results.SetRow(arm->Row);
      for (const auto& object : arm->Builder.GetObjects())
      {
        renderer->RemoveActor(object.Actor);
      }
    }
  }
}

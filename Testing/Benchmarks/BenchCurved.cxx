// The curved bases of relief mapping: what their outlines, texture coordinates and depths are worth
// against the displaced mesh itself, and what a frame costs beside VTK's own mapper on a displaced mesh
// of 100000 triangles, interleaved in one process.
//
//   BenchCurved distances the report's Figure 10, as CSV: equation 6, equation 7 and the distance to the
//                         quadric along its own normals, over the true depth below a cylinder
//   BenchCurved shapes    every base on round, hollow and saddle-shaped bases in three tessellations
//   BenchCurved depths    a torus whose relief goes deeper and deeper
//   BenchCurved overlap   the torus of 8 x 3 tiles, 512 x 512: every base and VTK's mesh against the truth
//   BenchCurved time      what a frame of it costs

#include "DrawnAOVs.h"
#include "MesoFrameCost.h"
#include "MesoGeometryError.h"
#include "MesoKernels.h"
#include "MesoReference.h"
#include "MesoTestScene.h"
#include "QuadricDistances.h"

#include "vtkMesoReliefMapper.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace
{
struct Base
{
  const char* Name;
  const char* Keys; ///< of the scene
};

const Base Bases[] = {
  { "relief", R"("technique": "relief")" },
  { "relief-quadric", R"("technique": "relief-quadric")" },
  { "relief-quadric-exact", R"("technique": "relief-quadric-exact")" },
  { "osculating", R"("technique": "relief-quadric", "curved": "osculating")" },
  { "bent", R"("technique": "relief-quadric", "curved": "bent")" },
  { "surface", R"("technique": "relief-quadric", "curved": "surface")" },
};

struct Shape
{
  const char* Name;
  const char* Mesh;
  const char* Camera;
  const char* Relief;    ///< scale and tiles
  bool HasSmooth = true; ///< a closed form
};

const Shape Shapes[] = {
  { "cylinder, seen across its axis",
    R"({"shape": "cylinder", "sides": 48, "rings": 12, "radius": 0.5, "height": 1.6})",
    R"({"position": [3.2, 0.6, 0], "focal_point": [0, 0, 0], "view_up": [0, 1, 0], "view_angle": 34})",
    R"("scale": 0.06, "tiles": [6, 3])" },
  { "cylinder, seen along its axis",
    R"({"shape": "cylinder", "sides": 48, "rings": 12, "radius": 0.5, "height": 1.6})",
    R"({"position": [0.9, 3.0, 0], "focal_point": [0, 0, 0], "view_up": [1, 0, 0], "view_angle": 34})",
    R"("scale": 0.06, "tiles": [6, 3])" },
  { "sphere", R"({"shape": "sphere", "rings": 32, "sides": 64})",
    R"({"position": [0, 1.0, 3.6], "focal_point": [0, 0, 0], "view_up": [0, 1, 0], "view_angle": 34})",
    R"("scale": 0.1, "tiles": [8, 4])" },
  { "torus from outside", R"({"shape": "torus", "rings": 80, "sides": 30})",
    R"({"position": [0, 2.4, 2.6], "focal_point": [0, 0, 0], "view_up": [0, 1, 0], "view_angle": 44})",
    R"("scale": 0.12, "tiles": [8, 3])" },
  { "torus from inside", R"({"shape": "torus", "rings": 80, "sides": 30})",
    R"({"position": [0, 0.7, 0.2], "focal_point": [0, 0, -0.6], "view_up": [0, 1, 0], "view_angle": 60})",
    R"("scale": 0.12, "tiles": [8, 3])" },
  { "saddle", "a file", // SaddleFile
    R"({"position": [0, -3.4, 1.5], "focal_point": [0, 0, 0], "view_up": [0, 0, 1], "view_angle": 34})",
    R"("scale": 0.08, "tiles": [4, 4])", false },
  { "teapot", R"({"shape": "teapot", "segments": 8})",
    R"({"position": [0.8, 2.4, 4.4], "focal_point": [0.1, 0.6, 0], "view_up": [0, 1, 0], "view_angle": 32})",
    R"("scale": 0.03, "tiles": [2, 2])", false },
};

/// Rays that enter a cylinder of radius 1 at some angles to its normal.
void MeasureDistances()
{
  std::printf("degrees,true_depth,equation_6,equation_7,normal_distance\n");
  for (const double degrees :
    { 0.1, 0.5, 1., 2., 5., 10., 20., 30., 40., 50., 60., 70., 75., 80., 85., 88., 89. })
  {
    const QuadricDistances at = DistancesAt(degrees);
    std::printf("%g,%.6f,%.4f,%.4f,%.4f\n", degrees, at.Depth, at.Across, at.Along, at.Normal);
  }
}

MesoScene SceneOf(const std::string& mesh, const std::string& camera, const std::string& relief,
  const std::string& technique, const std::string& quality = "high")
{
  const std::string text = R"({ "meso": 1, "camera": )" + camera +
    R"(, "lights": [{"type": "directional", "direction": [-0.5, -0.8, -0.6]}],
    "nodes": [{"mesh": )" +
    mesh + R"(, "mesostructure": {)" + technique + ", " + relief + R"(, "quality": ")" + quality +
    R"(", "height_map": {"pattern": "smooth", "size": [256, 256]}}}] })";
  return MesoParseScene(text, "bench.json");
}

MesoAOVs TruthOf(const MesoScene& scene, int size, MesoReference::Surface surface)
{
  return MesoAOVsOfImage(MesoReference(scene, surface).Render(size, size).AOVs);
}

/// smooth: null where the shape has no closed form.
void PrintErrors(
  const char* name, const MesoAOVs& mesh, const MesoAOVs* smooth, const MesoScene& scene, int size)
{
  const MesoAOVs drawn = DrawnAOVs(scene, size, size);
  const MesoGeometryError error = MesoCompareGeometry(mesh, drawn);
  std::printf("%-22s %8.4f %8.2f %8.3f %8.3f %8.4f %6zu", name, error.CoverageIou,
    error.SilhouetteMean, error.Texcoord.P50, error.Texcoord.P95, error.Depth.P95,
    error.HolePixels);
  if (smooth)
  {
    const MesoGeometryError toSmooth = MesoCompareGeometry(*smooth, drawn);
    std::printf(" %10.4f %8.3f", toSmooth.CoverageIou, toSmooth.Texcoord.P95);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void PrintHead()
{
  std::printf("%-22s %8s %8s %8s %8s %8s %6s %10s %8s\n", "base", "IoU", "edge px", "tex p50",
    "tex p95", "depth95", "holes", "smooth IoU", "tex p95");
}

/// A built-in shape's mesh with its numbers of rings, sides and segments times a factor.
std::string Finer(const std::string& mesh, double factor)
{
  std::string finer = mesh;
  for (const std::string key : { "\"rings\": ", "\"sides\": ", "\"segments\": " })
  {
    const std::size_t found = finer.find(key);
    if (found != std::string::npos)
    {
      const std::size_t from = found + key.size();
      const std::size_t to = finer.find_first_of(",}", from);
      const int count = std::stoi(finer.substr(from, to - from));
      finer.replace(from, to - from, std::to_string(std::lround(factor * count)));
    }
  }
  return finer;
}

/// A file of the saddle z = 0.4 (x^2 - y^2) over [-1, 1]^2 in n x n cells of two triangles; its name.
std::string SaddleFile(int n)
{
  const std::string name =
    (std::filesystem::temp_directory_path() / ("meso-saddle-" + std::to_string(n) + ".obj"))
      .string();
  std::ofstream file(name);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double x = 2. * i / n - 1.;
      const double y = 2. * j / n - 1.;
      file << "v " << x << " " << y << " " << 0.4 * (x * x - y * y) << "\nvt " << double(i) / n
           << " " << double(j) / n << "\n";
    }
  }
  const auto corner = [&](int i, int j)
  {
    const std::string id = std::to_string(i * (n + 1) + j + 1);
    return " " + id + "/" + id;
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      file << "f" << corner(i, j) << corner(i + 1, j) << corner(i + 1, j + 1) << "\n";
      file << "f" << corner(i, j) << corner(i + 1, j + 1) << corner(i, j + 1) << "\n";
    }
  }
  return name;
}

/// The mesh of a shape in one of three tessellations, each twice as fine as the one before; 1 is its own.
std::string TessellationOf(const Shape& shape, int level)
{
  return shape.Mesh[0] == '{' ? Finer(shape.Mesh, 0.5 * (1 << level))
                              : "\"" + SaddleFile(16 << level) + "\"";
}

void MeasureShapes()
{
  constexpr int size = 320;
  const char* const levels[] = { "half as fine", "as it is", "twice as fine" };
  for (const Shape& shape : Shapes)
  {
    for (int level = 0; level < 3; ++level)
    {
      const std::string base = TessellationOf(shape, level);
      const MesoScene scene = SceneOf(base, shape.Camera, shape.Relief, Bases[0].Keys);
      const MesoAOVs mesh = TruthOf(scene, size, MesoReference::Surface::Mesh);
      const MesoAOVs smooth =
        shape.HasSmooth ? TruthOf(scene, size, MesoReference::Surface::Smooth) : mesh;
      std::printf("%s, %s\n", shape.Name, levels[level]);
      PrintHead();
      for (const Base& way : Bases)
      {
        PrintErrors(way.Name, mesh, shape.HasSmooth ? &smooth : nullptr,
          SceneOf(base, shape.Camera, shape.Relief, way.Keys), size);
      }
      std::printf("\n");
    }
  }
}

void MeasureDepths()
{
  constexpr int size = 320;
  const Shape& shape = Shapes[3];
  for (const double part : { 0.03, 0.075, 0.15, 0.3, 0.5 }) // of the tube's radius
  {
    const std::string relief = "\"scale\": " + std::to_string(0.4 * part) + R"(, "tiles": [8, 3])";
    const MesoScene scene = SceneOf(shape.Mesh, shape.Camera, relief, Bases[0].Keys);
    const MesoAOVs mesh = TruthOf(scene, size, MesoReference::Surface::Mesh);
    const MesoAOVs smooth = TruthOf(scene, size, MesoReference::Surface::Smooth);
    std::printf("torus from outside, D c_max = %g\n", part);
    PrintHead();
    for (const Base& base : Bases)
    {
      PrintErrors(
        base.Name, mesh, &smooth, SceneOf(shape.Mesh, shape.Camera, relief, base.Keys), size);
    }
    std::printf("\n");
  }
}

/// The torus, cut finely and displaced point by point: VTK's own way.
vtkSmartPointer<vtkPolyData> WarpedTorus(vtkImageData* heights, double scale)
{
  const auto torus =
    MesoTestScene::Shape("torus", { { "rings", { 320. } }, { "sides", { 160. } } });
  int size[3];
  heights->GetDimensions(size);
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  const MesoKernels::Double::HeightField field(size[0], size[1], MesoWrap::Repeat,
    std::vector<float>(values, values + std::size_t(size[0]) * std::size_t(size[1])));
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double n[3];
    double uv[2];
    torus->GetPoint(i, p);
    torus->GetPointData()->GetNormals()->GetTuple(i, n);
    torus->GetPointData()->GetTCoords()->GetTuple(i, uv);
    const double depth = scale * (1. - field.bilinearHeight({ 8. * uv[0], 3. * uv[1] }));
    points->InsertNextPoint(p[0] - depth * n[0], p[1] - depth * n[1], p[2] - depth * n[2]);
  }
  auto warped = vtkSmartPointer<vtkPolyData>::New();
  warped->DeepCopy(torus);
  warped->SetPoints(points);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(warped);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

/// A mesh of triangles as a file; its name.
std::string FileOf(vtkPolyData* mesh)
{
  const std::string name =
    (std::filesystem::temp_directory_path() / "meso-warped-torus.obj").string();
  std::ofstream file(name);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    file << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  vtkIdType count;
  const vtkIdType* corners;
  for (mesh->GetPolys()->InitTraversal(); mesh->GetPolys()->GetNextCell(count, corners);)
  {
    file << "f " << corners[0] + 1 << " " << corners[1] + 1 << " " << corners[2] + 1 << "\n";
  }
  return name;
}

void MeasureOverlap()
{
  constexpr int size = 512;
  const Shape& shape = Shapes[3];
  const auto sceneOf = [&](const std::string& technique, const std::string& quality)
  { return SceneOf(shape.Mesh, shape.Camera, shape.Relief, technique, quality); };
  const MesoScene scene = sceneOf(Bases[0].Keys, "medium");
  const MesoAOVs mesh = TruthOf(scene, size, MesoReference::Surface::Mesh);
  const MesoAOVs smooth = TruthOf(scene, size, MesoReference::Surface::Smooth);
  for (const char* quality : { "draft", "medium" })
  {
    std::printf("torus from outside, D c_max = 0.3, %d x %d, %s\n", size, size, quality);
    PrintHead();
    for (const Base& base : Bases)
    {
      PrintErrors(base.Name, mesh, &smooth, sceneOf(base.Keys, quality), size);
    }
    std::printf("\n");
  }
  // Places and depths are of no relief here: the outline alone says something.
  const std::string file = FileOf(WarpedTorus(MesoTestScene::Pattern("smooth", 256, 256), 0.12));
  const MesoScene warped =
    SceneOf("\"" + file + "\"", shape.Camera, shape.Relief, R"("technique": "plain")", "medium");
  PrintErrors("VTK, 102400 triangles", mesh, &smooth, warped, size);
}

/// Processor time of all threads that a frame of each group takes, ms, the least of some frames:
/// what does not depend on what else the machine does.
std::vector<double> ProcessorTimes(
  vtkRenderWindow* window, const std::vector<std::vector<vtkProp*>>& groups)
{
  const auto now = []
  {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
  };
  std::vector<double> least(groups.size(), HUGE_VAL);
  for (int round = 0; round < 6; ++round)
  {
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
      for (std::size_t k = 0; k < groups.size(); ++k)
      {
        groups[k].front()->SetVisibility(k == i);
      }
      const double start = now();
      window->Render();
      window->WaitForCompletion();
      least[i] = std::min(least[i], now() - start);
    }
  }
  return least;
}

void MeasureTime()
{
  MesoTestScene scene(512, 512);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.AddDirectionalLight(-0.5, -0.8, -0.6);
  scene.LookFrom(0., 2.4, 2.6, 44.);
  const auto map = MesoTestScene::Pattern("smooth", 256, 256);
  std::vector<std::string> names;
  std::vector<std::vector<vtkProp*>> groups;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  const auto add = [&](const std::string& name, vtkPolyDataMapper* mapper)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->GetProperty()->DeepCopy(scene.Actor->GetProperty());
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    actors.push_back(actor);
    groups.push_back({ actor });
    names.push_back(name);
  };
  vtkNew<vtkPolyDataMapper> warped;
  warped->SetInputData(WarpedTorus(map, 0.12));
  warped->ScalarVisibilityOff();
  add("VTK, 102400 triangles", warped);
  const auto torus = MesoTestScene::Prepared(
    MesoTestScene::Shape("torus", { { "rings", { 80. } }, { "sides", { 30. } } }),
    MesoTechnique::ReliefQuadric);
  const auto image = MesoTestScene::BaseImage(torus);
  vtkNew<vtkPolyDataMapper> coarse;
  coarse->SetInputData(torus);
  coarse->ScalarVisibilityOff();
  add("VTK, 4800 triangles, no relief", coarse);
  struct Setting
  {
    const char* Name;
    MesoTechnique Technique;
    MesoCurvedKind Curved;
    MesoQuality Quality;
    MesoSearch Search = MesoSearch::LinearBinary;
    std::array<int, 2> Steps = { 0, 0 }; ///< in place of the quality's
    bool Occlusion = true;
    MesoFilter Filter = MesoFilter::Auto;
  };
  const Setting settings[] = {
    { "relief-quadric draft", MesoTechnique::ReliefQuadric, MesoCurvedKind::Quadric,
      MesoQuality::Draft },
    { "relief-quadric medium", MesoTechnique::ReliefQuadric, MesoCurvedKind::Quadric,
      MesoQuality::Medium },
    { "relief-quadric-exact draft", MesoTechnique::ReliefQuadricExact, MesoCurvedKind::Quadric,
      MesoQuality::Draft },
    { "relief-quadric-exact medium", MesoTechnique::ReliefQuadricExact, MesoCurvedKind::Quadric,
      MesoQuality::Medium },
    { "osculating draft", MesoTechnique::ReliefQuadric, MesoCurvedKind::Osculating,
      MesoQuality::Draft },
    { "bent draft", MesoTechnique::ReliefQuadric, MesoCurvedKind::Bent, MesoQuality::Draft },
    { "surface draft", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface, MesoQuality::Draft },
    { "surface low", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface, MesoQuality::Low },
    { "surface medium", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Medium },
    { "surface cone draft", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Draft, MesoSearch::Cone },
    { "surface cone medium", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Medium, MesoSearch::Cone },
    { "surface cone high", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface, MesoQuality::High,
      MesoSearch::Cone },
    { "surface, bumps alone", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Draft, MesoSearch::LinearBinary, { 0, 0 }, false },
    { "surface, 1 step", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface, MesoQuality::Draft,
      MesoSearch::LinearBinary, { 1, 0 } },
    { "surface, 16 steps", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Draft, MesoSearch::LinearBinary, { 16, 0 } },
    { "surface draft, no filter", MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface,
      MesoQuality::Draft, MesoSearch::LinearBinary, { 0, 0 }, true, MesoFilter::None },
  };
  for (const Setting& setting : settings)
  {
    vtkNew<vtkMesoReliefMapper> relief;
    MesoMesostructureOptions options;
    options.Technique = setting.Technique;
    options.Curved = setting.Curved;
    options.Quality = setting.Quality;
    options.Search = setting.Search;
    options.Scale = 0.12;
    options.Tiles = { 8., 3. };
    options.Effects.Auto = false; // VTK's mesh shades nothing but itself
    options.Filter = setting.Filter;
    options.Effects.Named =
      MesoEffectsOfTechnique(setting.Technique).Without({ MesoEffect::SelfShadow });
    if (!setting.Occlusion)
    {
      options.Effects.Named = options.Effects.Named.Without(
        { MesoEffect::Occlusion, MesoEffect::Depth, MesoEffect::Silhouette });
    }
    relief->SetSearchSteps(setting.Steps[0], setting.Steps[1]);
    relief->SetOptions(options);
    relief->SetHeightMap(map);
    relief->SetBaseImage(image);
    relief->SetInputData(torus);
    add(setting.Name, relief);
  }
  const auto costs = MesoMeasureFrames(scene.Window, groups, 2, 8);
  const auto processor = ProcessorTimes(scene.Window, groups);
  std::printf("torus, 8 x 3 tiles, D = 0.12, 512 x 512, without self-shadow\n%s; %s\n",
    scene.Window->GetGLRenderer().c_str(), costs.front().Clock.c_str());
  std::printf("%-30s %10s %10s %10s %8s %12s %8s\n", "", "median ms", "min", "max", "ratio",
    "processor ms", "ratio");
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::printf("%-30s %10.2f %10.2f %10.2f %8.2f %12.1f %8.2f\n", names[i].c_str(),
      costs[i].Gpu.Median, costs[i].Gpu.Minimum, costs[i].Gpu.Maximum,
      costs[i].Gpu.Minimum / costs[0].Gpu.Minimum, processor[i], processor[i] / processor[0]);
  }
}
}

int main(int argc, char* argv[])
{
  const char* what = argc > 1 ? argv[1] : "";
  if (std::strcmp(what, "distances") == 0)
  {
    MeasureDistances();
  }
  else if (std::strcmp(what, "shapes") == 0)
  {
    MeasureShapes();
  }
  else if (std::strcmp(what, "depths") == 0)
  {
    MeasureDepths();
  }
  else if (std::strcmp(what, "overlap") == 0)
  {
    MeasureOverlap();
  }
  else if (std::strcmp(what, "time") == 0)
  {
    MeasureTime();
  }
  else
  {
    std::fprintf(stderr, "Usage: BenchCurved distances | shapes | depths | overlap | time\n");
    return 2;
  }
  return 0;
}

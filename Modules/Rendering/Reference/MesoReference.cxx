#include "MesoReference.h"

#include "MesoReferenceLighting.h"
#include "MesoReferenceTracer.h"
#include "MesoSampling.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace
{
const char* const Channels[] = { "coverage", "depth", "texcoord.u", "texcoord.v", "relief",
  "normal.x", "normal.y", "normal.z", "object", "fetches", "texel_reads", "iterations" };
constexpr int NumberOfChannels = 12;

void CollectMeshes(const std::vector<MesoSceneNode>& nodes, std::vector<MesoSceneMesh>& meshes)
{
  for (const MesoSceneNode& node : nodes)
  {
    meshes.push_back(node.Mesh.value_or(MesoSceneMesh()));
    CollectMeshes(node.Children, meshes);
  }
}

/// A closed form is of the whole shape.
void RefuseParts(const std::vector<MesoSceneNode>& nodes)
{
  for (const MesoSceneNode& node : nodes)
  {
    if (node.Part)
    {
      throw MesoInputError("node '" + node.Name +
        "': the surface 'smooth' is that of a whole shape, and this is a part of one");
    }
    RefuseParts(node.Children);
  }
}

/// All that detail does, whatever the nodes' techniques show of it; and their base meshes, where a
/// technique would dice them.
void ShowAllDetail(std::vector<MesoSceneNode>& nodes)
{
  for (MesoSceneNode& node : nodes)
  {
    if (MesoUsesHeightMap(node.Mesostructure.Technique))
    {
      node.Mesostructure.Technique = MesoTechnique::Relief;
      node.Mesostructure.Effects = MesoEffectChoice();
    }
    if (MesoUsesVolume(node.Mesostructure.Technique))
    {
      node.Mesostructure.Technique = MesoTechnique::ShellSDF;
      node.Mesostructure.Effects = MesoEffectChoice();
    }
    ShowAllDetail(node.Children);
  }
}

/// What of an object's looks the reference does not show; empty where it shows them all.
std::string NotShown(const MesoSceneBuilder::Object& object)
{
  if (object.Actor->GetProperty()->GetEdgeVisibility())
  {
    return "edges";
  }
  if (object.Actor->GetProperty()->GetOpacity() < 1.)
  {
    return "translucent nodes";
  }
  if (object.Mapper->GetScalarVisibility() || object.Mapper->GetHeightColors())
  {
    return "colors by arrays or heights (color_by)";
  }
  if (!object.Mapper->GetContourLines().Empty())
  {
    return "contour lines (contours)";
  }
  return {};
}

double SecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}

struct MesoReference::Implementation
{
  /// A pixel's place and what is found there.
  struct Sample
  {
    glm::dvec3 Color;
    bool Hit = false;
    MesoReferenceHit At;
    MesoReferencePoint Point;
    glm::dvec3 Place; ///< in the world
    bool MeetsBase = false;
  };

  MesoReferenceCamera Camera;
  glm::dvec3 Background;
  std::vector<MesoReferenceLight> Lights;
  std::vector<std::unique_ptr<MesoReferenceSurface>> Surfaces;
  std::vector<MesoReferenceMaterial> Materials;
  std::vector<int> Numbers; ///< of the nodes
  std::unique_ptr<MesoReferenceTracer> Tracer;
  MesoSceneBuilder Builder;
  vtkNew<vtkRenderer> Renderer; ///< never rendered: it holds lights and camera
  std::vector<std::string> Warnings;
  double PrepareSeconds = 0.;

  explicit Implementation(const MesoScene& scene)
    : Camera(scene.Camera)
    , Background(scene.Background[0], scene.Background[1], scene.Background[2])
  {
  }

  /// What is seen at a place of the picture, without bounced light.
  Sample Look(double x, double y, double aspect, bool shadowsOnPlain, std::vector<double>& blocked,
    MesoTraceWork& work) const;
  /// Light that reaches a sample's point over `bounces` diffuse surfaces, along one path whose first
  /// direction is that of two numbers in [0,1).
  glm::dvec3 Bounced(const Sample& sample, int bounces, const glm::dvec2& first, MesoRandom random,
    std::vector<double>& blocked, MesoTraceWork& work) const;
  void FindBlocked(const Sample& sample, const glm::dvec3& place, std::vector<double>& blocked,
    MesoTraceWork& work) const;
  /// Of the shadows on a plain node those that its techniques show: none where it is alone, and where
  /// it turns away from a light the shading normal decides.
  std::vector<double> CastOn(const Sample& sample, const std::vector<double>& blocked) const;
  void Fill(const Sample& sample, const std::vector<double>& blocked, float* values) const;
};

MesoReference::MesoReference(const MesoScene& scene, Surface surface, double facetsPerTexel)
  : Inside(std::make_unique<Implementation>(scene))
{
  const auto start = std::chrono::steady_clock::now();
  if (surface == Surface::Smooth)
  {
    RefuseParts(scene.Nodes);
  }
  Implementation& inside = *this->Inside;
  // The builder reads files and resolves matrices; nothing is rendered, so no context is made.
  MesoSceneBuilder& builder = inside.Builder;
  MesoScene truth = scene;
  ShowAllDetail(truth.Nodes);
  builder.Build(truth, inside.Renderer);
  inside.Renderer->UpdateLightsGeometryToFollowCamera();
  inside.Warnings = builder.GetWarnings();
  for (const MesoSceneLight& light : scene.Lights)
  {
    inside.Lights.emplace_back(light, inside.Camera);
  }
  std::vector<MesoSceneMesh> meshes;
  CollectMeshes(scene.Nodes, meshes);
  for (const MesoSceneBuilder::Object& object : builder.GetObjects())
  {
    const std::string notShown = NotShown(object);
    if (!notShown.empty())
    {
      throw MesoInputError("node " + std::to_string(object.Number) + " '" + object.Name +
        "': the reference does not show " + notShown);
    }
    inside.Surfaces.push_back(std::make_unique<MesoReferenceSurface>(
      object, meshes[object.Number - 1], surface == Surface::Smooth));
    inside.Materials.emplace_back(object.Actor, object.Options.Wrap);
    inside.Numbers.push_back(object.Number);
    if (inside.Surfaces.back()->NumberOfDegenerateTriangles() > 0)
    {
      inside.Warnings.push_back("node " + std::to_string(object.Number) + " '" + object.Name +
        "': " + std::to_string(inside.Surfaces.back()->NumberOfDegenerateTriangles()) +
        " triangles have no area in texture coordinates and are displaced evenly");
    }
  }
  inside.Tracer = std::make_unique<MesoReferenceTracer>(inside.Surfaces, facetsPerTexel);
  for (const MesoSceneClippingPlane& plane : scene.ClippingPlanes)
  {
    inside.Tracer->AddClippingPlane({ plane.Point[0], plane.Point[1], plane.Point[2] },
      { plane.Normal[0], plane.Normal[1], plane.Normal[2] });
  }
  inside.PrepareSeconds = SecondsSince(start);
}

MesoReference::~MesoReference() = default;

const std::vector<std::string>& MesoReference::GetWarnings() const
{
  return this->Inside->Warnings;
}

void MesoReference::Implementation::FindBlocked(const Sample& sample, const glm::dvec3& place,
  std::vector<double>& blocked, MesoTraceWork& work) const
{
  const glm::dvec3& normal = sample.Point.Geometric;
  const glm::dvec3 start = place + 1e-3 * sample.Point.TexelSize * normal;
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    double distance = 0.;
    const glm::dvec3 towards = this->Lights[i].Towards(place, distance);
    if (!(glm::dot(normal, towards) > 0.))
    {
      blocked[i] = 1.;
      continue;
    }
    MesoReferenceTracer::Ray ray;
    ray.Origin = start;
    ray.Direction = this->Lights[i].Towards(start, distance);
    ray.TMax = distance;
    blocked[i] =
      this->Tracer->Blocked(ray, sample.At.Object, !this->Lights[i].CastsBetweenObjects, work) ? 1.
                                                                                               : 0.;
  }
}

std::vector<double> MesoReference::Implementation::CastOn(
  const Sample& sample, const std::vector<double>& blocked) const
{
  std::vector<double> cast = blocked;
  for (std::size_t i = 0; i < cast.size(); ++i)
  {
    double distance = 0.;
    const glm::dvec3 towards = this->Lights[i].Towards(sample.Place, distance);
    if (this->Surfaces.size() < 2 || !this->Lights[i].CastsBetweenObjects ||
      !(glm::dot(sample.Point.Geometric, towards) > 0.))
    {
      cast[i] = 0.;
    }
  }
  return cast;
}

glm::dvec3 MesoReference::Implementation::Bounced(const Sample& sample, int bounces,
  const glm::dvec2& first, MesoRandom random, std::vector<double>& blocked,
  MesoTraceWork& work) const
{
  glm::dvec3 light(0.);
  glm::dvec3 carried(1.);
  Sample from = sample;
  glm::dvec2 numbers = first;
  for (int bounce = 0; bounce < bounces; ++bounce)
  {
    // Directions as dense as Lambert's cosine: what they bring counts by the albedo alone.
    carried *= this->Materials[from.At.Object].Albedo(from.Point.MapCoord, from.Point.Color);
    MesoReferenceTracer::Ray ray;
    ray.Direction = MesoCosineDirection(from.Point.Shading, numbers.x, numbers.y);
    numbers = { random.Next(), random.Next() };
    if (!(glm::dot(ray.Direction, from.Point.Geometric) > 0.))
    {
      break;
    }
    ray.Origin = from.Place + 1e-3 * from.Point.TexelSize * from.Point.Geometric;
    ray.TMax = std::numeric_limits<double>::infinity();
    if (!this->Tracer->Trace(ray, from.At, work))
    {
      break;
    }
    from.Point = this->Surfaces[from.At.Object]->Describe(from.At, ray.Direction);
    from.Place = ray.Origin + from.At.T * ray.Direction;
    this->FindBlocked(from, from.Place, blocked, work);
    light += carried *
      this->Materials[from.At.Object].ShadeDiffuse(this->Lights, blocked, from.Place,
        from.Point.Shading, from.Point.MapCoord, from.Point.Color);
  }
  return light;
}

MesoReference::Implementation::Sample MesoReference::Implementation::Look(double x, double y,
  double aspect, bool shadowsOnPlain, std::vector<double>& blocked, MesoTraceWork& work) const
{
  Sample sample;
  sample.Color = this->Background;
  MesoReferenceTracer::Ray ray;
  this->Camera.RayAt(x, y, aspect, ray.Origin, ray.Direction);
  ray.TMin = this->Camera.Near;
  ray.TMax = this->Camera.Far;
  sample.Hit = this->Tracer->Trace(ray, sample.At, work);
  if (!sample.Hit)
  {
    return sample;
  }
  const MesoReferenceSurface& surface = *this->Surfaces[sample.At.Object];
  sample.Point = surface.Describe(sample.At, ray.Direction);
  const glm::dvec3 place = ray.Origin + sample.At.T * ray.Direction;
  sample.Place = place;
  this->FindBlocked(sample, place, blocked, work);

  // To the camera's position, as VTK takes it, in parallel projection as well.
  const glm::dvec3 eye = glm::normalize(this->Camera.Position - place);
  const bool all = shadowsOnPlain || surface.HasDetail();
  sample.Color = this->Materials[sample.At.Object].Shade(this->Lights,
    all ? blocked : this->CastOn(sample, blocked), place, sample.Point.Shading, eye,
    sample.Point.MapCoord, sample.Point.Color);

  ray.TMax = sample.At.T + 1e-9 * std::abs(sample.At.T);
  sample.MeetsBase = !sample.At.Behind &&
    (!surface.IsDisplaced() || this->Tracer->MeetsBase(ray, sample.At.Object, work));
  return sample;
}

void MesoReference::Implementation::Fill(
  const Sample& sample, const std::vector<double>& blocked, float* values) const
{
  if (!sample.Hit)
  {
    return; // every channel is 0
  }
  const MesoReferencePoint& point = sample.Point;
  const double fixed[NumberOfChannels] = { 1., sample.At.T, point.MapCoord.x, point.MapCoord.y,
    point.Relief, point.Shading.x, point.Shading.y, point.Shading.z,
    static_cast<double>(this->Numbers[sample.At.Object]), 0., 0., 0. };
  float* next = std::copy_n(fixed, NumberOfChannels, values);
  next = std::copy_n(blocked.data(), blocked.size(), next);
  *next = sample.MeetsBase ? 1.f : 0.f;
}

MesoReferenceResult MesoReference::Render(int width, int height, int samples,
  const std::function<bool(double)>& progress, int bounces) const
{
  if (width < 1 || height < 1 || width > LargestSize || height > LargestSize || samples < 1 ||
    bounces < 0)
  {
    throw MesoInputError("a reference of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels, " + std::to_string(samples) + " samples and " +
      std::to_string(bounces) + " bounces cannot be rendered");
  }
  const auto start = std::chrono::steady_clock::now();
  const Implementation& inside = *this->Inside;
  MesoReferenceResult result;
  MesoExrImage& aovs = result.AOVs;
  aovs.Width = width;
  aovs.Height = height;
  const double aspect = static_cast<double>(width) / height;
  aovs.Attributes = MesoAttributesOfScene(inside.Builder, inside.Renderer, aspect);
  aovs.ChannelNames.assign(std::begin(Channels), std::end(Channels));
  for (std::size_t i = 0; i < inside.Lights.size(); ++i)
  {
    aovs.ChannelNames.push_back("shadow." + std::to_string(i));
  }
  aovs.ChannelNames.emplace_back("base");
  const std::size_t channels = aovs.ChannelNames.size();
  aovs.Data.assign(channels * width * height, 0.f);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());

  vtkSMPThreadLocal<MesoTraceWork> works;
  const auto tracePixel = [&](vtkIdType pixel, std::vector<double>& blocked, MesoTraceWork& work)
  {
    const vtkIdType column = pixel % width;
    const vtkIdType row = pixel / width; // from the bottom
    const auto look = [&](double offX, double offY)
    {
      std::fill(blocked.begin(), blocked.end(), 0.);
      return inside.Look(2. * (static_cast<double>(column) + 0.5 + offX) / width - 1.,
        2. * (static_cast<double>(row) + 0.5 + offY) / height - 1., aspect, bounces > 0, blocked,
        work);
    };
    // Each pixel's directions are the same even points, moved by an amount of its own.
    const std::uint64_t seed = static_cast<std::uint64_t>(pixel) * 0x100000001b3u;
    MesoRandom random(seed);
    const glm::dvec2 shift{ random.Next(), random.Next() }; // in this order
    const auto colorOf = [&](const Implementation::Sample& sample, int number)
    {
      if (!sample.Hit || bounces == 0)
      {
        return glm::clamp(sample.Color, 0., 1.);
      }
      const glm::dvec2 first = glm::fract(
        shift + glm::dvec2(MesoRadicalInverse(number, 5), MesoRadicalInverse(number, 7)));
      return sample.Color +
        inside.Bounced(sample, bounces, first, MesoRandom(seed + number), blocked, work);
    };
    const Implementation::Sample centre = look(0., 0.);
    const std::size_t fromTop = std::size_t(height - 1 - row) * width + column;
    inside.Fill(centre, blocked, &aovs.Data[channels * fromTop]);
    glm::dvec3 color = samples == 1 ? colorOf(centre, 1) : glm::dvec3(0.);
    for (int sample = 1; sample <= samples && samples > 1; ++sample)
    {
      color +=
        colorOf(
          look(MesoRadicalInverse(sample, 2) - 0.5, MesoRadicalInverse(sample, 3) - 0.5), sample) /
        double(samples);
    }
    for (int k = 0; k < 3; ++k)
    {
      bytes[3 * pixel + k] =
        static_cast<unsigned char>(std::lround(255. * glm::clamp(color[k], 0., 1.)));
    }
  };

  // In bands of rows, between which progress is told and an abort is heard.
  constexpr vtkIdType PixelsOfBand = 16384;
  const vtkIdType rowsOfBand = std::max<vtkIdType>(1, PixelsOfBand / width / samples);
  bool goOn = !progress || progress(0.);
  for (vtkIdType row = 0; row < height && goOn; row += rowsOfBand)
  {
    const vtkIdType end = std::min<vtkIdType>(height, row + rowsOfBand);
    vtkSMPTools::For(row * width, end * width, 64,
      [&](vtkIdType first, vtkIdType last)
      {
        MesoTraceWork& work = works.Local();
        std::vector<double> blocked(inside.Lights.size());
        for (vtkIdType pixel = first; pixel < last; ++pixel)
        {
          tracePixel(pixel, blocked, work);
        }
      });
    goOn = !progress || progress(static_cast<double>(end) / height);
  }

  MesoTraceWork work;
  for (const MesoTraceWork& part : works)
  {
    work.Add(part);
  }
  MesoReferenceCounters& counters = result.Counters;
  counters.Rays = work.Rays;
  counters.PrepareSeconds = inside.PrepareSeconds;
  counters.LargestResidual = work.Solver.LargestResidual;
  counters.Blocks = work.Solver.Blocks;
  counters.Pieces = work.Solver.Pieces;
  counters.UnresolvedCells = work.Solver.Unresolved;
  counters.Facets = inside.Tracer->NumberOfFacets();
  counters.MemoryBytes = inside.Tracer->MemoryBytes();
  for (const auto& surface : inside.Surfaces)
  {
    counters.MemoryBytes += surface->MemoryBytes();
    counters.Triangles += surface->NumberOfPatches();
    counters.DegenerateTriangles += surface->NumberOfDegenerateTriangles();
  }
  counters.Seconds = SecondsSince(start);
  if (goOn)
  {
    result.Picture = picture;
  }
  return result;
}

#include "MesoTechniqueModel.h"

#include "MesoModelSurface.h"
#include "MesoRayScene.h"
#include "MesoReference.h" // for LargestSize
#include "MesoReferenceLighting.h"
#include "MesoSceneAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace
{
const char* const Channels[] = { "coverage", "depth", "texcoord.u", "texcoord.v", "relief",
  "normal.x", "normal.y", "normal.z", "object", "fetches", "texel_reads", "iterations" };
constexpr int NumberOfChannels = 12;

/// Every face of the base meshes that a ray meets.
class AllFaces : public MesoRayQuery
{
public:
  struct Face
  {
    int Object;
    unsigned int Triangle;
    bool Front;
  };
  std::vector<Face> Faces;

  void Test(int, unsigned int) override {}
  bool TestTriangle(int geometry, unsigned int primitive, double, bool front) override
  {
    this->Faces.push_back({ geometry, primitive, front });
    return false;
  }
};
}

struct MesoTechniqueModel::Implementation
{
  MesoSceneBuilder Builder;
  vtkNew<vtkRenderer> Renderer; ///< never rendered: it holds lights and camera
  MesoReferenceCamera Camera;
  std::vector<MesoReferenceLight> Lights;
  std::vector<MesoModelSurface> Surfaces;
  MesoRayScene Faces;

  explicit Implementation(const MesoScene& scene)
    : Camera(scene.Camera)
  {
  }

  /// Fills a pixel's channels; leaves them where nothing is hit.
  void Look(double x, double y, double aspect, float* values) const;
};

bool MesoTechniqueModel::HasModel(const MesoMesostructureOptions& options)
{
  return options.Technique == MesoTechnique::Plain || options.Technique == MesoTechnique::Bump ||
    options.Technique == MesoTechnique::Relief ||
    (options.Technique == MesoTechnique::ReliefQuadric &&
      options.Curved == MesoCurvedKind::Quadric);
}

MesoTechniqueModel::MesoTechniqueModel(const MesoScene& scene)
  : Inside(std::make_unique<Implementation>(scene))
{
  Implementation& inside = *this->Inside;
  if (!scene.ClippingPlanes.empty())
  {
    throw MesoInputError("clipping_planes: a relief that is cut has no model that could be solved "
                         "apart from its technique");
  }
  inside.Builder.Build(scene, inside.Renderer);
  inside.Renderer->UpdateLightsGeometryToFollowCamera();
  for (const MesoSceneLight& light : scene.Lights)
  {
    inside.Lights.emplace_back(light, inside.Camera);
  }
  for (const MesoSceneBuilder::Object& object : inside.Builder.GetObjects())
  {
    if (!HasModel(object.Options))
    {
      throw MesoInputError("node " + std::to_string(object.Number) + " '" + object.Name +
        "': the technique " + MesoName(object.Options.Technique) +
        (object.Options.Interpolation != MesoInterpolation::Bilinear
            ? std::string(" with interpolation ") + MesoName(object.Options.Interpolation)
            : object.Options.Technique == MesoTechnique::ReliefQuadric
            ? std::string(" over the curved base ") + MesoName(object.Options.Curved)
            : std::string()) +
        " has no model that could be solved apart from it");
    }
    if (object.NormalMap)
    {
      throw MesoInputError("node " + std::to_string(object.Number) + " '" + object.Name +
        "': the models of techniques do not know normal maps");
    }
    inside.Surfaces.emplace_back(object);
    inside.Faces.AddTriangles(
      inside.Surfaces.back().WorldPoints(), inside.Surfaces.back().Corners());
  }
  inside.Faces.Commit();
}

MesoTechniqueModel::~MesoTechniqueModel() = default;

void MesoTechniqueModel::Implementation::Look(
  double x, double y, double aspect, float* values) const
{
  AllFaces query;
  this->Camera.RayAt(x, y, aspect, query.Origin, query.Direction);
  const double perDepth = glm::length(query.Direction); // of length along the ray
  query.Direction /= perDepth;
  query.TMin = this->Camera.Near * perDepth;
  query.TMax = std::min(this->Camera.Far * perDepth, std::numeric_limits<double>::max());
  this->Faces.Trace(query);

  double nearest = std::numeric_limits<double>::infinity();
  int object = -1;
  MesoModelFragment fragment;
  MesoModelHit hit;
  for (const AllFaces::Face& face : query.Faces)
  {
    const MesoModelSurface& surface = this->Surfaces[face.Object];
    if (!face.Front && surface.CullsBackFaces())
    {
      continue;
    }
    const auto met = surface.FragmentAt(
      face.Triangle, face.Front, query.Origin, query.Direction, this->Faces.Rounding());
    const auto drawn = met ? surface.Solve(*met) : std::nullopt;
    if (drawn && drawn->T < nearest)
    {
      nearest = drawn->T;
      object = face.Object;
      fragment = *met;
      hit = *drawn;
    }
  }
  if (object < 0)
  {
    return;
  }
  const double fixed[NumberOfChannels] = { 1., hit.T / perDepth, hit.MapCoord.x, hit.MapCoord.y,
    hit.Relief, hit.Normal.x, hit.Normal.y, hit.Normal.z,
    static_cast<double>(this->Builder.GetObjects()[object].Number), 0., 0., 0. };
  float* shadow = std::copy_n(fixed, NumberOfChannels, values);
  const glm::dvec3 place = query.Origin + hit.T * query.Direction;
  for (const MesoReferenceLight& light : this->Lights)
  {
    double distance = 0.;
    const glm::dvec3 towards = light.Towards(place, distance);
    *shadow++ = this->Surfaces[object].Blocks(fragment, hit, towards, distance) ? 1.f : 0.f;
  }
}

MesoExrImage MesoTechniqueModel::Render(
  int width, int height, const std::function<bool(double)>& progress) const
{
  if (width < 1 || height < 1 || width > MesoReference::LargestSize ||
    height > MesoReference::LargestSize)
  {
    throw MesoInputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels cannot be solved");
  }
  const Implementation& inside = *this->Inside;
  const double aspect = static_cast<double>(width) / height;
  MesoExrImage image;
  image.Width = width;
  image.Height = height;
  image.ChannelNames.assign(std::begin(Channels), std::end(Channels));
  for (std::size_t i = 0; i < inside.Lights.size(); ++i)
  {
    image.ChannelNames.push_back("shadow." + std::to_string(i));
  }
  image.Attributes = MesoAttributesOfScene(inside.Builder, inside.Renderer, aspect);
  const std::size_t channels = image.ChannelNames.size();
  image.Data.assign(channels * width * height, 0.f);
  constexpr int RowsOfBand = 16; // between which progress is told
  for (int first = 0; first < height; first += RowsOfBand)
  {
    if (progress && !progress(static_cast<double>(first) / height))
    {
      return {};
    }
    const vtkIdType end = std::min(height, first + RowsOfBand);
    vtkSMPTools::For(first, end, 1,
      [&](vtkIdType begin, vtkIdType stop)
      {
        for (vtkIdType row = begin; row < stop; ++row)
        {
          for (int column = 0; column < width; ++column)
          {
            inside.Look(2. * (column + 0.5) / width - 1., 1. - 2. * (row + 0.5) / height, aspect,
              &image.Data[channels * (row * width + column)]);
          }
        }
      });
  }
  if (progress && !progress(1.))
  {
    return {};
  }
  return image;
}

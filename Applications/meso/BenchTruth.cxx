#include "BenchTruth.h"

#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "MesoReference.h"
#include "MesoShape.h"
#include "MesoTechniqueModel.h"
#include "vtkImageData.h"

#include <algorithm>

namespace
{
void SetTechnique(std::vector<MesoSceneNode>& nodes, MesoTechnique technique,
  std::optional<MesoQuality> quality, std::optional<MesoSearch> search)
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    if (node.Map)
    {
      options.Technique = technique;
      options.Effects = MesoEffectChoice();
      options.Search = search;
      options.Quality = quality.value_or(options.Quality);
      if (!quality && options.Quality == MesoQuality::Certified)
      {
        options.Quality = MesoQuality::High; // which every technique has
      }
    }
    SetTechnique(node.Children, technique, quality, search);
  }
}

/// Whether every node with a map has a model that can be solved.
bool HaveModels(const std::vector<MesoSceneNode>& nodes)
{
  return std::all_of(nodes.begin(), nodes.end(),
    [](const MesoSceneNode& node)
    {
      return (!node.Map || MesoTechniqueModel::HasModel(node.Mesostructure)) &&
        HaveModels(node.Children);
    });
}

void CollectMeshes(
  const std::vector<MesoSceneNode>& nodes, std::vector<const MesoSceneMesh*>& meshes)
{
  for (const MesoSceneNode& node : nodes)
  {
    if (node.Mesh)
    {
      meshes.push_back(&*node.Mesh);
    }
    CollectMeshes(node.Children, meshes);
  }
}

/// Whether a normal map gives normals that no technique's model knows.
bool HasNormalMap(const std::vector<MesoSceneNode>& nodes)
{
  return std::any_of(nodes.begin(), nodes.end(),
    [](const MesoSceneNode& node)
    { return !node.Material.NormalMap.empty() || HasNormalMap(node.Children); });
}
}

const char* MesoName(BenchSurface surface)
{
  return surface == BenchSurface::Mesh ? "mesh" : "smooth";
}

bool HasSmoothSurface(const MesoScene& scene)
{
  std::vector<const MesoSceneMesh*> meshes;
  CollectMeshes(scene.Nodes, meshes);
  bool curved = false;
  for (const MesoSceneMesh* mesh : meshes)
  {
    if (!mesh->File.empty())
    {
      return false;
    }
    const MesoShape shape(mesh->Shape, mesh->Parameters);
    if (!shape.IsFlat() && !shape.HasBends())
    {
      return false;
    }
    curved = curved || !shape.IsFlat();
  }
  return curved;
}

MesoScene WithTechnique(const MesoScene& scene, MesoTechnique technique,
  std::optional<MesoQuality> quality, std::optional<MesoSearch> search)
{
  MesoScene changed = scene;
  SetTechnique(changed.Nodes, technique, quality, search);
  return changed;
}

void WriteTruth(const MesoScene& scene, BenchSurface surface, const std::array<int, 2>& size,
  const std::string& stem)
{
  // Any technique that draws maps stands for the displaced surface.
  const MesoReference reference(WithTechnique(scene, MesoTechnique::Relief, std::nullopt),
    surface == BenchSurface::Mesh ? MesoReference::Surface::Mesh : MesoReference::Surface::Smooth);
  const MesoReferenceResult result = reference.Render(size[0], size[1]);
  const MesoExrImage& aovs = result.AOVs;
  MesoWriteExr(stem + ".aov.exr", aovs.Width, aovs.Height, aovs.ChannelNames, aovs.Data.data(),
    aovs.Attributes);
  const std::string picture = PictureBytes(result.Picture);
  MesoAtomicFile::Write(stem + ".png", picture.data(), picture.size());
}

std::optional<MesoAOVs> SolveModel(
  const MesoScene& scene, MesoTechnique technique, const std::array<int, 2>& size)
{
  const MesoScene changed = WithTechnique(scene, technique, std::nullopt);
  if (technique == MesoTechnique::Plain || !HaveModels(changed.Nodes) || HasNormalMap(scene.Nodes))
  {
    return std::nullopt;
  }
  const MesoTechniqueModel model(changed);
  return MesoAOVsOfImage(model.Render(size[0], size[1]));
}

MesoRendering ReadTruth(const std::string& stem)
{
  return { stem, MesoReadPicture(stem + ".png"), MesoAOVsOfImage(MesoReadExr(stem + ".aov.exr")) };
}

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
/// Whether a technique draws what a node has beside its mesh.
bool Draws(const MesoSceneNode& node, MesoTechnique technique)
{
  if (technique == MesoTechnique::Plain)
  {
    return node.Map || node.Volume;
  }
  if (MesoUsesVolume(technique))
  {
    return node.Volume || node.Map; // a map is made a volume
  }
  return MesoUsesHeightMap(technique) ? node.Map.has_value()
                                      : node.Mesostructure.Technique == technique;
}

bool AnyDraws(const std::vector<MesoSceneNode>& nodes, MesoTechnique technique)
{
  return std::any_of(nodes.begin(), nodes.end(),
    [technique](const MesoSceneNode& node)
    { return Draws(node, technique) || AnyDraws(node.Children, technique); });
}

/// Whether any node has a volume, or is itself drawn as one.
bool HasVolumes(const std::vector<MesoSceneNode>& nodes)
{
  return std::any_of(nodes.begin(), nodes.end(),
    [](const MesoSceneNode& node)
    {
      return node.Volume || MesoUsesVolume(node.Mesostructure.Technique) ||
        HasVolumes(node.Children);
    });
}

void SetTechnique(std::vector<MesoSceneNode>& nodes, MesoTechnique technique,
  std::optional<MesoQuality> quality, std::optional<MesoSearch> search)
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    if (Draws(node, technique))
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

/// Whether every node with a map or a volume has a model that can be solved.
bool HaveModels(const std::vector<MesoSceneNode>& nodes)
{
  return std::all_of(nodes.begin(), nodes.end(),
    [](const MesoSceneNode& node)
    {
      return ((!node.Map && !node.Volume) || MesoTechniqueModel::HasModel(node.Mesostructure)) &&
        HaveModels(node.Children);
    });
}

/// The technique that stands for what is true of each node: where the scene itself draws its map as a volume, the
/// solid below the relief, with its sides at open edges; else the relief.
void SetTrueTechniques(std::vector<MesoSceneNode>& nodes)
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    if (node.Map || node.Volume)
    {
      const bool isSolid = node.Volume || MesoUsesVolume(options.Technique);
      options.Technique = isSolid ? MesoTechnique::ShellSDF : MesoTechnique::Relief;
      options.Effects = MesoEffectChoice();
      options.Search.reset();
      if (options.Quality == MesoQuality::Full || options.Quality == MesoQuality::Certified)
      {
        options.Quality = MesoQuality::High;
      }
    }
    SetTrueTechniques(node.Children);
  }
}

void CollectNodes(
  const std::vector<MesoSceneNode>& nodes, std::vector<const MesoSceneNode*>& withMesh)
{
  for (const MesoSceneNode& node : nodes)
  {
    if (node.Mesh)
    {
      withMesh.push_back(&node);
    }
    CollectNodes(node.Children, withMesh);
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
  std::vector<const MesoSceneNode*> nodes;
  CollectNodes(scene.Nodes, nodes);
  bool curved = false;
  for (const MesoSceneNode* node : nodes)
  {
    // A volume's shell is made of the mesh's triangles, whatever they stand for.
    if (!node->Mesh->File.empty() || node->Volume || node->Part ||
      MesoUsesVolume(node->Mesostructure.Technique))
    {
      return false;
    }
    const MesoShape shape(node->Mesh->Shape, node->Mesh->Parameters);
    if (!shape.IsFlat() && !shape.HasBends())
    {
      return false;
    }
    curved = curved || !shape.IsFlat();
  }
  return curved;
}

bool CanDraw(const MesoScene& scene, MesoTechnique technique, bool mapsAsVolumes)
{
  if (MesoUsesVolume(technique) && !mapsAsVolumes)
  {
    return HasVolumes(scene.Nodes);
  }
  return technique == MesoTechnique::Plain || AnyDraws(scene.Nodes, technique);
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
  MesoScene displaced = scene;
  SetTrueTechniques(displaced.Nodes);
  const MesoReference reference(displaced,
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

#include "MesoShellScene.h"

#include "MesoAlgorithmRun.h"
#include "MesoGDMInput.h"
#include "MesoHeightVolume.h"
#include "MesoScene.h"
#include "MesoShellShader.h"
#include "MesoVolumeInput.h"
#include "vtkImageData.h"
#include "vtkMesoPrismShell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

namespace
{
/// "3, 17, 20, ..." of a list.
std::string FirstOf(const std::vector<vtkIdType>& numbers)
{
  constexpr std::size_t most = 5;
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
  {
    text << (i > 0 ? ", " : "") << numbers[i];
  }
  return text.str() + (numbers.size() > most ? ", ..." : "");
}
}

vtkSmartPointer<vtkPolyData> MesoMakeShell(vtkPolyData* base, vtkImageData* volume,
  const MesoMesostructureOptions& options, const std::string& inScene,
  std::vector<std::string>& warnings)
{
  const MesoEffects effects = MesoEffectsOn(options);
  MesoEffects together =
    MesoEffectsOfTechnique(options.Technique)
      .Without({ MesoEffect::Shading, MesoEffect::SelfShadow, MesoEffect::CastShadow });
  if (!together.Without(effects).Empty())
  {
    std::string names;
    for (const std::string& name : together.Names())
    {
      names += (names.empty() ? "" : ", ") + name;
    }
    throw MesoInputError(inScene + ".mesostructure.effects: technique " +
      MesoName(options.Technique) + " shows these together: " + names +
      "; all of them must be among its effects, or no effect at all");
  }
  vtkNew<vtkMesoPrismShell> shell;
  shell->SetInputData(base);
  shell->SetThickness(options.Scale);
  shell->SetReference(options.Reference);
  shell->SetTiles(options.Tiles[0], options.Tiles[1]);
  shell->SetInnerFins(options.Exits == MesoExits::Interpolated);
  if (options.Technique == MesoTechnique::Slices && options.Stack == MesoStack::Prism)
  {
    shell->SetSlices(MesoSlicesOf(*volume, options.Quality));
  }
  MesoRunAlgorithm(shell, inScene + ".mesh", warnings);
  const std::vector<vtkIdType>& inverted = shell->GetInvertedTriangles();
  if (!inverted.empty())
  {
    std::ostringstream warning;
    warning << inScene << ".mesostructure: scale " << options.Scale
            << " is more than the mesh's curvature has room for: the prisms over "
            << inverted.size() << " triangles turn over (" << FirstOf(inverted)
            << "), and what is drawn there is undefined";
    warnings.push_back(warning.str());
  }
  return shell->GetOutput();
}

MesoShellVolume MesoReadShellVolume(const MesoSceneNode& node, vtkImageData* heights,
  const std::string& place, std::vector<std::string>& warnings)
{
  const MesoMesostructureOptions& options = node.Mesostructure;
  if (options.Wrap != MesoWrap::Repeat)
  {
    throw MesoInputError(place + ".wrap: a volume repeats");
  }
  MesoShellVolume result;
  if (!node.Baked.empty())
  {
    result.Table = MesoReadGDM(node.Baked, place + ".baked");
    result.Volume = MesoVolumeOfGDM(result.Table);
  }
  else
  {
    result.Volume = node.Volume ? MesoReadVolume(*node.Volume, place + ".volume", warnings)
                                : MesoVolumeOfHeights(heights, place, warnings);
  }
  if (options.Technique == MesoTechnique::GDM && !result.Table)
  {
    constexpr int ordinaryRank = 16;
    const int rank = options.Rank ? (*options.Rank)[0] : ordinaryRank;
    // Full and draft show the look-up alone, which no correction takes on from a nearer distance.
    const bool isWhole = options.Quality == MesoQuality::Full;
    const bool isCorrected = !isWhole && options.Quality != MesoQuality::Draft;
    result.Table = MesoMakeGDM(result.Volume, isWhole ? 0 : rank, isCorrected, place, warnings);
  }
  if (!node.VolumeColors.empty())
  {
    result.Volume = MesoColoredVolume(result.Volume, node.VolumeColors, place + ".volume_colors");
  }
  return result;
}

void MesoCheckShellMaterial(const MesoSceneMaterial& material, const std::string& inScene)
{
  const auto refuse = [&](const char* key, const char* reason)
  { throw MesoInputError(inScene + ".material." + key + ": " + reason); };
  if (!material.NormalMap.empty())
  {
    refuse("normal_map", "a volume shows the normals of its matter, and no others");
  }
  if (material.ColorBy && !material.ColorBy->IsHeight())
  {
    refuse("color_by", "a volume is colored by height, or not by numbers");
  }
  if (material.Contours)
  {
    refuse("contours", "there are no contour lines on a volume's matter");
  }
}

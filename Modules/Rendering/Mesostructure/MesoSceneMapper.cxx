#include "MesoSceneMapper.h"

#include "MesoAlgorithmRun.h"
#include "MesoBakedFile.h"
#include "MesoBumpMaps.h"
#include "MesoShellScene.h"
#include "MesoVDMInput.h"
#include "vtkImageData.h"
#include "vtkMesoBaseImage.h"
#include "vtkMesoBumpMapper.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoDisplacementMapper.h"
#include "vtkMesoGeometryImage.h"
#include "vtkMesoGeometryImageMapper.h"
#include "vtkMesoMovedMesh.h"
#include "vtkMesoQuadricFit.h"
#include "vtkMesoReliefMapper.h"
#include "vtkMesoShellMapper.h"
#include "vtkMesoTessellatedMapper.h"
#include "vtkMesoVDMMapper.h"
#include "vtkPolyData.h"

#include <sstream>

namespace
{
/// What mappers are made of.
struct Making
{
  const MesoSceneNode& Node;
  MesoSceneBuilder::Object& Object;
  const MesoNormals& Normals;
  std::string InScene;
  std::vector<std::string>& Warnings;

  const MesoMesostructureOptions& Options() const { return this->Object.Options; }
  MesoEffects Effects() const { return MesoEffectsOn(this->Object.Options); }
  std::string InMesh() const { return this->InScene + ".mesh"; }
  std::string InMesostructure() const { return this->InScene + ".mesostructure"; }
};

/// The techniques that draw the mesh itself displaced show these together or not at all.
void CheckGeometryEffects(const Making& making)
{
  const MesoEffects effects = making.Effects();
  const MesoEffects ofGeometry = { MesoEffect::Occlusion, MesoEffect::Depth,
    MesoEffect::Silhouette };
  if (!effects.Without({ MesoEffect::CastShadow }).Empty() && !ofGeometry.Without(effects).Empty())
  {
    throw MesoInputError(making.InMesostructure() + ": technique " +
      MesoName(making.Options().Technique) +
      " shows occlusion, depth and silhouette together: all of them must be among its effects, or "
      "no "
      "effect at all");
  }
}

/// The base moved outward to where height 1 lies, with frames fitted there.
vtkSmartPointer<vtkPolyData> Moved(const Making& making)
{
  vtkNew<vtkMesoMovedMesh> moved;
  moved->SetInputData(making.Object.Base);
  moved->SetDistance((1. - making.Options().Reference) * making.Options().Scale);
  MesoRunAlgorithm(moved, making.InMesh(), making.Warnings);
  return moved->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithQuadrics(const Making& making)
{
  vtkNew<vtkMesoQuadricFit> fit;
  fit->SetInputData(making.Object.Mesh);
  if (making.Options().Quadric == MesoQuadricKind::Diagonal)
  {
    fit->FullOff();
    fit->SlopesOff();
    fit->SetRings(1);
    fit->NormalEquationsOn();
  }
  MesoRunAlgorithm(fit, making.InMesh(), making.Warnings);
  return fit->GetOutput();
}

/// The mesh that rays below a rasterised base start from.
void SetOuterMesh(const Making& making)
{
  if (making.Options().Reference != 1. && !making.Effects().Empty())
  {
    making.Object.Mesh = Moved(making);
  }
  if (making.Effects().Has(MesoEffect::Curvature))
  {
    making.Object.Mesh = WithQuadrics(making);
  }
}

vtkSmartPointer<vtkImageData> BaseImage(const Making& making)
{
  vtkNew<vtkMesoBaseImage> image;
  image->SetInputData(making.Object.Mesh);
  image->SetSizeFor(making.Object.Mesh);
  MesoRunAlgorithm(image, making.InMesh(), making.Warnings);
  const vtkIdType ambiguous = image->GetNumberOfAmbiguousTexels();
  const vtkIdType covered = ambiguous + image->GetNumberOfInsideTexels();
  if (100 * ambiguous > covered)
  {
    std::ostringstream warning;
    warning << making.InMesh() << ": several parts of the mesh share " << 100 * ambiguous / covered
            << " % of its texture; there the curved base is the quadric";
    making.Warnings.push_back(warning.str());
  }
  return image->GetOutput();
}

void MakeRelief(const Making& making)
{
  SetOuterMesh(making);
  vtkNew<vtkMesoReliefMapper> relief;
  relief->SetHeightMap(making.Object.HeightMap);
  if (MesoNeedsBaseImage(making.Options()))
  {
    relief->SetBaseImage(BaseImage(making));
  }
  relief->SetOptions(making.Options());
  const std::string problem = relief->Prepare();
  if (!problem.empty())
  {
    throw MesoInputError(making.InMesostructure() + ": " + problem);
  }
  making.Object.Mapper = relief;
}

void MakeVDM(const Making& making)
{
  SetOuterMesh(making);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetOptions(making.Options());
  vdm->SetHeightMap(making.Object.HeightMap);
  MesoSetVDMTable(
    vdm, making.Node.Baked, making.Object.Mesh, making.InMesostructure(), making.Warnings);
  making.Object.Mapper = vdm;
}

void MakeBump(const Making& making)
{
  if (making.Options().Technique == MesoTechnique::Parallax && making.Options().Reference != 1. &&
    making.Effects().Has(MesoEffect::Occlusion))
  {
    making.Object.Mesh = Moved(making);
  }
  vtkNew<vtkMesoBumpMapper> bump;
  bump->SetOptions(making.Options());
  MesoSetBumpMaps(bump, making.Object.HeightMap, making.Object.Mesh, making.Normals,
    making.InMesostructure(), making.Warnings);
  making.Object.Mapper = bump;
}

void MakeShell(const Making& making)
{
  MesoSceneBuilder::Object& object = making.Object;
  if (making.Effects().Empty())
  {
    object.Mapper = vtkSmartPointer<vtkMesoPolyDataMapper>::New();
    return;
  }
  object.Mesh =
    MesoMakeShell(object.Base, object.Volume, making.Options(), making.InScene, making.Warnings);
  vtkNew<vtkMesoShellMapper> shell;
  shell->SetVolume(object.Volume);
  shell->SetTable(object.VolumeTable);
  object.Mapper = shell;
}

void MakeDisplacement(const Making& making)
{
  CheckGeometryEffects(making);
  vtkNew<vtkMesoDisplacementMapper> displacement;
  displacement->SetHeightMap(making.Object.HeightMap);
  if (making.Options().Scale > 0. && making.Effects().Has(MesoEffect::SelfShadow))
  {
    double scale = 0.;
    const auto horizons = MesoMakeHorizons(making.Object.HeightMap, making.Object.Mesh,
      making.Options(), scale, making.InMesostructure(), making.Warnings);
    displacement->SetHorizonMap(horizons, scale);
  }
  making.Object.Mapper = displacement;
}

/// Read where a baked file is named, else made of the object's mesh.
vtkSmartPointer<vtkImageData> GeometryImage(const Making& making)
{
  const std::string& baked = making.Node.Baked;
  if (!baked.empty())
  {
    const MesoBaked file = MesoReadBaked(baked, "geometry-image");
    std::string problem;
    if (vtkMesoGeometryImage::NumberOfLevelsOf(file.Table, problem) == 0)
    {
      throw MesoInputError(making.InMesostructure() + ".baked: " + baked + ": " + problem);
    }
    return file.Table;
  }
  vtkNew<vtkMesoGeometryImage> image;
  image->SetInputData(making.Object.Mesh);
  image->SetSize(static_cast<int>(256. * MesoFacetsPerTexel(making.Options().Quality)));
  MesoRunAlgorithm(image, making.InMesh(), making.Warnings);
  if (image->GetNumberOfOverlaps() > 0)
  {
    making.Warnings.push_back(making.InMesh() + ": several parts of the mesh share " +
      std::to_string(image->GetNumberOfOverlaps()) +
      " texels of its geometry image, which shows one of them");
  }
  return image->GetOutput();
}

void MakeGeometryImage(const Making& making)
{
  vtkNew<vtkMesoGeometryImageMapper> mapper;
  mapper->SetGeometryImage(GeometryImage(making));
  making.Object.Mapper = mapper;
}

/// The object's mesh as the technique tessellated draws it.
vtkSmartPointer<vtkPolyData> Diced(const Making& making)
{
  const MesoEffects effects = making.Effects();
  if (effects.Without({ MesoEffect::CastShadow }).Empty())
  {
    return making.Object.Base;
  }
  CheckGeometryEffects(making);
  const MesoMesostructureOptions& options = making.Options();
  vtkNew<vtkMesoDisplacedMesh> diced;
  diced->SetInputData(making.Object.Base);
  diced->SetHeightMapData(making.Object.HeightMap);
  diced->SetScale(options.Scale);
  diced->SetReference(options.Reference);
  diced->SetTiles(options.Tiles[0], options.Tiles[1]);
  diced->SetWrap(options.Wrap);
  diced->SetFacetsPerTexel(MesoFacetsPerTexel(options.Quality));
  const auto& colorBy = making.Node.Material.ColorBy;
  if (colorBy && !colorBy->IsHeight())
  {
    diced->AddCarriedArray(colorBy->Array);
  }
  diced->SetDetailNormals(effects.Has(MesoEffect::Shading));
  MesoRunAlgorithm(diced, making.InMesostructure(), making.Warnings);
  if (diced->GetNumberOfTornEdges() > 0)
  {
    std::ostringstream warning;
    warning << making.InMesostructure() << ": the surface is torn along "
            << diced->GetNumberOfTornEdges() << " edges of the mesh, by up to "
            << diced->GetLargestTear()
            << ", where the map does not continue across a seam or normals differ";
    making.Warnings.push_back(warning.str());
  }
  return diced->GetOutput();
}

void MakeOfTechnique(const Making& making)
{
  switch (making.Options().Technique)
  {
    case MesoTechnique::Relief:
    case MesoTechnique::ReliefQuadric:
    case MesoTechnique::ReliefQuadricExact:
      MakeRelief(making);
      break;
    case MesoTechnique::Bump:
    case MesoTechnique::Normal:
    case MesoTechnique::NormalObject:
    case MesoTechnique::Parallax:
    case MesoTechnique::Horizon:
      MakeBump(making);
      break;
    case MesoTechnique::VDM:
      MakeVDM(making);
      break;
    case MesoTechnique::GDM:
    case MesoTechnique::Slices:
    case MesoTechnique::ShellSDF:
      MakeShell(making);
      break;
    case MesoTechnique::Displacement:
      MakeDisplacement(making);
      break;
    case MesoTechnique::GeometryImage:
      MakeGeometryImage(making);
      break;
    case MesoTechnique::Tessellated:
      making.Object.Mapper = vtkSmartPointer<vtkMesoTessellatedMapper>::New();
      break;
    case MesoTechnique::Plain:
      making.Object.Mapper = vtkSmartPointer<vtkMesoPolyDataMapper>::New();
      break;
  }
}
}

void MesoMakeSceneMapper(const MesoSceneNode& node, MesoSceneBuilder::Object& object,
  const MesoNormals& normals, const std::string& inScene, std::vector<std::string>& warnings)
{
  const Making making = { node, object, normals, inScene, warnings };
  MakeOfTechnique(making);
  object.Mapper->SetOptions(object.Options);
  object.Mapper->SetInputData(
    object.Options.Technique == MesoTechnique::Tessellated ? Diced(making) : object.Mesh);
}

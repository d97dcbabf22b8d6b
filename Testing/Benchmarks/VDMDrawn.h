#ifndef VDMDrawn_h
#define VDMDrawn_h

// What the programs share that measure scenes drawn by tables of view-dependent displacements of given sizes.

#include "DrawnAOVs.h"
#include "MesoReference.h"
#include "vtkMesoVDM.h"
#include "vtkMesoVDMMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cstdio>

namespace VDMDrawn
{
constexpr int MostFactors = 12;

/// A table's size, as TEXELSxAZIMUTHSxPOLARS.
struct Size
{
  int Texels = 128;
  int Azimuths = 32;
  int Polars = 8;

  bool Parse(const char* text)
  {
    return std::sscanf(text, "%dx%dx%d", &this->Texels, &this->Azimuths, &this->Polars) == 3;
  }
};

/// The first node drawn by a table of so many factors, the map itself; rank 0: by the table itself.
inline MesoScene SceneAtRank(const MesoScene& scene, int rank)
{
  MesoScene drawn = scene;
  MesoMesostructureOptions& options = drawn.Nodes[0].Mesostructure;
  options.Technique = MesoTechnique::VDM;
  options.Filter = MesoFilter::None;
  options.Quality = rank > 0 ? MesoQuality::Medium : MesoQuality::Full;
  options.Rank.reset();
  if (rank > 0)
  {
    options.Rank = { rank, std::min(rank, 4) };
  }
  return drawn;
}

inline vtkMesoVDMMapper* MapperOf(const MesoSceneBuilder& builder)
{
  return vtkMesoVDMMapper::SafeDownCast(builder.GetObjects()[0].Mapper);
}

/// A table of a size, of the map, the depth and the curvatures that the scene's own has.
inline void BakeAtSize(vtkMesoVDM* filter, const MesoScene& scene, const Size& size, int rank)
{
  vtkNew<vtkRenderer> apart;
  MesoSceneBuilder builder;
  builder.Build(SceneAtRank(scene, MostFactors), apart);
  vtkMesoVDMMapper* mapper = MapperOf(builder);
  MesoVDMLayout layout = MesoVDMLayout::Read(mapper->GetTable());
  layout.Width = layout.Height = size.Texels;
  layout.Azimuths = size.Azimuths;
  layout.Polars = size.Polars;
  filter->SetInputData(mapper->GetHeightMap());
  filter->SetLayout(layout);
  filter->SetRanks(rank, std::min(rank, 4));
  filter->Update();
}

/// Has its shape a closed form? Else the truth is that of its mesh.
inline bool HasSmoothSurface(const MesoScene& scene)
{
  const std::string& shape = scene.Nodes[0].Mesh->Shape;
  return shape != "teapot" && shape != "branch";
}

inline MesoAOVs TruthOf(const MesoScene& scene, int width, int height)
{
  const auto surface =
    HasSmoothSurface(scene) ? MesoReference::Surface::Smooth : MesoReference::Surface::Mesh;
  return MesoAOVsOfImage(
    MesoReference(SceneAtRank(scene, MostFactors), surface).Render(width, height).AOVs);
}
}

#endif

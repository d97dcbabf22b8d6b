#include "MesoBumpMaps.h"

#include "MesoAlgorithmRun.h"
#include "MesoBakeCache.h"
#include "MesoScene.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoBumpMapper.h"
#include "vtkMesoHorizonMap.h"
#include "vtkMesoImageReader.h"
#include "vtkMesoNormalMap.h"
#include "vtkMesoObjectNormalMap.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int LargestObjectMap = 4096;
constexpr double HorizonBaker = 1.; // grows when the filter's results change

MesoNormals NormalsOfHeights(vtkImageData* heights, vtkPolyData* mesh,
  const MesoMesostructureOptions& options, const std::string& place,
  std::vector<std::string>& warnings)
{
  MesoNormals normals;
  if (options.Technique == MesoTechnique::NormalObject)
  {
    vtkNew<vtkMesoObjectNormalMap> filter;
    filter->SetInputData(0, heights);
    filter->SetInputData(1, mesh);
    int size[2];
    for (int i = 0; i < 2; ++i)
    {
      size[i] =
        std::min(LargestObjectMap, int(std::ceil(heights->GetDimensions()[i] * options.Tiles[i])));
    }
    filter->SetSize(size);
    filter->SetScale(options.Scale);
    filter->SetTiles(options.Tiles[0], options.Tiles[1]);
    filter->SetWrap(options.Wrap);
    MesoRunAlgorithm(filter, place, warnings);
    if (filter->GetNumberOfOverlaps() > 0)
    {
      warnings.push_back(place + ": charts of the mesh overlap in " +
        std::to_string(filter->GetNumberOfOverlaps()) +
        " texels, where a normal map in object space can be right for one of them alone");
    }
    normals.Image = filter->GetOutput();
    normals.Meaning.Space = MesoNormalSpace::Object;
    return normals;
  }
  normals.Meaning.Space = MesoNormalSpace::Relief;
  normals.Meaning.Depth = MesoDepthInTiles(mesh, options);
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(heights);
  filter->SetScale(normals.Meaning.Depth);
  filter->SetWrap(options.Wrap);
  MesoRunAlgorithm(filter, place, warnings);
  normals.Image = filter->GetOutput();
  return normals;
}
}

double MesoDepthInTiles(vtkPolyData* mesh, const MesoMesostructureOptions& options)
{
  vtkDataArray* scales = mesh->GetPointData()->GetArray("MesoTileScale");
  double sum = 0.;
  for (vtkIdType i = 0; scales && i < scales->GetNumberOfTuples(); ++i)
  {
    sum +=
      scales->GetComponent(i, 0) / options.Tiles[0] + scales->GetComponent(i, 1) / options.Tiles[1];
  }
  const double mean = scales ? sum / (2. * static_cast<double>(scales->GetNumberOfTuples())) : 0.;
  const double depth = options.Scale / mean;
  return std::isfinite(depth) ? std::min(std::max(depth, 1e-3), 1e3) : 1.;
}

MesoNormals MesoReadNormalMap(
  const MesoSceneMaterial& material, const std::string& place, std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoImageReader> reader;
  reader->SetFileName(material.NormalMap.c_str());
  MesoRunAlgorithm(reader, place, warnings);
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* stored = image->GetPointData()->GetScalars();
  const auto fail = [&](const std::string& reason)
  { throw MesoInputError(place + ": " + material.NormalMap + ": " + reason); };
  if (stored->GetNumberOfComponents() < 3)
  {
    fail("a normal map needs three channels, this image has " +
      std::to_string(stored->GetNumberOfComponents()));
  }
  MesoNormals normals;
  normals.Meaning.Space =
    material.NormalMapOfObject ? MesoNormalSpace::Object : MesoNormalSpace::Tangent;
  normals.Meaning.Down = material.NormalMapDown;
  auto directions = vtkSmartPointer<vtkDataArray>::Take(stored->NewInstance());
  directions->SetNumberOfComponents(3);
  directions->SetNumberOfTuples(stored->GetNumberOfTuples());
  for (int component = 0; component < 3; ++component)
  {
    directions->CopyComponent(component, stored, component);
  }
  if (auto* floats = vtkFloatArray::SafeDownCast(directions))
  {
    // 0 to 1 stand for -1 to 1, as in files of 8 and 16 bit.
    for (vtkIdType i = 0; i < floats->GetNumberOfValues(); ++i)
    {
      const float value = floats->GetValue(i);
      if (value < 0.f || value > 1.f)
      {
        fail("holds numbers outside of [0, 1], which stand for [-1, 1]");
      }
      floats->SetValue(i, 2.f * value - 1.f);
    }
  }
  normals.Image = vtkSmartPointer<vtkImageData>::New();
  normals.Image->SetExtent(image->GetExtent());
  normals.Image->GetPointData()->SetScalars(directions);
  return normals;
}

vtkSmartPointer<vtkImageData> MesoMakeHorizons(vtkImageData* heights, vtkPolyData* mesh,
  const MesoMesostructureOptions& options, double& scale, const std::string& place,
  std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoHorizonMap> horizons;
  horizons->SetInputData(heights);
  horizons->SetAzimuths(MesoAzimuthsOfQuality(options.Quality));
  scale = MesoDepthInTiles(mesh, options);
  horizons->SetScale(scale);
  horizons->SetWrap(options.Wrap);
  const std::map<std::string, MesoBakedParameter> parameters = {
    { "baker", std::vector<double>{ HorizonBaker } },
    { "heights", MesoContentOf(heights) },
    { "azimuths", std::vector<double>{ double(horizons->GetAzimuths()) } },
    { "scale", std::vector<double>{ scale } },
    { "reach", std::vector<double>{ horizons->GetReach() } },
    { "wrap", std::string(MesoName(options.Wrap)) },
  };
  const auto bake = [&]
  {
    MesoRunAlgorithm(horizons, place, warnings);
    return vtkSmartPointer<vtkImageData>(horizons->GetOutput());
  };
  return MesoBakeOnce("horizon", parameters, bake, warnings).Table;
}

void MesoSetBumpMaps(vtkMesoBumpMapper* mapper, vtkImageData* heights, vtkPolyData* mesh,
  const MesoNormals& given, const std::string& place, std::vector<std::string>& warnings)
{
  const MesoMesostructureOptions& options = mapper->GetOptions();
  mapper->SetHeightMap(heights);
  const bool mapped =
    options.Technique == MesoTechnique::Normal || options.Technique == MesoTechnique::NormalObject;
  if (!heights || MesoEffectsOn(options).Empty())
  {
    return;
  }
  if (mapped && !given.Image)
  {
    const MesoNormals made = NormalsOfHeights(heights, mesh, options, place, warnings);
    mapper->SetNormalMap(made.Image, made.Meaning);
  }
  if (options.Technique == MesoTechnique::Horizon &&
    MesoEffectsOn(options).Has(MesoEffect::SelfShadow))
  {
    double scale = 0.;
    const vtkSmartPointer<vtkImageData> horizons =
      MesoMakeHorizons(heights, mesh, options, scale, place, warnings);
    mapper->SetHorizonMap(horizons, scale);
  }
}

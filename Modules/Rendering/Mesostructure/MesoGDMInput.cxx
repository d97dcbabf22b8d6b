#include "MesoGDMInput.h"

#include "MesoAlgorithmRun.h"
#include "MesoBakeCache.h"
#include "MesoGDMShape.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoVolume.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGDMTable.h"
#include "vtkNew.h"

namespace
{
constexpr double BakerVersion = 1.; // grows when the same input gives other tables
constexpr int BitsOfWhole = 16;     // of 8 tile widths, 8 bits are steps of two voxels

std::map<std::string, MesoBakedParameter> ParametersOf(vtkMesoGDMTable* table)
{
  std::map<std::string, MesoBakedParameter> parameters;
  const auto add = [&](const char* name, double value)
  { parameters[name] = std::vector<double>{ value }; };
  add("azimuths", table->GetAzimuths());
  add("polars", table->GetPolars());
  add("even", table->GetEven());
  add("reach", table->GetReach());
  add("rank", table->GetRank());
  add("bits", table->GetBits());
  add("exact", table->GetExact());
  add("cautious", table->GetCautious());
  return parameters;
}
}

MesoBaked MesoBakedGDM(vtkMesoGDMTable* table)
{
  MesoBaked baked;
  baked.Kind = "gdm";
  baked.Parameters = ParametersOf(table);
  baked.Table = table->GetOutput();
  return baked;
}

vtkSmartPointer<vtkImageData> MesoReadGDM(const std::string& fileName, const std::string& place)
{
  try
  {
    const MesoBaked baked = MesoReadBaked(fileName, "gdm");
    const std::string problem = MesoGDMTableProblem(baked.Table);
    if (!problem.empty())
    {
      throw MesoInputError(fileName + ": " + problem);
    }
    return baked.Table;
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(place + ": " + problem.what());
  }
}

vtkSmartPointer<vtkImageData> MesoMakeGDM(vtkImageData* volume, int rank, bool cautious,
  const std::string& place, std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(volume);
  table->SetRank(rank);
  table->SetCautious(cautious);
  if (rank == 0)
  {
    table->SetBits(BitsOfWhole);
  }
  auto parameters = ParametersOf(table);
  parameters["volume"] = MesoContentOf(volume);
  parameters["depth"] = std::vector<double>{ MesoVolumeDepth(volume) };
  parameters["baker"] = std::vector<double>{ BakerVersion };
  const auto bake = [&]() -> vtkSmartPointer<vtkImageData>
  {
    MesoRunAlgorithm(table, place, warnings);
    return table->GetOutput();
  };
  return MesoBakeOnce("gdm", parameters, bake, warnings).Table;
}

vtkSmartPointer<vtkImageData> MesoVolumeOfGDM(vtkImageData* table)
{
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  vtkDataArray* samples = table->GetFieldData()->GetArray("MesoGDMVolume");
  std::vector<float> distances(static_cast<std::size_t>(samples->GetNumberOfTuples()));
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    distances[i] = static_cast<float>(samples->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return MesoMakeVolume(shape.Size, shape.Depth, distances);
}

#include "BakeSearchMap.h"

#include "MesoBakedFile.h"
#include "vtkImageData.h"
#include "vtkMesoConeMap.h"
#include "vtkMesoMaximumMip.h"

#include <CLI/CLI.hpp>

void BakeSearchMap::AddOptions(CLI::App& command)
{
  command.description(this->GetDescription());
  this->Input.AddOptions(command);
  this->Output.AddOptions(command, "Baked file to write, ending in .vti");
  const std::string name = this->GetName();
  command.footer("Example: meso bake " + name + " stone.png -o stone." + name + ".vti");
}

void BakeSearchMap::Run()
{
  this->Output.Check({ this->Input.GetFileName() });
  const vtkSmartPointer<vtkMesoHeightMapAlgorithm> filter = this->MakeFilter();
  filter->SetInputData(this->Input.Read());
  filter->SetWrap(this->Input.GetWrap());
  this->Output.Update(filter);
  MesoBaked baked;
  baked.Kind = this->GetName();
  baked.Parameters["wrap"] = MesoName(this->Input.GetWrap());
  baked.Table = filter->GetOutput();
  MesoWriteBaked(this->Output.GetFileName(), baked);
  this->Output.WriteStats(this->GetName(), baked.Table);
}

const char* BakeCone::GetDescription() const
{
  return "A height map's cones of free space, by which rays take long steps.";
}

vtkSmartPointer<vtkMesoHeightMapAlgorithm> BakeCone::MakeFilter() const
{
  return vtkSmartPointer<vtkMesoConeMap>::New();
}

const char* BakeMaximumMip::GetDescription() const
{
  return "The pyramid of a height map's maxima over blocks of 1, 2, 4, ... texels.";
}

vtkSmartPointer<vtkMesoHeightMapAlgorithm> BakeMaximumMip::MakeFilter() const
{
  return vtkSmartPointer<vtkMesoMaximumMip>::New();
}

#include "BakeHorizon.h"

#include "MesoBakedFile.h"
#include "vtkImageData.h"
#include "vtkMesoHorizonMap.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

void BakeHorizon::AddOptions(CLI::App& command)
{
  command.description(
    "How high a height map's relief stands around each texel, and how much of the sky "
    "it leaves.");
  this->Input.AddOptions(command);
  this->Output.AddOptions(command, "Baked file to write (.vti)");
  command.add_option("--azimuths", this->Azimuths, "Directions, evenly spaced (default: 32)")
    ->check(CLI::Range(4, 360));
  command
    .add_option("--scale", this->Scale,
      "Depth of the deepest point in widths of a tile, which angles are measured over (default: "
      "0.1)")
    ->check(CLI::Range(1e-6, 1e6));
  command.add_option("--reach", this->Reach, "How far is looked, in tiles (default: 2)")
    ->check(CLI::Range(0.1, 16.));
  command.footer("Example: meso bake horizon stone.png -o stone.horizon.vti --azimuths 16");
}

void BakeHorizon::Run()
{
  this->Output.Check({ this->Input.GetFileName() });
  vtkNew<vtkMesoHorizonMap> filter;
  filter->SetInputData(this->Input.Read());
  filter->SetWrap(this->Input.GetWrap());
  filter->SetAzimuths(this->Azimuths);
  filter->SetScale(this->Scale);
  filter->SetReach(this->Reach);
  this->Output.Update(filter);

  MesoBaked baked;
  baked.Kind = this->GetName();
  baked.Parameters["azimuths"] = std::vector<double>{ double(this->Azimuths) };
  baked.Parameters["scale"] = std::vector<double>{ this->Scale };
  baked.Parameters["reach"] = std::vector<double>{ this->Reach };
  baked.Parameters["wrap"] = std::string(MesoName(this->Input.GetWrap()));
  baked.Table = filter->GetOutput();
  MesoWriteBaked(this->Output.GetFileName(), baked);
  this->Output.WriteStats(this->GetName(), baked.Table);
}

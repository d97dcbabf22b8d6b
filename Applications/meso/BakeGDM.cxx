#include "BakeGDM.h"

#include "CommandLine.h"
#include "MesoBakedFile.h"
#include "MesoGDMInput.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGDMTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>

void BakeGDM::AddOptions(CLI::App& command)
{
  command.description("How far the solid of a volume is from every point, in every direction.");
  this->Volume.AddOptions(command);
  this->Output.AddOptions(command, "Baked file to write (.vti)");
  command.add_option_function<std::string>(
    "--directions",
    [this](const std::string& text)
    {
      this->Directions = ParseSize("--directions", text);
      if (this->Directions[0] > 360 || this->Directions[1] < 2 || this->Directions[1] > 360)
      {
        throw CLI::ValidationError("--directions", "'" + text + "' is not within 1x2 and 360x360");
      }
    },
    "PHIxTHETA: directions around z and from +z to -z (default: 16x32)");
  AddChoice(command, "--spread", "angles", "sphere", this->Even,
    "Directions at equal steps of theta (angles, the default) or of its cosine, evenly over the "
    "sphere");
  command
    .add_option("--rank", this->Rank, "Products that are kept (default: 16); 0: the whole table")
    ->check(CLI::Range(0, 64));
  command.add_option("--bits", this->Bits, "8, 16 (default) or 32 for float, of weights or table")
    ->check(CLI::IsMember({ 8, 16, 32 }));
  command.add_option("--reach", this->Reach, "The largest distance, in tile widths (default: 8)")
    ->check(CLI::Range(0.1, 64.));
  command.add_flag("--exact", this->Exact, "Follow each ray by itself: slower");
  command.add_flag("--cautious", this->Cautious,
    "Nearer hits of the directions beside: for wires that are thin, as scenes have it from low to "
    "high");
  command.add_flag("--json", this->Json, "Print what was found as JSON");
  command.footer("Example: meso bake gdm weave -o weave.gdm.vti --size 64x64x32 --rank 16");
}

void BakeGDM::Run()
{
  const MesoSceneVolume& volume = this->Volume.Resolve();
  this->Output.Check(
    volume.File.empty() ? std::vector<std::string>() : std::vector<std::string>{ volume.File });
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(this->Volume.Read());
  table->SetAzimuths(this->Directions[0]);
  table->SetPolars(this->Directions[1]);
  table->SetEven(this->Even);
  table->SetReach(this->Reach);
  table->SetRank(this->Rank);
  table->SetBits(this->Bits);
  table->SetExact(this->Exact);
  table->SetCautious(this->Cautious);
  this->Output.Update(table);
  vtkImageData* image = table->GetOutput();
  MesoWriteBaked(this->Output.GetFileName(), MesoBakedGDM(table));
  this->Output.WriteStats(this->GetName(), image);

  // What a renderer holds: the weights or the whole table, and the functions.
  std::size_t bytes = image->GetPointData()->GetScalars()->GetNumberOfValues() *
    std::size_t(image->GetPointData()->GetScalars()->GetDataTypeSize());
  if (vtkDataArray* functions = image->GetFieldData()->GetArray("MesoGDMFunctions"))
  {
    bytes += std::size_t(functions->GetNumberOfValues()) * sizeof(float);
  }
  nlohmann::ordered_json report;
  report["bytes"] = bytes;
  report["rays_followed"] = table->GetFollowedPart();
  report["rms_left_by_rank"] = table->GetFactorErrors();
  if (this->Json)
  {
    std::cout << report.dump(2) << "\n";
    return;
  }
  std::cout << "table: " << bytes << " bytes";
  if (!table->GetFactorErrors().empty())
  {
    std::cout << ", " << table->GetFactorErrors().size() << " products leave "
              << table->GetFactorErrors().back() << " tile widths (RMS)";
  }
  std::cout << "\n";
}

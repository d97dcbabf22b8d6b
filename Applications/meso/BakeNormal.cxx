#include "BakeNormal.h"

#include "BakeImages.h"
#include "CommandLine.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMesoNormalMap.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>

namespace
{
std::array<double, 2> ParseTileSize(const std::string& text)
{
  const auto size = ParsePair(text);
  if (!size || !((*size)[0] > 0.) || !((*size)[1] > 0.))
  {
    throw CLI::ValidationError(
      "--tile-size", "'" + text + "' is no pair of lengths above 0 such as 1,0.5");
  }
  return *size;
}
}

void BakeNormal::AddOptions(CLI::App& command)
{
  command.description("A height map's normals in tangent space, as an image.");
  this->Input.AddOptions(command);
  this->Output.AddOptions(
    command, "Normal map to write: .png, .tif (8 or 16 bit), .exr or .tif (float)");
  command
    .add_option("--scale", this->Scale,
      "Depth of the deepest point, in the unit of --tile-size (default: 0.1)")
    ->check(CLI::NonNegativeNumber);
  command.add_option_function<std::string>(
    "--tile-size", [this](const std::string& text) { this->TileSize = ParseTileSize(text); },
    "Lengths of a tile along u and v (default: 1,1)");
  AddChoice(command, "--y", "up", "down", this->IsYDown,
    "Which way green points: up (OpenGL, the default) or down (DirectX)");
  command.add_option("--bits", this->Bits, "8, 16, or 32 for float (default: 8)")
    ->check(CLI::IsMember({ 8, 16, 32 }));
  command.footer("Example: meso bake normal stone.png -o stone_normal.png --scale 0.05");
}

void BakeNormal::Run()
{
  this->Output.Check({ this->Input.GetFileName() });
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(this->Input.Read());
  filter->SetWrap(this->Input.GetWrap());
  filter->SetScale(this->Scale);
  filter->SetTileSize(this->TileSize.data());
  this->Output.Update(filter);

  vtkImageData* normals = filter->GetOutput();
  if (this->IsYDown)
  {
    vtkDataArray* tuples = normals->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < tuples->GetNumberOfTuples(); ++i)
    {
      tuples->SetComponent(i, 1, -tuples->GetComponent(i, 1));
    }
  }
  constexpr double half = 0.5; // [-1,1] -> [0,1]
  BakeWriteImage(this->Output.GetFileName(), normals, "Normal", this->Bits, half, half);
  this->Output.WriteStats(this->GetName(), normals);
}

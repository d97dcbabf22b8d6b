#include "BakeNormal.h"

#include "CommandLine.h"
#include "MesoImageFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMesoNormalMap.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <vector>

namespace
{
std::array<double, 2> ParseTileSize(const std::string& text)
{
  std::array<double, 2> size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &size[0], &size[1], &rest) != 2 || !(size[0] > 0.) ||
    !(size[1] > 0.))
  {
    throw CLI::ValidationError(
      "--tile-size", "'" + text + "' is no pair of lengths above 0 such as 1,0.5");
  }
  return size;
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
  command.add_option_function<std::string>(
    "--y",
    [this](const std::string& text)
    {
      if (text != "up" && text != "down")
      {
        throw CLI::ValidationError("--y", "'" + text + "' is none of up, down");
      }
      this->IsYUp = text == "up";
    },
    "Which way green points: up (OpenGL, the default) or down (DirectX)");
  command.add_option("--bits", this->Bits, "8, 16, or 32 for float (default: 8)")
    ->check(CLI::IsMember({ 8, 16, 32 }));
  command.footer("Example: meso bake normal stone.png -o stone_normal.png --scale 0.05");
}

void BakeNormal::Run()
{
  this->Output.Check(this->Input.GetFileName());
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(this->Input.Read());
  filter->SetWrap(this->Input.GetWrap());
  filter->SetScale(this->Scale);
  filter->SetTileSize(this->TileSize.data());
  this->Output.Update(filter);

  vtkImageData* normals = filter->GetOutput();
  vtkDataArray* tuples = normals->GetPointData()->GetScalars();
  const int width = normals->GetDimensions()[0];
  const int height = normals->GetDimensions()[1];
  std::vector<float> values;
  values.reserve(std::size_t(width) * height * 3);
  for (int row = height - 1; row >= 0; --row)
  {
    for (int column = 0; column < width; ++column)
    {
      double normal[3];
      tuples->GetTuple(vtkIdType(row) * width + column, normal);
      normal[1] = this->IsYUp ? normal[1] : -normal[1];
      for (const double component : normal)
      {
        values.push_back(static_cast<float>(0.5 * component + 0.5));
      }
    }
  }
  using Type = MesoImageHeader::Type;
  const Type type = this->Bits == 8 ? Type::UnsignedChar
    : this->Bits == 16              ? Type::UnsignedShort
                                    : Type::Float;
  MesoWriteImage(this->Output.GetFileName(), width, height, 3, type, values.data());
  this->Output.WriteStats(this->GetName(), normals);
}

#include "BakeFromMesh.h"

#include "BakeImages.h"
#include "CommandLine.h"
#include "MesoAlgorithmRun.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoMapFromMesh.h"
#include "vtkMesoMeshReader.h"
#include "vtkMesoPrincipalCurvatures.h"
#include "vtkMesoSurfaceFrames.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace
{
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName)
{
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(fileName.c_str());
  std::vector<std::string> warnings;
  MesoRunAlgorithm(reader, fileName, warnings);
  return reader->GetOutput();
}

constexpr double NormalFactor = 0.5; // [-1,1] -> [0,1]
constexpr double ByteFactor = 1. / 255.;
constexpr int ByteBits = 8;
}

void BakeFromMesh::AddOptions(CLI::App& command)
{
  command.description("The maps that make a coarse mesh look like a detailed one.");
  command.add_option("DETAIL", this->DetailFile, "Mesh with the detail")->required();
  command.add_option("BASE", this->BaseFile, "Coarse mesh whose texture coordinates are an atlas")
    ->required();
  this->Output.AddOptions(command, "Height map to write: .png, .tif (8, 16 bit) or .exr (float)");
  AddSizeOption(command, this->Size);
  command.add_option("--bits", this->Bits, "8 or 16, of what is no .exr (default: 16)")
    ->check(CLI::IsMember({ 8, 16 }));
  command
    .add_option("--reach", this->Reach,
      "How far from the base the detail may be (default: a tenth of the detail's diagonal)")
    ->check(CLI::PositiveNumber);
  command
    .add_option("--feature-angle", this->FeatureAngle,
      "Edges of the base that are sharper split its normals, as in a scene file")
    ->check(CLI::Range(0., 180.));
  AddChoice(command, "--correspondence", "rays", "texture", this->ByTexture,
    "How a point of the detail is found: along the base's normals (rays, the default), or by "
    "equal texture coordinates (texture)");
  AddChoice(command, "--rays", "interpolated", "geometric", this->GeometricNormals,
    "Normals that rays follow: those of the vertices, interpolated (the default), or the "
    "triangles' own");
  command
    .add_option("--slope-limit", this->SlopeLimit,
      "A jump of this many times the distance of neighbouring texels is a fold (default: 8)")
    ->check(CLI::PositiveNumber);
  command.add_option("--normal", this->NormalFile, "Normal map in tangent space");
  command.add_option("--normal-object", this->NormalObjectFile, "Normal map in object space");
  command
    .add_option("--curvature", this->CurvatureFile,
      "The detail's c_max and c_min, 1 / length, a float image (.exr)")
    ->check(
      [](const std::string& name)
      {
        const bool isExr = std::filesystem::path(name).extension() == ".exr";
        return isExr ? std::string() : "'" + name + "' is no file name that ends in .exr";
      });
  command.add_option("--state", this->StateFile,
    "Mask, .png: 0 no chart, 85 met, 170 void (filled from around it), 255 folded over");
  command.add_option_function<std::vector<std::string>>(
    "--array",
    [this](const std::vector<std::string>& texts)
    {
      for (const std::string& text : texts)
      {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        {
          throw CLI::ValidationError("--array", "'" + text + "' is no NAME=FILE");
        }
        this->Arrays.emplace_back(text.substr(0, equals), text.substr(equals + 1));
      }
    },
    "NAME=FILE: a point array of the detail, such as colors, as a map; may be repeated");
  command.add_flag("--json", this->Json, "Print what was found as JSON");
  command.footer(
    "Example: meso bake from-mesh fine.obj coarse.obj -o height.png --normal normal.png");
}

vtkSmartPointer<vtkPolyData> BakeFromMesh::ReadBase() const
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(this->BaseFile);
  if (!mesh->GetPointData()->GetTCoords())
  {
    throw MesoInputError(this->BaseFile +
      ": has no texture coordinates, by which maps are laid over it: unwrap it first (an atlas in "
      "[0,1] x [0,1])");
  }
  vtkNew<vtkMesoSurfaceFrames> frames; // normals as they will be when the map is drawn
  frames->SetInputData(mesh);
  if (this->FeatureAngle)
  {
    frames->SplitNormalsOn();
    frames->SetFeatureAngle(*this->FeatureAngle);
  }
  std::vector<std::string> warnings;
  MesoRunAlgorithm(frames, this->BaseFile, warnings);
  return frames->GetOutput();
}

vtkSmartPointer<vtkPolyData> BakeFromMesh::ReadDetail() const
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(this->DetailFile);
  if (this->CurvatureFile.empty())
  {
    return mesh;
  }
  vtkNew<vtkMesoPrincipalCurvatures> curvatures;
  curvatures->SetInputData(mesh);
  std::vector<std::string> warnings;
  MesoRunAlgorithm(curvatures, this->DetailFile, warnings);
  return curvatures->GetOutput();
}

void BakeFromMesh::WriteHeights(vtkImageData* maps, const Range& range) const
{
  const double depth = range.High - range.Low;
  vtkDataArray* displacements = maps->GetPointData()->GetArray("Displacement");
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  heights->SetNumberOfValues(displacements->GetNumberOfTuples());
  for (vtkIdType i = 0; i < displacements->GetNumberOfTuples(); ++i)
  {
    const double height =
      depth > 0. ? (displacements->GetTuple1(i) - range.Low) / depth : 1.; // on the base
    heights->SetValue(i, static_cast<float>(std::clamp(height, 0., 1.)));
  }
  maps->GetPointData()->AddArray(heights);
  const std::string& file = this->Output.GetFileName();
  BakeWriteImage(file, maps, "Height", BakeBitsFor(file, this->Bits));
}

void BakeFromMesh::Report(vtkMesoMapFromMesh* maps, const Range& range) const
{
  const double depth = range.High - range.Low;
  nlohmann::ordered_json report;
  report["scale"] = depth;
  report["reference"] = depth > 0. ? -range.Low / depth : 1.;
  report["met_texels"] = maps->GetNumberOfMetTexels();
  report["void_texels"] = maps->GetNumberOfVoidTexels();
  report["fold_texels"] = maps->GetNumberOfFoldTexels();
  report["overlapping_texels"] = maps->GetNumberOfOverlappingTexels();
  if (this->ByTexture)
  {
    report["largest_drift"] = maps->GetLargestDrift();
  }
  if (this->Json)
  {
    std::cout << report.dump(2) << "\n";
    return;
  }
  std::cout << "in the scene: \"height_map\": \"" << this->Output.GetFileName()
            << "\", \"scale\": " << report["scale"] << ", \"reference\": " << report["reference"]
            << "\n"
            << "texels: " << report["met_texels"] << " met, " << report["void_texels"] << " void, "
            << report["fold_texels"] << " folded over, " << report["overlapping_texels"]
            << " under several triangles\n";
  if (this->ByTexture)
  {
    std::cout << "off the normals by up to " << report["largest_drift"] << "\n";
  }
}

void BakeFromMesh::Run()
{
  std::vector<std::string> results = { this->NormalFile, this->NormalObjectFile,
    this->CurvatureFile, this->StateFile };
  vtkNew<vtkMesoMapFromMesh> maps;
  for (const auto& [name, file] : this->Arrays)
  {
    maps->AddDetailArray(name);
    results.push_back(file);
  }
  this->Output.Check({ this->DetailFile, this->BaseFile }, results);
  maps->SetInputData(this->ReadBase());
  const vtkSmartPointer<vtkPolyData> detail = this->ReadDetail();
  maps->SetDetailData(detail);
  maps->SetSize(this->Size.data());
  maps->SetReach(this->Reach);
  maps->SetSlopeLimit(this->SlopeLimit);
  maps->SetCorrespondence(this->ByTexture ? vtkMesoMapFromMesh::Texture : vtkMesoMapFromMesh::Rays);
  maps->SetGeometricNormals(this->GeometricNormals);
  if (!this->CurvatureFile.empty())
  {
    maps->AddDetailArray("MesoCurvature");
  }
  this->Output.Update(maps);

  vtkImageData* image = maps->GetOutput();
  const double* displacements = maps->GetDisplacementRange();
  const Range range = { std::min(0., displacements[0]), std::max(0., displacements[1]) };
  this->WriteHeights(image, range);
  const std::pair<std::string, const char*> directions[] = { { this->NormalFile, "Normal" },
    { this->NormalObjectFile, "NormalObject" } };
  for (const auto& [file, array] : directions)
  {
    if (!file.empty())
    {
      BakeWriteImage(file, image, array, BakeBitsFor(file, this->Bits), NormalFactor, NormalFactor);
    }
  }
  if (!this->CurvatureFile.empty())
  {
    BakeWriteImage(
      this->CurvatureFile, image, "MesoCurvature", BakeBitsFor(this->CurvatureFile, this->Bits));
  }
  if (!this->StateFile.empty())
  {
    BakeWriteImage(this->StateFile, image, "State", ByteBits, 1. / 3.);
  }
  for (const auto& [name, file] : this->Arrays)
  {
    const auto* detail = vtkPolyData::SafeDownCast(maps->GetInputDataObject(1, 0));
    const bool isBytes =
      const_cast<vtkPolyData*>(detail)->GetPointData()->GetArray(name.c_str())->GetDataType() ==
      VTK_UNSIGNED_CHAR;
    BakeWriteImage(file, image, name, BakeBitsFor(file, ByteBits), isBytes ? ByteFactor : 1.);
  }
  this->Output.WriteStats(this->GetName(), image);
  this->Report(maps, range);
}

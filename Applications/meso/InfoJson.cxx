#include "InfoJson.h"

#include "InfoPolarity.h"
#include "InfoScene.h"
#include "InfoVolume.h"
#include "MesoBakedFile.h"
#include "MesoDemFile.h"
#include "MesoFileBytes.h"
#include "MesoImageReport.h"
#include "MesoMeshFormats.h"
#include "MesoMeshReport.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoMeshReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
using Json = nlohmann::ordered_json;

Json JsonOfChart(const MesoChartReport& chart)
{
  Json json;
  json["least"] = chart.Least;
  json["most"] = chart.Most;
  json["object_units_a_unit"] = chart.Scale;
  json["charts"] = chart.Charts;
  json["seam_edges"] = chart.SeamEdges;
  json["mirrored_triangles"] = chart.Mirrored;
  json["degenerate_triangles"] = chart.Degenerate;
  json["overlap"] = chart.Overlap ? Json(*chart.Overlap) : Json();
  return json;
}

void WarnOfMesh(const MesoMeshReport& report, Json& warnings)
{
  const auto warn = [&](std::size_t count, const std::string& what)
  {
    if (count > 0)
    {
      warnings.push_back(std::to_string(count) + " " + what);
    }
  };
  warn(report.NonManifoldEdges, "edges have three triangles or more");
  warn(report.NonManifoldVertices, "vertices join triangles that share no edge there");
  warn(report.TurnedEdges, "edges have triangles of opposite winding");
  warn(report.Degenerate, "triangles have no area");
  warn(report.Duplicate, "triangles are there twice");
  if (report.Volume && *report.Volume < 0.)
  {
    warnings.push_back("the surface is inside out: front faces look inward");
  }
  if (report.Chart)
  {
    warn(report.Chart->Degenerate, "triangles have no area in texture space: no relief there");
    if (report.Chart->Mirrored > 0 && report.Chart->Mirrored < report.Triangles)
    {
      warn(report.Chart->Mirrored, "triangles are mirrored in texture space");
    }
    if (report.Chart->Overlap.value_or(0.) > 0.01)
    {
      warnings.push_back("charts overlap: a place of the map is on several parts of the surface");
    }
  }
}

Json JsonOfMesh(const std::string& fileName)
{
  vtkNew<vtkMesoMeshReader> reader;
  vtkNew<vtkCallbackCommand> quiet; // what it says is in GetErrorMessage() and GetNotes()
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->AddObserver(vtkCommand::WarningEvent, quiet);
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (!reader->GetErrorMessage().empty())
  {
    throw MesoInputError(reader->GetErrorMessage());
  }
  vtkPolyData* mesh = reader->GetOutput();
  const MesoMeshReport report = MesoReportMesh(mesh);
  Json json;
  json["file"] = fileName;
  json["kind"] = "mesh";
  json["points"] = report.Points;
  json["vertices"] = report.Vertices;
  json["triangles"] = report.Triangles;
  json["least"] = report.Least;
  json["most"] = report.Most;
  json["diagonal"] = std::hypot(report.Most[0] - report.Least[0], report.Most[1] - report.Least[1],
    report.Most[2] - report.Least[2]);
  json["positions"] = report.IsDouble ? "double" : "float";
  json["normals"] = report.HasNormals;
  json["components"] = report.Components;
  json["boundary_edges"] = report.BoundaryEdges;
  json["non_manifold_edges"] = report.NonManifoldEdges;
  json["non_manifold_vertices"] = report.NonManifoldVertices;
  json["sheets"] = static_cast<std::size_t>(reader->GetNumberOfSheets());
  json["edges_of_opposite_winding"] = report.TurnedEdges;
  json["degenerate_triangles"] = report.Degenerate;
  json["duplicate_triangles"] = report.Duplicate;
  json["volume"] = report.Volume ? Json(*report.Volume) : Json();
  json["texture_coordinates"] = report.Chart ? JsonOfChart(*report.Chart) : Json("none");
  Json arrays = Json::array();
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const char* name = mesh->GetPointData()->GetArrayName(i);
    const std::string text = name ? name : "";
    if (text != "MesoVertex" && text != "Normals" && text != "TextureCoordinates")
    {
      arrays.push_back(text);
    }
  }
  json["point_arrays"] = arrays;
  json["warnings"] = reader->GetNotes();
  WarnOfMesh(report, json["warnings"]);
  return json;
}

Json JsonOfImage(const std::string& fileName)
{
  const MesoImageReport report = MesoReportImage(fileName);
  Json json;
  json["file"] = fileName;
  json["kind"] = "image";
  json["format"] = report.Format;
  json["size"] = { report.Width, report.Height };
  json["values"] = report.StoredType;
  Json channels = Json::array();
  std::size_t notFinite = 0;
  for (const MesoChannelReport& channel : report.Channels)
  {
    channels.push_back({ { "name", channel.Name }, { "least", channel.Least },
      { "most", channel.Most }, { "mean", channel.Mean }, { "not_finite", channel.NotFinite } });
    notFinite += channel.NotFinite;
  }
  json["channels"] = channels;
  json["over_the_border_in_u"] = JsonOfTiling(report.Tiling[0]);
  json["over_the_border_in_v"] = JsonOfTiling(report.Tiling[1]);
  json["color_profile"] = report.HasColorProfile ? "there is one, and it is left alone" : "none";
  json["polarity"] = JsonOfPolarity(fileName);
  json["warnings"] = report.Notes;
  if (notFinite > 0)
  {
    json["warnings"].push_back(
      std::to_string(notFinite) + " values are not finite: as a map the image is refused");
  }
  return json;
}

Json JsonOfDem(const std::string& fileName)
{
  const MesoDem dem =
    MesoParseDem(MesoReadBytes(fileName, MesoLargestDemFile, "an elevation file"), fileName);
  Json json;
  json["file"] = fileName;
  json["kind"] = "elevations";
  json["title"] = dem.Title;
  json["size"] = { dem.Width, dem.Height };
  json["sample_spacing"] = dem.Spacing;
  json["extent"] = { dem.Width * dem.Spacing[0], dem.Height * dem.Spacing[1] };
  json["range"] = dem.Range;
  json["scale_in_true_proportion"] = dem.Range[1] - dem.Range[0];
  json["unit"] = "metre";
  json["warnings"] = dem.Notes;
  return json;
}

Json JsonOfBaked(const std::string& fileName)
{
  const MesoBaked baked = MesoReadBaked(fileName);
  Json json;
  json["file"] = fileName;
  json["kind"] = "baked table";
  json["table"] = baked.Kind;
  json["layout"] = MesoBakedFormat;
  json["checksum"] = "right"; // else it would not have been read
  int size[3];
  baked.Table->GetDimensions(size);
  json["size"] = size;
  Json parameters = Json::object();
  for (const auto& [name, value] : baked.Parameters)
  {
    std::visit([&, key = name](const auto& content) { parameters[key] = content; }, value);
  }
  json["parameters"] = parameters;
  Json arrays = Json::array();
  const auto add = [&](vtkAbstractArray* array)
  {
    Json entry;
    entry["name"] = array->GetName() ? array->GetName() : "";
    entry["type"] = array->GetDataTypeAsString();
    entry["components"] = array->GetNumberOfComponents();
    entry["tuples"] = static_cast<std::int64_t>(array->GetNumberOfTuples());
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      double range[2];
      numbers->GetRange(range, -1);
      entry["range_of_magnitude"] = { range[0], range[1] };
    }
    arrays.push_back(entry);
  };
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(baked.Table->GetPointData()), baked.Table->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      add(data->GetAbstractArray(i));
    }
  }
  json["arrays"] = arrays;
  json["warnings"] = Json::array();
  return json;
}
}

nlohmann::ordered_json JsonOfFile(const std::string& fileName)
{
  const std::string extension = MesoExtensionOf(fileName);
  const auto& meshes = MesoMeshExtensions();
  if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end())
  {
    return JsonOfMesh(fileName);
  }
  return extension == ".json" ? JsonOfScene(fileName)
    : extension == ".dem"     ? JsonOfDem(fileName)
    : IsVolume(fileName)      ? JsonOfVolume(fileName)
    : extension == ".vti"     ? JsonOfBaked(fileName)
                              : JsonOfImage(fileName);
}

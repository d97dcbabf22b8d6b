#include "vtk_glew.h" // must come first

#include "MesoVertexAttributes.h"

#include "MesoTechniqueShader.h"
#include "vtkDataArray.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

std::string MesoVertexAttributes::Missing(vtkPolyData* input, const MesoShaderShape& shape)
{
  vtkPointData* points = input->GetPointData();
  std::string missing;
  if (!points->GetNormals() || !points->GetNormals()->GetName())
  {
    missing += " named normals";
  }
  if (!points->GetTCoords() || !points->GetTCoords()->GetName() ||
    points->GetTCoords()->GetNumberOfComponents() != 2)
  {
    missing += " named texture coordinates (2 components)";
  }
  for (const auto& attribute : shape.Attributes)
  {
    if (!points->GetArray(attribute.second.c_str()))
    {
      missing += " " + attribute.second;
    }
  }
  return missing;
}

void MesoVertexAttributes::Map(
  vtkOpenGLPolyDataMapper* mapper, vtkPolyData* input, const MesoShaderShape& shape)
{
  vtkPointData* points = input->GetPointData();
  std::map<std::string, std::string> wanted;
  const auto want = [&](const std::string& attribute, vtkDataArray* array)
  {
    if (array && array->GetName())
    {
      wanted[attribute] = array->GetName();
    }
  };
  want("mesoTCoord", points->GetTCoords());
  want("mesoNormal", points->GetNormals());
  for (const auto& attribute : shape.Attributes)
  {
    want(attribute.first, points->GetArray(attribute.second.c_str()));
  }
  for (const auto& attribute : this->Mapped)
  {
    if (!wanted.count(attribute.first))
    {
      mapper->RemoveVertexAttributeMapping(attribute.first.c_str());
    }
  }
  for (const auto& attribute : wanted)
  {
    const auto mapped = this->Mapped.find(attribute.first);
    if (mapped == this->Mapped.end() || mapped->second != attribute.second)
    {
      mapper->MapDataArrayToVertexAttribute(
        attribute.first.c_str(), attribute.second.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
    }
  }
  this->Mapped = wanted;
}

void MesoVertexAttributes::Clear(vtkOpenGLPolyDataMapper* mapper)
{
  for (const auto& attribute : this->Mapped)
  {
    mapper->RemoveVertexAttributeMapping(attribute.first.c_str());
  }
  this->Mapped.clear();
}

std::vector<std::string> MesoVertexAttributes::Names() const
{
  std::vector<std::string> names;
  for (const auto& attribute : this->Mapped)
  {
    names.push_back(attribute.first);
  }
  return names;
}

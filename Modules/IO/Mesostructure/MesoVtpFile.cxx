#include "MesoVtpFile.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"
#include "MesoVtkXml.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Throws where a piece has more points or cells than the file can hold: VTK takes memory for them
/// before it reads.
void CheckCounts(const std::string& bytes, const std::string& fileName)
{
  std::size_t place = 0;
  while ((place = bytes.find("NumberOf", place)) != std::string::npos)
  {
    const std::size_t nameEnd = bytes.find('=', place);
    if (nameEnd == std::string::npos || nameEnd > place + 40)
    {
      ++place;
      continue;
    }
    const std::string name = bytes.substr(place, nameEnd - place);
    place = nameEnd;
    const bool isCount = name == "NumberOfPoints" || name == "NumberOfPolys" ||
      name == "NumberOfStrips" || name == "NumberOfLines" || name == "NumberOfVerts" ||
      name == "NumberOfTuples" || name == "NumberOfComponents";
    if (!isCount)
    {
      continue;
    }
    const std::size_t begin = nameEnd + 2;
    const std::size_t end =
      bytes.find(nameEnd + 1 < bytes.size() ? bytes[nameEnd + 1] : '"', begin);
    const std::string text = end == std::string::npos ? "" : bytes.substr(begin, end - begin);
    std::int64_t count = 0;
    const std::string problem = MesoReadInteger(text, count);
    if (!problem.empty() || count < 0 ||
      static_cast<std::uintmax_t>(count) > bytes.size() * MesoXmlMostBytesOfOne)
    {
      throw MesoInputError(fileName + ": byte " + std::to_string(nameEnd) + ": " +
        MesoPrintable(name + " " +
          (problem.empty() ? std::to_string(count) + " is more than the file can hold" : problem)));
    }
  }
}

class Converter
{
public:
  Converter(vtkPolyData* mesh, const std::string& fileName)
    : Mesh(mesh)
    , FileName(fileName)
  {
    this->File.PlaceName = "face";
  }

  MesoMeshFile Convert()
  {
    const vtkIdType points = this->Mesh->GetNumberOfPoints();
    if (points > INT32_MAX)
    {
      this->Fail("has more points than 2^31");
    }
    if (points > 0)
    {
      this->Copy(this->Mesh->GetPoints()->GetData(), "position", this->File.Positions);
    }
    vtkPointData* data = this->Mesh->GetPointData();
    vtkDataArray* normals = data->GetNormals();
    vtkDataArray* texture = data->GetTCoords();
    for (const char* name : { "TextureCoordinates", "TCoords", "Texture Coordinates" })
    {
      texture = texture ? texture : data->GetArray(name);
    }
    texture = texture && texture->GetNumberOfComponents() >= 2 ? texture : nullptr;
    normals = normals && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
    if (normals)
    {
      this->Copy(normals, "normal", this->File.Normals);
    }
    if (texture)
    {
      this->Copy(texture, "texture coordinate", this->File.TextureCoordinates);
    }
    this->AddCells(this->Mesh->GetPolys(), false);
    this->AddCells(this->Mesh->GetStrips(), true);
    this->KeepArrays(normals, texture);
    if (this->File.NumberOfFaces() == 0)
    {
      this->Fail("holds no faces");
    }
    return std::move(this->File);
  }

private:
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(this->FileName + ": " + MesoPrintable(reason));
  }

  template <std::size_t N>
  void Copy(vtkDataArray* array, const char* what, std::vector<std::array<double, N>>& target) const
  {
    const vtkIdType count = this->Mesh->GetNumberOfPoints();
    if (array->GetNumberOfTuples() != count)
    {
      this->Fail("has " + std::to_string(array->GetNumberOfTuples()) + " tuples of " + what +
        " for " + std::to_string(count) + " points");
    }
    target.resize(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      for (std::size_t k = 0; k < N; ++k)
      {
        target[i][k] = array->GetComponent(i, static_cast<int>(k));
        if (!(std::abs(target[i][k]) <= MesoMeshLargestNumber))
        {
          this->Fail(
            std::string(what) + " of point " + std::to_string(i) + " is not finite or beyond 1e30");
        }
      }
    }
  }

  void AddCells(vtkCellArray* cells, bool isStrip)
  {
    const char* const what = isStrip ? "strip " : "polygon ";
    vtkDataArray* offsets = cells->GetOffsetsArray();
    vtkDataArray* connectivity = cells->GetConnectivityArray();
    const auto length = static_cast<double>(connectivity->GetNumberOfTuples());
    for (vtkIdType i = 0; i + 1 < offsets->GetNumberOfTuples(); ++i)
    {
      const double begin = offsets->GetComponent(i, 0);
      const double end = offsets->GetComponent(i + 1, 0);
      if (!(begin >= 0. && begin <= end && end <= length))
      {
        this->Fail(what + std::to_string(i) + ": its corners go from " + MesoNumberText(begin) +
          " to " + MesoNumberText(end) + " of " + MesoNumberText(length));
      }
      this->Cell.clear();
      for (auto k = static_cast<vtkIdType>(begin); k < static_cast<vtkIdType>(end); ++k)
      {
        this->Cell.push_back(this->Corner(connectivity->GetComponent(k, 0), what, i));
      }
      if (this->Cell.size() < 3 || (!isStrip && this->Cell.size() > MesoMeshMostCorners))
      {
        this->Fail(what + std::to_string(i) + " has " + std::to_string(this->Cell.size()) +
          " corners, " +
          (this->Cell.size() < 3 ? "fewer than 3"
                                 : "more than " + std::to_string(MesoMeshMostCorners)));
      }
      if (!isStrip)
      {
        this->File.Corners.insert(this->File.Corners.end(), this->Cell.begin(), this->Cell.end());
        this->File.CloseFace(this->File.NumberOfFaces());
        continue;
      }
      for (std::size_t k = 0; k + 2 < this->Cell.size(); ++k)
      {
        const std::size_t turn = k % 2;
        this->File.Corners.push_back(this->Cell[k + turn]);
        this->File.Corners.push_back(this->Cell[k + 1 - turn]);
        this->File.Corners.push_back(this->Cell[k + 2]);
        this->File.CloseFace(this->File.NumberOfFaces());
      }
    }
  }

  MesoMeshCorner Corner(double id, const char* what, vtkIdType cell) const
  {
    const std::size_t count = this->File.Positions.size();
    if (!(id >= 0. && id < static_cast<double>(count)))
    {
      this->Fail(what + std::to_string(cell) + ": there is no point " + MesoNumberText(id) +
        " (there are " + std::to_string(count) + ", from 0)");
    }
    const auto index = static_cast<std::int32_t>(id);
    return { index, this->File.TextureCoordinates.empty() ? -1 : index,
      this->File.Normals.empty() ? -1 : index };
  }

  void KeepArrays(vtkDataArray* normals, vtkDataArray* texture)
  {
    auto& notes = this->File.Notes;
    const vtkIdType others = this->Mesh->GetNumberOfVerts() + this->Mesh->GetNumberOfLines();
    if (others > 0)
    {
      notes.push_back(std::to_string(others) + " points and lines are left out");
    }
    vtkCellData* cellData = this->Mesh->GetCellData();
    if (cellData->GetNumberOfArrays() > 0)
    {
      notes.push_back(std::to_string(cellData->GetNumberOfArrays()) +
        " arrays of cells are not used (first \"" +
        MesoPrintable(cellData->GetAbstractArray(0)->GetName()
            ? cellData->GetAbstractArray(0)->GetName()
            : "") +
        "\")");
    }
    this->File.PointData = vtkSmartPointer<vtkPointData>::New();
    vtkPointData* data = this->Mesh->GetPointData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i); // null where it is of texts
      const bool isKept = array && array != normals && array != texture && array->GetName() &&
        array->GetNumberOfTuples() == this->Mesh->GetNumberOfPoints();
      if (isKept)
      {
        this->File.PointData->AddArray(array);
      }
    }
  }

  vtkPolyData* Mesh;
  const std::string& FileName;
  std::vector<MesoMeshCorner> Cell;
  MesoMeshFile File;
};
}

MesoMeshFile MesoParseVtp(const std::string& bytes, const std::string& fileName)
{
  CheckCounts(bytes, fileName);
  vtkNew<vtkXMLPolyDataReader> reader;
  MesoReadVtkXml(reader, bytes, fileName);
  return Converter(reader->GetOutput(), fileName).Convert();
}

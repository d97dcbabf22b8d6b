#include "MesoMeshSurface.h"

#include "MesoMeshTopology.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTriangulate.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
/// For each tuple the number of the first that is equal to it. -0 equals 0.
template <std::size_t N>
std::vector<std::int32_t> FirstEqual(const std::vector<std::array<double, N>>& tuples)
{
  std::size_t slots = 16;
  while (slots < tuples.size() * 2)
  {
    slots *= 2;
  }
  std::vector<std::int32_t> table(slots, -1);
  std::vector<std::int32_t> first(tuples.size());
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    std::uint64_t hash = 0;
    for (double component : tuples[i])
    {
      const double value = component + 0.; // makes -0 and 0 the same bits
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & (slots - 1);
    while (table[slot] >= 0 && tuples[table[slot]] != tuples[i])
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] < 0)
    {
      table[slot] = static_cast<std::int32_t>(i);
    }
    first[i] = table[slot];
  }
  return first;
}

/// Counts occurrences, remembers the first, and says so.
class Tally
{
public:
  void Add(std::size_t place) { this->First = this->Count++ == 0 ? place : this->First; }
  void Report(const std::string& what, const char* placeName, std::vector<std::string>& notes) const
  {
    if (this->Count > 0)
    {
      notes.push_back(std::to_string(this->Count) + " " + what + " (first " + placeName + " " +
        std::to_string(this->First) + ")");
    }
  }
  std::size_t Count = 0;

private:
  std::size_t First = 0;
};

/// The faces that are left when corners at the same position have been taken out.
struct Faces
{
  std::vector<std::size_t> FirstCorner = { 0 };
  std::vector<std::int32_t> Vertices; ///< a corner's merged position
  std::vector<std::size_t> FileCorner;
  std::vector<std::size_t> Place;

  void Close(std::size_t place)
  {
    this->FirstCorner.push_back(this->Vertices.size());
    this->Place.push_back(place);
  }
};

class SurfaceMaker
{
public:
  explicit SurfaceMaker(const MesoMeshFile& file)
    : File(file)
    , MergedPosition(FirstEqual(file.Positions))
    , MergedTexture(FirstEqual(file.TextureCoordinates))
    , MergedNormal(FirstEqual(file.Normals))
  {
    this->Surface.Notes = file.Notes;
  }

  MesoMeshSurface Make(const std::string& fileName)
  {
    this->CheckUse();
    this->CheckTextureCoordinates();
    this->CheckNormals();
    this->CollectFaces();
    if (this->Kept.Place.empty())
    {
      throw MesoInputError(fileName + ": no face has three different positions");
    }
    const MesoMeshTopology topology =
      MesoBuildTopology(this->File.Positions.size(), this->Kept.FirstCorner, this->Kept.Vertices);
    this->Surface.NumberOfSheets = topology.NumberOfSheets;
    this->Surface.NumberOfOpenEdges = topology.NumberOfOpenEdges;
    if (!topology.RefusedFaces.empty())
    {
      Tally refused;
      for (std::size_t face : topology.RefusedFaces)
      {
        refused.Add(this->Kept.Place[face]);
      }
      refused.Report("faces do not join their neighbours in a manifold (doubled, turned over, or "
                     "a third at an edge) and are kept as sheets of their own",
        this->File.PlaceName, this->Surface.Notes);
    }
    this->MakeTriangles(topology);
    return std::move(this->Surface);
  }

private:
  void CheckUse()
  {
    std::vector<bool> used(this->File.Positions.size());
    for (const MesoMeshCorner& corner : this->File.Corners)
    {
      used[corner.Position] = true;
    }
    const auto unused = std::count(used.begin(), used.end(), false);
    if (unused > 0)
    {
      const auto first = std::find(used.begin(), used.end(), false) - used.begin() + 1;
      this->Surface.Notes.push_back(std::to_string(unused) + " of " + std::to_string(used.size()) +
        " vertices are in no face (first vertex " + std::to_string(first) + ")");
    }
  }

  /// Calls `add` with the place of each face that has a corner for which `lacks` holds.
  template <typename Lacks>
  Tally FacesWhere(const Lacks& lacks) const
  {
    Tally tally;
    for (std::size_t face = 0; face < this->File.NumberOfFaces(); ++face)
    {
      const auto begin = this->File.Corners.begin() + this->File.FirstCorner[face];
      const auto end = this->File.Corners.begin() + this->File.FirstCorner[face + 1];
      if (std::any_of(begin, end, lacks))
      {
        tally.Add(this->File.FacePlace[face]);
      }
    }
    return tally;
  }

  void CheckTextureCoordinates()
  {
    const Tally without =
      this->FacesWhere([](const MesoMeshCorner& corner) { return corner.TextureCoordinate < 0; });
    this->HasTexture = without.Count < this->File.NumberOfFaces();
    if (!this->HasTexture)
    {
      this->Surface.Notes.emplace_back("has no texture coordinates");
      return;
    }
    without.Report("faces have corners without texture coordinates, taken as (0, 0)",
      this->File.PlaceName, this->Surface.Notes);
  }

  void CheckNormals()
  {
    const Tally without = this->FacesWhere([&](const MesoMeshCorner& corner)
      { return corner.Normal < 0 || !(this->LengthOf(corner.Normal) > 0.); });
    this->HasNormals = without.Count == 0;
    if (!this->HasNormals && !this->File.Normals.empty())
    {
      without.Report("faces have corners without a normal, or of length 0; the file's normals are "
                     "not used",
        this->File.PlaceName, this->Surface.Notes);
    }
  }

  double LengthOf(std::int32_t normal) const
  {
    const auto& n = this->File.Normals[normal];
    return std::hypot(n[0], n[1], n[2]);
  }

  void CollectFaces()
  {
    Tally dropped;
    Tally collapsed;
    std::vector<std::size_t> corners;
    for (std::size_t face = 0; face < this->File.NumberOfFaces(); ++face)
    {
      corners.clear();
      for (std::size_t i = this->File.FirstCorner[face]; i < this->File.FirstCorner[face + 1]; ++i)
      {
        if (corners.empty() || this->VertexAt(corners.back()) != this->VertexAt(i))
        {
          corners.push_back(i);
        }
      }
      while (
        corners.size() > 1 && this->VertexAt(corners.front()) == this->VertexAt(corners.back()))
      {
        corners.pop_back();
      }
      const std::size_t place = this->File.FacePlace[face];
      if (corners.size() < 3)
      {
        dropped.Add(place);
        continue;
      }
      if (corners.size() < this->File.FirstCorner[face + 1] - this->File.FirstCorner[face])
      {
        collapsed.Add(place);
      }
      this->KeepFace(corners, place);
    }
    dropped.Report("faces have fewer than three different positions and are left out",
      this->File.PlaceName, this->Surface.Notes);
    collapsed.Report("faces have neighbouring corners at one position, of which the first is kept",
      this->File.PlaceName, this->Surface.Notes);
  }

  void KeepFace(const std::vector<std::size_t>& corners, std::size_t place)
  {
    std::vector<std::int32_t>& sorted = this->Scratch;
    sorted.clear();
    for (std::size_t corner : corners)
    {
      sorted.push_back(this->VertexAt(corner));
    }
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end())
    {
      this->KeepCorners(corners, place);
      return;
    }
    // A polygon that comes back to a vertex: its triangles are taken as faces.
    this->Cut(corners);
    for (std::size_t i = 0; i < this->Cuts.size(); i += 3)
    {
      const std::size_t a = corners[this->Cuts[i]];
      const std::size_t b = corners[this->Cuts[i + 1]];
      const std::size_t c = corners[this->Cuts[i + 2]];
      if (this->VertexAt(a) != this->VertexAt(b) && this->VertexAt(b) != this->VertexAt(c) &&
        this->VertexAt(c) != this->VertexAt(a))
      {
        this->KeepCorners({ a, b, c }, place);
      }
    }
  }

  void KeepCorners(const std::vector<std::size_t>& corners, std::size_t place)
  {
    for (std::size_t corner : corners)
    {
      this->Kept.Vertices.push_back(this->VertexAt(corner));
      this->Kept.FileCorner.push_back(corner);
    }
    this->Kept.Close(place);
  }

  void MakeTriangles(const MesoMeshTopology& topology)
  {
    Tally unsound;
    this->VertexNumber.assign(topology.Original.size(), -1);
    this->PointsOfVertex.reserve(topology.Original.size());
    std::vector<std::size_t> corners;
    for (std::size_t face = 0; face < this->Kept.Place.size(); ++face)
    {
      const std::size_t begin = this->Kept.FirstCorner[face];
      const std::size_t end = this->Kept.FirstCorner[face + 1];
      corners.assign(this->Kept.FileCorner.begin() + begin, this->Kept.FileCorner.begin() + end);
      if (!this->Cut(corners))
      {
        unsound.Add(this->Kept.Place[face]);
      }
      this->PointOfCorner.clear();
      for (std::size_t i = begin; i < end; ++i)
      {
        this->PointOfCorner.push_back(
          this->PointAt(topology.VertexOfCorner[i], this->Kept.FileCorner[i]));
      }
      for (std::size_t i = 0; i < this->Cuts.size(); i += 3)
      {
        this->Surface.Triangles.push_back({ this->PointOfCorner[this->Cuts[i]],
          this->PointOfCorner[this->Cuts[i + 1]], this->PointOfCorner[this->Cuts[i + 2]] });
      }
    }
    unsound.Report("faces are folded over, cross themselves or have no area", this->File.PlaceName,
      this->Surface.Notes);
  }

  /// Cuts the polygon into this->Cuts.
  bool Cut(const std::vector<std::size_t>& corners)
  {
    this->Polygon.clear();
    for (std::size_t corner : corners)
    {
      this->Polygon.push_back(this->File.Positions[this->VertexAt(corner)]);
    }
    this->Cuts.clear();
    return MesoTriangulate(this->Polygon, this->Cuts);
  }

  std::int32_t PointAt(std::int32_t topologyVertex, std::size_t fileCorner)
  {
    const MesoMeshCorner& corner = this->File.Corners[fileCorner];
    std::int32_t& vertex = this->VertexNumber[topologyVertex];
    if (vertex < 0)
    {
      vertex = static_cast<std::int32_t>(this->Surface.NumberOfVertices++);
      this->PointsOfVertex.push_back(-1);
    }
    const std::int32_t texture = this->HasTexture && corner.TextureCoordinate >= 0
      ? this->MergedTexture[corner.TextureCoordinate]
      : -1;
    const std::int32_t normal = this->HasNormals ? this->MergedNormal[corner.Normal] : -1;
    std::int32_t point = this->PointsOfVertex[vertex];
    while (point >= 0 &&
      (this->Points[point].Texture != texture || this->Points[point].Normal != normal))
    {
      point = this->Points[point].NextOfVertex;
    }
    if (point < 0)
    {
      point = static_cast<std::int32_t>(this->Points.size());
      this->Points.push_back({ texture, normal, this->PointsOfVertex[vertex] });
      this->PointsOfVertex[vertex] = point;
      this->AddPoint(vertex, corner, texture, normal);
    }
    return point;
  }

  void AddPoint(
    std::int32_t vertex, const MesoMeshCorner& corner, std::int32_t texture, std::int32_t normal)
  {
    this->Surface.Vertex.push_back(vertex);
    this->Surface.FilePosition.push_back(corner.Position);
    this->Surface.Positions.push_back(this->File.Positions[this->MergedPosition[corner.Position]]);
    if (this->HasTexture)
    {
      this->Surface.TextureCoordinates.push_back(
        texture < 0 ? std::array<double, 2>{ 0., 0. } : this->File.TextureCoordinates[texture]);
    }
    if (this->HasNormals)
    {
      auto n = this->File.Normals[normal];
      const double length = this->LengthOf(normal);
      for (double& component : n)
      {
        component /= length;
      }
      this->Surface.Normals.push_back(n);
    }
  }

  std::int32_t VertexAt(std::size_t corner) const
  {
    return this->MergedPosition[this->File.Corners[corner].Position];
  }

  /// What makes points of one vertex different, and the next of them, -1 at the end.
  struct PointKey
  {
    std::int32_t Texture;
    std::int32_t Normal;
    std::int32_t NextOfVertex;
  };

  const MesoMeshFile& File;
  const std::vector<std::int32_t> MergedPosition;
  const std::vector<std::int32_t> MergedTexture;
  const std::vector<std::int32_t> MergedNormal;
  bool HasTexture = false;
  bool HasNormals = false;
  Faces Kept;
  std::vector<std::int32_t> VertexNumber;   ///< of a topology vertex, -1 until it is used
  std::vector<std::int32_t> PointsOfVertex; ///< the first in the chain of PointKey
  std::vector<PointKey> Points;
  std::vector<std::int32_t> Scratch;
  std::vector<std::array<double, 3>> Polygon;
  std::vector<int> Cuts;
  std::vector<std::int32_t> PointOfCorner;
  MesoMeshSurface Surface;
};
}

MesoMeshSurface MesoMakeSurface(const MesoMeshFile& file, const std::string& fileName)
{
  return SurfaceMaker(file).Make(fileName);
}

#include "MesoMeshTopology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include <numeric>

namespace
{
constexpr std::size_t MostSheets = 8;

/// OpenMesh writes a line to its error stream for each face that it refuses.
class QuietOpenMesh
{
public:
  QuietOpenMesh()
    : WasOn(omerr().is_enabled())
  {
    omerr().disable();
  }
  ~QuietOpenMesh()
  {
    if (this->WasOn)
    {
      omerr().enable();
    }
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

private:
  bool WasOn;
};

class SheetBuilder
{
public:
  SheetBuilder(const std::vector<std::size_t>& firstCorner,
    const std::vector<std::int32_t>& corners, MesoMeshTopology& topology)
    : FirstCorner(firstCorner)
    , Given(corners)
    , Topology(topology)
  {
  }

  /// Adds a sheet of these faces; `vertexOf` gives for each given vertex that of the sheet, -1
  /// where it has none yet. Returns the faces refused.
  std::vector<std::size_t> Add(
    const std::vector<std::size_t>& faces, std::vector<std::int32_t>& vertexOf)
  {
    using Mesh = OpenMesh::PolyConnectivity; // no positions: only the joining is asked of it
    Mesh mesh;
    mesh.reserve(vertexOf.size(), faces.size() * 2, faces.size());
    std::vector<std::int32_t> handleOf(vertexOf.size(), -1);
    std::vector<Mesh::VertexHandle> handles;
    std::vector<std::size_t> refused;
    for (std::size_t face : faces)
    {
      handles.clear();
      for (std::size_t i = this->FirstCorner[face]; i < this->FirstCorner[face + 1]; ++i)
      {
        std::int32_t& handle = handleOf[this->Given[i]];
        if (handle < 0)
        {
          handle = mesh.new_vertex().idx();
        }
        handles.emplace_back(handle);
      }
      if (!mesh.add_face(handles).is_valid())
      {
        refused.push_back(face);
        continue;
      }
      this->Place(face, vertexOf);
    }
    for (const auto edge : mesh.edges())
    {
      this->Topology.NumberOfOpenEdges += mesh.is_boundary(edge) ? 1 : 0;
    }
    return refused;
  }

  /// Gives the corners of a face the sheet's vertices.
  void Place(std::size_t face, std::vector<std::int32_t>& vertexOf)
  {
    for (std::size_t i = this->FirstCorner[face]; i < this->FirstCorner[face + 1]; ++i)
    {
      std::int32_t& vertex = vertexOf[this->Given[i]];
      if (vertex < 0)
      {
        vertex = static_cast<std::int32_t>(this->Topology.Original.size());
        this->Topology.Original.push_back(this->Given[i]);
      }
      this->Topology.VertexOfCorner[i] = vertex;
    }
  }

private:
  const std::vector<std::size_t>& FirstCorner;
  const std::vector<std::int32_t>& Given;
  MesoMeshTopology& Topology;
};
}

MesoMeshTopology MesoBuildTopology(std::size_t numberOfVertices,
  const std::vector<std::size_t>& firstCorner, const std::vector<std::int32_t>& corners)
{
  const QuietOpenMesh quiet;
  MesoMeshTopology topology;
  topology.VertexOfCorner.resize(corners.size());
  topology.Original.resize(numberOfVertices);
  std::iota(topology.Original.begin(), topology.Original.end(), 0);
  SheetBuilder builder(firstCorner, corners, topology);

  std::vector<std::int32_t> vertexOf = topology.Original;
  std::vector<std::size_t> faces(firstCorner.size() - 1);
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  std::vector<std::size_t> left = builder.Add(faces, vertexOf);
  topology.RefusedFaces = left;
  while (!left.empty() && topology.NumberOfSheets < MostSheets)
  {
    vertexOf.assign(numberOfVertices, -1);
    left = builder.Add(left, vertexOf);
    ++topology.NumberOfSheets;
  }
  for (std::size_t face : left)
  {
    for (std::size_t i = firstCorner[face]; i < firstCorner[face + 1]; ++i)
    {
      topology.VertexOfCorner[i] = static_cast<std::int32_t>(topology.Original.size());
      topology.Original.push_back(corners[i]);
    }
    topology.NumberOfOpenEdges += firstCorner[face + 1] - firstCorner[face];
  }
  return topology;
}

#include "MesoGridBase.h"

#include "MesoPolyDataInput.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace
{
constexpr double Forgiven = 1e-3; // of a segment, lest rounding add one
constexpr double MostSegments = 1e6;
constexpr double EqualNormals = 4. / (1 << 24); // roundings of floats

/// A row of a matrix times a point.
double RowTimes(const std::array<double, 16>& matrix, int row, const MesoVector& p)
{
  const double* m = matrix.data() + 4 * row;
  return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
}

MesoVector ToView(const MesoGridView& view, const MesoVector& p)
{
  return { RowTimes(view.ModelToView, 0, p), RowTimes(view.ModelToView, 1, p),
    RowTimes(view.ModelToView, 2, p) };
}

/// The largest factor by which the view makes a length longer.
double Stretch(const MesoGridView& view)
{
  double sum = 0.;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      sum += view.ModelToView[4 * row + column] * view.ModelToView[4 * row + column];
    }
  }
  return std::sqrt(sum);
}

/// Whether a ball in view coordinates lies outside of the picture, or before the near plane.
bool IsOutside(const MesoGridView& view, const MesoVector& centre, double radius)
{
  const double* const w = view.Projection.data() + 12;
  for (int side = 0; side < 5; ++side)
  {
    const double* const row = view.Projection.data() + 4 * (side / 2);
    const double sign = side % 2 == 0 ? 1. : -1.;
    double plane[4];
    for (int k = 0; k < 4; ++k)
    {
      plane[k] = w[k] + sign * row[k];
    }
    const double size = std::hypot(plane[0], plane[1], plane[2]);
    const double distance =
      plane[0] * centre[0] + plane[1] * centre[1] + plane[2] * centre[2] + plane[3];
    if (size > 0. && distance < -radius * size)
    {
      return true;
    }
  }
  return false;
}

/// Into how many blocks a side of a lattice is cut: where there are few, such that all have the same
/// rows and none is added.
std::int64_t BlocksOf(std::int64_t rows)
{
  const std::int64_t least = (rows + MesoGridBase::MostRows - 1) / MesoGridBase::MostRows;
  for (std::int64_t blocks = least; blocks <= 2 * least; ++blocks)
  {
    if (rows % blocks == 0)
    {
      return blocks;
    }
  }
  return least;
}
}

MesoGridBase::MesoGridBase(vtkPolyData* mesh)
{
  const vtkSmartPointer<vtkPolyData> triangles = MesoTriangulated(mesh);
  vtkDataArray* normals = MesoFindNormals(mesh);
  if (!normals)
  {
    throw std::invalid_argument("the mesh has no normals");
  }
  vtkDataArray* coordinates = MesoFindTextureCoordinates(mesh);
  if (mesh->GetNumberOfPoints() > 0)
  {
    this->Positions = MesoTuples<3>(mesh->GetPoints()->GetData(), "the position");
  }
  this->Normals = MesoTuples<3>(normals, "the normal");
  this->Coordinates = MesoTuples<2>(coordinates, "the texture coordinate");
  this->Triangles = MesoTrianglesOf(triangles->GetPolys());
  std::vector<std::int64_t> vertices = MesoGivenVertices(mesh->GetPointData(), this->Positions);
  if (vertices.empty())
  {
    vertices = MesoMadeVertices(this->Positions);
  }
  this->Weld(vertices);
  this->FindEdges(vertices);
}

void MesoGridBase::Weld(const std::vector<std::int64_t>& vertices)
{
  std::map<std::int64_t, std::vector<std::size_t>> points;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    points[vertices[i]].push_back(i);
  }
  for (const auto& vertex : points)
  {
    const std::vector<std::size_t>& same = vertex.second;
    for (std::size_t i = 1; i < same.size(); ++i)
    {
      this->Positions[same[i]] = this->Positions[same[0]];
      const auto like = std::find_if(same.begin(), same.begin() + std::ptrdiff_t(i),
        [&](std::size_t other)
        {
          const MesoVector apart = MesoDifference(this->Normals[same[i]], this->Normals[other]);
          return MesoLength(apart) <= EqualNormals;
        });
      this->Normals[same[i]] = this->Normals[*like];
    }
  }
}

void MesoGridBase::FindEdges(const std::vector<std::int64_t>& vertices)
{
  std::map<std::array<std::int64_t, 2>, std::int64_t> numbers;
  for (const auto& corners : this->Triangles)
  {
    std::array<std::int64_t, 3> edges;
    std::array<bool, 3> backwards;
    bool flat = false;
    for (int k = 0; k < 3; ++k)
    {
      std::array<std::int64_t, 2> ends = { corners[k], corners[(k + 1) % 3] };
      const double du = this->Coordinates[ends[1]][0] - this->Coordinates[ends[0]][0];
      const double dv = this->Coordinates[ends[1]][1] - this->Coordinates[ends[0]][1];
      backwards[k] = vertices[ends[1]] < vertices[ends[0]];
      flat = flat || vertices[ends[1]] == vertices[ends[0]];
      if (backwards[k])
      {
        std::swap(ends[0], ends[1]);
      }
      const auto found =
        numbers.emplace(std::array<std::int64_t, 2>{ vertices[ends[0]], vertices[ends[1]] },
          static_cast<std::int64_t>(this->Edges.size()));
      if (found.second)
      {
        this->Edges.emplace_back();
        this->Edges.back().Ends = ends;
      }
      edges[k] = found.first->second;
      Edge& edge = this->Edges[edges[k]];
      edge.Extent = { std::max(edge.Extent[0], std::abs(du)),
        std::max(edge.Extent[1], std::abs(dv)) };
    }
    this->EdgesOf.push_back(edges);
    this->Backwards.push_back(backwards);
    this->Flat.push_back(flat);
  }
}

std::int64_t MesoGridBase::SegmentsOf(
  const Edge& edge, const MesoGridSize& size, const std::optional<MesoGridView>& view) const
{
  double segments = size.FacetsPerTexel *
    std::max(edge.Extent[0] * size.Texels[0], edge.Extent[1] * size.Texels[1]);
  if (view)
  {
    const MesoVector a = ToView(*view, this->Positions[edge.Ends[0]]);
    const MesoVector b = ToView(*view, this->Positions[edge.Ends[1]]);
    // w of clip coordinates: the distance where the picture is in perspective, else 1.
    const bool perspective = view->Projection[15] == 0.;
    const double reach = perspective ? size.Reach * Stretch(*view) : 0.;
    const double away =
      std::min(RowTimes(view->Projection, 3, a), RowTimes(view->Projection, 3, b)) - reach;
    const double nearest = perspective ? std::max(away, view->Near) : away;
    const double pixels = MesoLength(MesoDifference(a, b)) * std::abs(view->Projection[5]) *
      view->Height / (2. * nearest);
    segments = std::min(segments, pixels / size.FacetPixels);
  }
  if (!(segments < MostSegments))
  {
    throw std::invalid_argument("an edge of the mesh would be cut into more than " +
      std::to_string(std::int64_t(MostSegments)) + " segments");
  }
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(segments - Forgiven)));
}

MesoGridPieces MesoGridBase::PiecesFor(const MesoGridSize& size, const MesoGridView* given) const
{
  std::optional<MesoGridView> view;
  if (given && size.FacetPixels > 0.)
  {
    view = *given;
  }
  std::vector<std::int64_t> segments;
  segments.reserve(this->Edges.size());
  for (const Edge& edge : this->Edges)
  {
    segments.push_back(this->SegmentsOf(edge, size, view));
  }
  MesoGridPieces pieces;
  std::map<std::int64_t, std::vector<float>> groups;
  const double reach = view ? size.Reach * Stretch(*view) : 0.;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->Flat[t])
    {
      continue;
    }
    if (view)
    {
      MesoVector corners[3];
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = ToView(*view, this->Positions[this->Triangles[t][k]]);
      }
      const MesoVector centre =
        MesoScaled(MesoSum(MesoSum(corners[0], corners[1]), corners[2]), 1. / 3.);
      double radius = 0.;
      for (const MesoVector& corner : corners)
      {
        radius = std::max(radius, MesoLength(MesoDifference(corner, centre)));
      }
      if (IsOutside(*view, centre, radius + reach))
      {
        continue;
      }
    }
    std::int64_t ofEdges[3];
    std::int64_t finest = 1;
    for (int k = 0; k < 3; ++k)
    {
      ofEdges[k] = segments[this->EdgesOf[t][k]];
      finest = std::max(finest, ofEdges[k]);
      ofEdges[k] = this->Backwards[t][k] ? -ofEdges[k] : ofEdges[k];
    }
    const std::int64_t blocks = BlocksOf(finest);
    const std::int64_t rows = (finest + blocks - 1) / blocks;
    pieces.Triangles += blocks * blocks * rows * rows;
    if (pieces.Triangles > MostTriangles)
    {
      throw std::invalid_argument("the surface would be cut into more than " +
        std::to_string(MostTriangles) +
        " triangles; take fewer facets a texel or more pixels a facet");
    }
    std::vector<float>& numbers = groups[rows];
    const auto add = [&](std::int64_t i, std::int64_t j, float way)
    {
      for (const std::int64_t number :
        { std::int64_t(t), i, j, blocks * rows, ofEdges[0], ofEdges[1], ofEdges[2] })
      {
        numbers.push_back(static_cast<float>(number));
      }
      numbers.push_back(way);
    };
    for (std::int64_t i = 0; i < blocks; ++i)
    {
      for (std::int64_t j = 0; i + j < blocks; ++j)
      {
        add(i * rows, j * rows, 1.f);
        if (i + j + 1 < blocks)
        {
          add((i + 1) * rows, (j + 1) * rows, -1.f);
        }
      }
    }
  }
  for (const auto& group : groups)
  {
    pieces.Groups.push_back({ static_cast<int>(group.first),
      static_cast<int>(pieces.Numbers.size() / 8), static_cast<int>(group.second.size() / 8) });
    pieces.Numbers.insert(pieces.Numbers.end(), group.second.begin(), group.second.end());
  }
  return pieces;
}

std::vector<std::uint16_t> MesoGridBase::MakeIndices()
{
  std::vector<std::uint16_t> indices;
  indices.reserve(std::size_t(3) * MostRows * MostRows);
  const auto point = [](int row, int place)
  { return static_cast<std::uint16_t>(row * (row + 1) / 2 + place); };
  for (int row = 0; row < MostRows; ++row)
  {
    for (int place = 0; place <= row; ++place)
    {
      for (const std::uint16_t index :
        { point(row, place), point(row + 1, place), point(row + 1, place + 1) })
      {
        indices.push_back(index);
      }
      if (place < row)
      {
        for (const std::uint16_t index :
          { point(row, place), point(row + 1, place + 1), point(row, place + 1) })
        {
          indices.push_back(index);
        }
      }
    }
  }
  return indices;
}

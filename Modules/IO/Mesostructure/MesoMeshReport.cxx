#include "MesoMeshReport.h"

#include "MesoChartOverlap.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace
{
constexpr double SmallestArea = 1e-12; // of the square of the longest side

/// Sets of numbers, joined pair by pair.
class Sets
{
public:
  explicit Sets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
  }
  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }
  void Join(std::size_t a, std::size_t b) { this->Parent[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::size_t> Parent;
};

/// A side of a triangle: corner 3 t + k, from the lower to the higher vertex or back.
struct Side
{
  std::size_t Low;
  std::size_t High;
  std::size_t Corner;
  bool IsForward;
  bool operator<(const Side& other) const
  {
    return std::tie(this->Low, this->High, this->Corner) <
      std::tie(other.Low, other.High, other.Corner);
  }
  bool SameEdge(const Side& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

class Reporter
{
public:
  explicit Reporter(vtkPolyData* mesh)
    : Mesh(mesh)
    , Texture(mesh->GetPointData()->GetTCoords())
  {
  }

  MesoMeshReport Report()
  {
    this->ReadTriangles();
    this->MergePoints();
    this->CountFaces();
    this->CollectSides();
    this->CountEdges();
    this->CountFans();
    this->CountComponents();
    this->MeasureVolume();
    if (this->Texture)
    {
      this->CountCharts();
    }
    return this->Result;
  }

private:
  using Triangle = std::array<std::size_t, 3>;

  void ReadTriangles()
  {
    vtkCellArray* cells = this->Mesh->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      cells->GetCellAtId(i, size, points);
      if (size == 3)
      {
        this->Triangles.push_back({ static_cast<std::size_t>(points[0]),
          static_cast<std::size_t>(points[1]), static_cast<std::size_t>(points[2]) });
      }
    }
    this->Result.Triangles = this->Triangles.size();
    this->Result.Points = static_cast<std::size_t>(this->Mesh->GetNumberOfPoints());
    this->Result.HasNormals = this->Mesh->GetPointData()->GetNormals() != nullptr;
    this->Result.IsDouble = this->Mesh->GetPoints()->GetDataType() == VTK_DOUBLE;
    double bounds[6];
    this->Mesh->GetBounds(bounds);
    for (int k = 0; k < 3; ++k)
    {
      this->Result.Least[k] = bounds[2 * k];
      this->Result.Most[k] = bounds[2 * k + 1];
    }
  }

  std::array<double, 3> Position(std::size_t point) const
  {
    std::array<double, 3> position;
    this->Mesh->GetPoint(static_cast<vtkIdType>(point), position.data());
    return position;
  }

  std::array<double, 2> Coordinates(std::size_t point) const
  {
    return { this->Texture->GetComponent(static_cast<vtkIdType>(point), 0),
      this->Texture->GetComponent(static_cast<vtkIdType>(point), 1) };
  }

  void MergePoints()
  {
    std::vector<std::size_t> order(this->Result.Points);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<std::array<double, 3>> positions(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      positions[i] = this->Position(i);
    }
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return positions[a] < positions[b]; });
    this->Vertex.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const bool isNew = i == 0 || positions[order[i]] != positions[order[i - 1]];
      this->Result.Vertices += isNew ? 1 : 0;
      this->Vertex[order[i]] = this->Result.Vertices - 1;
    }
  }

  std::size_t VertexOf(std::size_t corner) const
  {
    return this->Vertex[this->Triangles[corner / 3][corner % 3]];
  }
  static std::size_t Next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  void CountFaces()
  {
    std::set<Triangle> seen;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      Triangle vertices = { this->VertexOf(3 * t), this->VertexOf(3 * t + 1),
        this->VertexOf(3 * t + 2) };
      std::sort(vertices.begin(), vertices.end());
      this->Result.Duplicate += seen.insert(vertices).second ? 0 : 1;

      const auto a = this->Position(this->Triangles[t][0]);
      const auto b = this->Position(this->Triangles[t][1]);
      const auto c = this->Position(this->Triangles[t][2]);
      std::array<double, 3> cross{};
      double longest = 0.;
      for (int k = 0; k < 3; ++k)
      {
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        cross[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
      }
      for (const auto& [p, q] : { std::pair(a, b), std::pair(b, c), std::pair(c, a) })
      {
        longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
      }
      const double area = 0.5 * std::hypot(cross[0], cross[1], cross[2]);
      this->Result.Degenerate += area <= SmallestArea * longest * longest ? 1 : 0;
      this->Area += area;
    }
  }

  void CollectSides()
  {
    this->Sides.reserve(3 * this->Triangles.size());
    for (std::size_t corner = 0; corner < 3 * this->Triangles.size(); ++corner)
    {
      const std::size_t from = this->VertexOf(corner);
      const std::size_t to = this->VertexOf(Next(corner));
      if (from != to)
      {
        this->Sides.push_back({ std::min(from, to), std::max(from, to), corner, from < to });
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  /// Calls `visit(first, count)` for the sides of each edge.
  template <typename Visit>
  void ForEdges(const Visit& visit) const
  {
    for (std::size_t i = 0; i < this->Sides.size();)
    {
      std::size_t end = i + 1;
      while (end < this->Sides.size() && this->Sides[end].SameEdge(this->Sides[i]))
      {
        ++end;
      }
      visit(&this->Sides[i], end - i);
      i = end;
    }
  }

  void CountEdges()
  {
    this->ForEdges(
      [&](const Side* sides, std::size_t count)
      {
        this->Result.BoundaryEdges += count == 1 ? 1 : 0;
        this->Result.NonManifoldEdges += count > 2 ? 1 : 0;
        this->Result.TurnedEdges += count == 2 && sides[0].IsForward == sides[1].IsForward ? 1 : 0;
      });
  }

  /// The corner of the triangle of `side` at its lower vertex (0) or its higher one (1).
  static std::size_t CornerAt(const Side& side, int end)
  {
    return (end == 0) == side.IsForward ? side.Corner : Next(side.Corner);
  }

  void CountFans()
  {
    Sets fans(3 * this->Triangles.size());
    this->ForEdges(
      [&](const Side* sides, std::size_t count)
      {
        for (std::size_t i = 1; i < count; ++i)
        {
          fans.Join(CornerAt(sides[0], 0), CornerAt(sides[i], 0));
          fans.Join(CornerAt(sides[0], 1), CornerAt(sides[i], 1));
        }
      });
    std::vector<std::size_t> count(this->Result.Vertices);
    for (std::size_t corner = 0; corner < 3 * this->Triangles.size(); ++corner)
    {
      if (fans.Find(corner) == corner)
      {
        ++count[this->VertexOf(corner)];
      }
    }
    this->Result.NonManifoldVertices = static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](std::size_t n) { return n > 1; }));
  }

  void CountComponents()
  {
    Sets sets(this->Result.Vertices);
    std::vector<bool> isUsed(this->Result.Vertices);
    for (std::size_t corner = 0; corner < 3 * this->Triangles.size(); ++corner)
    {
      sets.Join(this->VertexOf(corner), this->VertexOf(Next(corner)));
      isUsed[this->VertexOf(corner)] = true;
    }
    for (std::size_t i = 0; i < this->Result.Vertices; ++i)
    {
      this->Result.Components += isUsed[i] && sets.Find(i) == i ? 1 : 0;
    }
  }

  void MeasureVolume()
  {
    if (this->Result.BoundaryEdges + this->Result.NonManifoldEdges + this->Result.TurnedEdges > 0)
    {
      return;
    }
    double sum = 0.;
    const auto origin = this->Result.Least; // near the mesh, so that little cancels
    for (const Triangle& triangle : this->Triangles)
    {
      std::array<std::array<double, 3>, 3> p;
      for (int i = 0; i < 3; ++i)
      {
        p[i] = this->Position(triangle[i]);
        for (int k = 0; k < 3; ++k)
        {
          p[i][k] -= origin[k];
        }
      }
      sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
        p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
        p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    this->Result.Volume = sum / 6.;
  }

  void CountCharts()
  {
    MesoChartReport chart;
    std::vector<MesoTextureTriangle> triangles;
    double area = 0.;
    chart.Least = chart.Most = this->Coordinates(0);
    for (const Triangle& triangle : this->Triangles)
    {
      MesoTextureTriangle corners;
      double longest = 0.;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = this->Coordinates(triangle[i]);
        for (int k = 0; k < 2; ++k)
        {
          chart.Least[k] = std::min(chart.Least[k], corners[i][k]);
          chart.Most[k] = std::max(chart.Most[k], corners[i][k]);
        }
      }
      for (int i = 0; i < 3; ++i)
      {
        const auto& p = corners[i];
        const auto& q = corners[(i + 1) % 3];
        longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1]));
      }
      const double twice = MesoTwiceArea(corners);
      const bool isFlat = std::abs(twice) <= 2. * SmallestArea * longest * longest;
      chart.Degenerate += isFlat ? 1 : 0;
      chart.Mirrored += !isFlat && twice < 0. ? 1 : 0;
      area += 0.5 * std::abs(twice);
      triangles.push_back(corners);
    }
    chart.Scale = area > 0. ? std::sqrt(this->Area / area) : 0.;
    chart.Overlap = MesoChartOverlap(triangles);

    Sets charts(this->Triangles.size());
    this->ForEdges(
      [&](const Side* sides, std::size_t count)
      {
        for (std::size_t i = 1; i < count; ++i)
        {
          const bool isJoint = this->SameCoordinates(sides[0], sides[i], 0) &&
            this->SameCoordinates(sides[0], sides[i], 1);
          if (isJoint)
          {
            charts.Join(sides[0].Corner / 3, sides[i].Corner / 3);
          }
          chart.SeamEdges += count == 2 && !isJoint ? 1 : 0;
        }
      });
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      chart.Charts += charts.Find(t) == t ? 1 : 0;
    }
    this->Result.Chart = chart;
  }

  bool SameCoordinates(const Side& a, const Side& b, int end) const
  {
    const auto point = [&](const Side& side)
    {
      const std::size_t corner = CornerAt(side, end);
      return this->Triangles[corner / 3][corner % 3];
    };
    return this->Coordinates(point(a)) == this->Coordinates(point(b));
  }

  vtkPolyData* Mesh;
  vtkDataArray* Texture;
  std::vector<Triangle> Triangles;
  std::vector<std::size_t> Vertex; ///< of each point
  std::vector<Side> Sides;
  double Area = 0.;
  MesoMeshReport Result;
};
}

MesoMeshReport MesoReportMesh(vtkPolyData* mesh)
{
  return Reporter(mesh).Report();
}

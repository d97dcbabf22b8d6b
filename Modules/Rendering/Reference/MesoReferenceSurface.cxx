#include "MesoReferenceSurface.h"

#include "MesoSplineCell.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::array<glm::dvec2, 3> Barycentric = { glm::dvec2(0., 0.), glm::dvec2(1., 0.),
  glm::dvec2(0., 1.) };

// Texels as far out as this cannot be told apart any more, and are counted in 64 bits.
constexpr double FarthestTexel = 1e12;

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::shared_ptr<const MesoHeightPyramid> MakePyramid(
  vtkImageData* heights, const MesoMesostructureOptions& options)
{
  const int* size = heights->GetDimensions();
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  return std::make_shared<MesoHeightPyramid>(size[0], size[1], options.Wrap,
    std::vector<float>(values, values + std::size_t(size[0]) * size[1]), options.Interpolation);
}

glm::dvec3 NormalToWorld(const glm::dmat4& inverse, const glm::dvec3& normal)
{
  return glm::normalize(glm::transpose(glm::dmat3(inverse)) * normal);
}
}

MesoReferenceSurface::MesoReferenceSurface(
  const MesoSceneBuilder::Object& object, const MesoSceneMesh& source, bool smooth)
  : Label("node " + std::to_string(object.Number) + " '" + object.Name + "'")
  , Displaced(object.HeightMap && !object.Volume && // a map made a volume is a shell
      object.Options.Technique != MesoTechnique::Plain)
  , TwoSided(!object.Actor->GetProperty()->GetBackfaceCulling())
  , Scale(this->Displaced ? object.Options.Scale : 0.)
  , Reference(object.Options.Reference)
  , Tiles(object.Options.Tiles[0], object.Options.Tiles[1])
{
  vtkMatrix4x4* matrix = object.Actor->GetUserMatrix();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      this->Matrix[column][row] = matrix->GetElement(row, column);
    }
  }
  const double determinant = glm::determinant(glm::dmat3(this->Matrix));
  this->Inverse = glm::inverse(this->Matrix);
  if (determinant == 0. || !std::isfinite(this->Inverse[0][0] + this->Inverse[1][1]))
  {
    throw MesoInputError(this->Label +
      ": the matrix flattens the node, which the reference cannot "
      "trace");
  }
  this->Mirrored = determinant < 0.;
  if (this->Displaced)
  {
    this->Map = MakePyramid(object.HeightMap, object.Options);
  }
  if (object.NormalMap)
  {
    this->NormalMap.emplace(object.NormalMap, object.NormalMeaning, object.Options.Wrap);
  }
  this->ReadMesh(object.Base, object.Options);
  if (smooth)
  {
    this->FindShape(source);
  }
  if (object.Volume)
  {
    if (smooth)
    {
      throw MesoInputError(this->Label + ": the surface 'smooth' is not known for volumes");
    }
    this->Shell = std::make_unique<MesoReferenceShell>(
      MesoReferenceShell::Base{ this->Points, this->Normals, this->Coordinates, this->Triangles },
      object.Options.Scale, object.Options.Reference, object.Volume);
  }
  for (std::size_t i = 0; i < this->Triangles.size() && this->Displaced && !this->Shape; ++i)
  {
    this->Degenerate += this->HasChart(i) ? 0 : 1;
  }
}

void MesoReferenceSurface::FindShape(const MesoSceneMesh& source)
{
  if (source.Shape.empty())
  {
    throw MesoInputError(this->Label +
      ": has a mesh file, of which no closed form is known: the "
      "surface 'smooth' is for built-in shapes");
  }
  MesoShape shape(source.Shape, source.Parameters);
  if (shape.IsFlat())
  {
    return; // the mesh is its own closed form; a plane's size may come from the map
  }
  if (!shape.HasBends())
  {
    throw MesoInputError(
      this->Label + ": the surface 'smooth' is not known for the shape '" + source.Shape + "'");
  }
  this->Shape.emplace(std::move(shape));
}

void MesoReferenceSurface::ReadMesh(vtkPolyData* mesh, const MesoMesostructureOptions& options)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  const bool mapped = this->Displaced || MesoUsesVolume(options.Technique);
  if (!normals || (mapped && !coordinates))
  {
    throw MesoInputError(this->Label + ": the mesh has no " +
      (normals ? "texture coordinates, without which no map lies on it" : "normals"));
  }
  const vtkIdType size = mesh->GetNumberOfPoints();
  this->Points.reserve(size);
  this->Normals.reserve(size);
  this->Coordinates.reserve(coordinates ? size : 0);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (vtkIdType i = 0; i < size; ++i)
  {
    glm::dvec3 point;
    glm::dvec3 normal;
    mesh->GetPoint(i, &point.x);
    normals->GetTuple(i, &normal.x);
    this->Points.push_back(point);
    this->Normals.push_back(normal);
    if (coordinates)
    {
      this->Coordinates.emplace_back(coordinates->GetComponent(i, 0) * options.Tiles[0],
        coordinates->GetComponent(i, 1) * options.Tiles[1]);
    }
    if (IsFinite(point))
    {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  if (low.x <= high.x)
  {
    this->Middle = 0.5 * (low + high);
    this->Diagonal = glm::length(glm::dmat3(this->Matrix) * (high - low));
  }
  auto cell = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(corners, ids);
    if (corners != 3)
    {
      throw MesoInputError(this->Label + ": the mesh has a polygon of " + std::to_string(corners) +
        " corners; the reference takes triangles");
    }
    this->Triangles.push_back({ static_cast<std::uint32_t>(ids[0]),
      static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2]) });
  }
}

std::size_t MesoReferenceSurface::NumberOfPatches() const
{
  if (this->Shape)
  {
    const std::array<int, 2> cuts = this->Shape->Charts()[0].Segments;
    return std::size_t(cuts[0]) * cuts[1];
  }
  return this->Triangles.size();
}

std::array<glm::dvec2, 3> MesoReferenceSurface::PlacesOf(std::size_t triangle) const
{
  std::array<glm::dvec2, 3> places = Barycentric;
  if (this->Map)
  {
    const glm::dvec2 size(this->Map->X().Texels(), this->Map->Y().Texels());
    bool far = false;
    for (int k = 0; k < 3; ++k)
    {
      places[k] = this->Coordinates[this->Triangles[triangle][k]] * size - 0.5;
      far = far || std::max(std::abs(places[k].x), std::abs(places[k].y)) > FarthestTexel;
    }
    if (far || !MesoTrianglePatch::Spans(places))
    {
      places = Barycentric;
    }
  }
  return places;
}

bool MesoReferenceSurface::HasChart(std::size_t triangle) const
{
  return this->Map && this->PlacesOf(triangle) != Barycentric;
}

MesoTrianglePatch MesoReferenceSurface::TrianglePatch(std::size_t number) const
{
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec3, 3> normals;
  for (int k = 0; k < 3; ++k)
  {
    positions[k] = this->Points[this->Triangles[number][k]];
    normals[k] = this->Normals[this->Triangles[number][k]];
  }
  // The mesh of a mirrored node has had its winding turned.
  return { positions, normals, this->PlacesOf(number), this->Mirrored };
}

MesoShapePatch MesoReferenceSurface::ShapePatch(std::size_t number) const
{
  const std::array<int, 2> cuts = this->Shape->Charts()[0].Segments;
  const glm::dvec2 size = this->Map
    ? glm::dvec2(this->Map->X().Texels(), this->Map->Y().Texels()) * this->Tiles
    : this->Tiles; // texels, or tiles, on the whole shape
  const std::size_t column = number % cuts[0];
  const std::size_t row = number / cuts[0];
  const auto i = static_cast<double>(column);
  const auto j = static_cast<double>(row);
  return { *this->Shape,
    { size.x * i / cuts[0] - 0.5, size.x * (i + 1.) / cuts[0] - 0.5, size.y * j / cuts[1] - 0.5,
      size.y * (j + 1.) / cuts[1] - 0.5 },
    1. / size.x, 1. / size.y };
}

MesoDisplacement MesoReferenceSurface::DrawnBase() const
{
  MesoDisplacement base;
  base.Scale = this->Scale;
  base.Reference = this->Reference;
  return base;
}

MesoDisplacement MesoReferenceSurface::Over(std::size_t patch) const
{
  MesoDisplacement over = this->DrawnBase();
  if (this->Shape || !this->Map || this->HasChart(patch))
  {
    over.Map = this->Map.get();
    return over;
  }
  glm::dvec2 middle(0.);
  for (std::uint32_t corner : this->Triangles[patch])
  {
    middle += this->Coordinates[corner] / 3.;
  }
  over.Height =
    std::isfinite(middle.x + middle.y) ? this->Map->HeightAt(middle.x, middle.y) : over.Reference;
  return over;
}

MesoBox MesoReferenceSurface::BoundsOf(std::size_t patch) const
{
  if (this->Shell)
  {
    return this->Shell->BoundsOf(patch, this->Matrix);
  }
  if (!this->Shape)
  {
    for (std::uint32_t corner : this->Triangles[patch])
    {
      if (!IsFinite(this->Points[corner]) || !IsFinite(this->Normals[corner]))
      {
        const glm::dvec3 none(std::numeric_limits<double>::quiet_NaN());
        return { none, none };
      }
    }
  }
  MesoBox box;
  this->WithPatch(patch,
    [&](const MesoBasePatch& base, const MesoDisplacement& over)
    {
      double low = over.Height;
      double high = over.Height;
      if (over.Map)
      {
        const auto range = over.Map->RangeOf(over.Map->TopLevel(), 0, 0);
        low = range.Low;
        high = range.High;
      }
      const double drawn = (1. - over.Reference) * over.Scale;
      box = base.Bounds(this->Matrix, std::min(drawn, (low - over.Reference) * over.Scale),
        std::max(drawn, (high - over.Reference) * over.Scale));
    });
  return box;
}

glm::dvec3 MesoReferenceSurface::PositionAt(std::size_t patch, double x, double y) const
{
  glm::dvec3 position;
  this->WithPatch(patch,
    [&](const MesoBasePatch& base, const MesoDisplacement& over)
    {
      const MesoBasePoint point = base.At(x, y);
      double height = over.Height;
      if (over.Map)
      {
        height = over.Map->HeightAt(
          (x + 0.5) / over.Map->X().Texels(), (y + 0.5) / over.Map->Y().Texels());
      }
      const glm::dvec3 q = point.P + (height - over.Reference) * over.Scale * point.N;
      position = glm::dvec3(this->Matrix * glm::dvec4(q, 1.));
    });
  return position;
}

glm::dvec2 MesoReferenceSurface::MapCoordAt(
  const MesoBasePatch& patch, const MesoReferenceHit& hit) const
{
  if (this->Shape || this->HasChart(hit.Patch))
  {
    const glm::dvec2 size =
      this->Map ? glm::dvec2(this->Map->X().Texels(), this->Map->Y().Texels()) : glm::dvec2(1.);
    return (glm::dvec2(hit.X, hit.Y) + 0.5) / size;
  }
  glm::dvec2 coordinate(0.);
  if (!this->Coordinates.empty())
  {
    const glm::dvec3 weights = patch.Weights(hit.X, hit.Y);
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec2& corner = this->Coordinates[this->Triangles[hit.Patch][k]];
      coordinate += std::isfinite(corner.x + corner.y) ? weights[k] * corner : glm::dvec2(0.);
    }
  }
  return coordinate;
}

std::optional<glm::dvec3> MesoReferenceSurface::MappedNormal(const MesoReferenceHit& hit,
  const MesoBasePatch& patch, const glm::dvec3& px, const glm::dvec3& py,
  const glm::dvec3& normal) const
{
  glm::dvec3 perU = px;
  glm::dvec3 perV = py;
  if (!this->Shape && !this->HasChart(hit.Patch))
  {
    // The patch's own coordinates are weights of the corners, not places on the map.
    if (this->Coordinates.empty())
    {
      return {};
    }
    const auto& corners = this->Triangles[hit.Patch];
    const glm::dvec2 alongX = this->Coordinates[corners[1]] - this->Coordinates[corners[0]];
    const glm::dvec2 alongY = this->Coordinates[corners[2]] - this->Coordinates[corners[0]];
    const double area = alongX.x * alongY.y - alongX.y * alongY.x;
    perU = (alongY.y * px - alongX.y * py) / area;
    perV = (alongX.x * py - alongY.x * px) / area;
  }
  return this->NormalMap->NormalAt(this->MapCoordAt(patch, hit), this->Tiles, perU, perV, normal);
}

glm::dvec2 MesoReferenceSurface::ShadingGradient(double x, double y) const
{
  const auto column = static_cast<std::int64_t>(std::floor(x));
  const auto row = static_cast<std::int64_t>(std::floor(y));
  const double a = x - static_cast<double>(column);
  const double b = y - static_cast<double>(row);
  const auto central = [&](std::int64_t i, std::int64_t j)
  {
    return 0.5 *
      glm::dvec2(this->Map->Height(i + 1, j) - this->Map->Height(i - 1, j),
        this->Map->Height(i, j + 1) - this->Map->Height(i, j - 1));
  };
  return (1. - b) * ((1. - a) * central(column, row) + a * central(column + 1, row)) +
    b * ((1. - a) * central(column, row + 1) + a * central(column + 1, row + 1));
}

MesoReferencePoint MesoReferenceSurface::DescribeInShell(
  const MesoReferenceHit& hit, const glm::dvec3& ray) const
{
  MesoPrismHit inPrism;
  inPrism.Place = { hit.X, hit.Y, hit.Z };
  inPrism.Cut = hit.Cut;
  const MesoReferenceShell::Point point =
    this->Shell->Describe(hit.Patch, inPrism, glm::dmat3(this->Inverse) * ray);
  const auto toWorld = [&](const glm::dvec3& normal)
  {
    return hit.Cut == -2 || !(glm::dot(normal, normal) > 0.) ? -glm::normalize(ray)
                                                             : NormalToWorld(this->Inverse, normal);
  };
  MesoReferencePoint result;
  result.Geometric = toWorld(point.Geometric);
  result.Shading = toWorld(point.Shading);
  result.MapCoord = point.MapCoord;
  result.Relief = point.Relief;
  result.Color = point.Color;
  result.TexelSize =
    point.VoxelSize * std::cbrt(std::abs(glm::determinant(glm::dmat3(this->Matrix))));
  return result;
}

MesoReferencePoint MesoReferenceSurface::Describe(
  const MesoReferenceHit& hit, const glm::dvec3& ray) const
{
  if (this->Shell)
  {
    return this->DescribeInShell(hit, ray);
  }
  MesoReferencePoint result;
  this->WithPatch(hit.Patch,
    [&](const MesoBasePatch& patch, const MesoDisplacement& over)
    {
      const MesoBasePoint base = patch.At(hit.X, hit.Y);
      const bool mapped = over.Map && !hit.OnBase;
      const bool displaced = this->Displaced && !hit.OnBase;
      double height = displaced ? over.Height : 1.;
      glm::dvec2 slope(0.); // of the surface itself, per texel
      glm::dvec2 shadingSlope(0.);
      if (mapped && over.Map->Interpolation() == MesoInterpolation::Bicubic)
      {
        const glm::dvec3 spline = MesoSplineCell::At(*over.Map, hit.X, hit.Y);
        height = spline.x;
        slope = { spline.y, spline.z };
        shadingSlope = slope;
      }
      else if (mapped)
      {
        const int width = over.Map->X().Texels();
        const int rows = over.Map->Y().Texels();
        height = over.Map->HeightAt((hit.X + 0.5) / width, (hit.Y + 0.5) / rows);
        const auto i = static_cast<std::int64_t>(std::floor(hit.X));
        const auto j = static_cast<std::int64_t>(std::floor(hit.Y));
        const double a = hit.X - static_cast<double>(i);
        const double b = hit.Y - static_cast<double>(j);
        const double h00 = over.Map->Height(i, j);
        const double h10 = over.Map->Height(i + 1, j);
        const double h01 = over.Map->Height(i, j + 1);
        const double h11 = over.Map->Height(i + 1, j + 1);
        slope = { (1. - b) * (h10 - h00) + b * (h11 - h01),
          (1. - a) * (h01 - h00) + a * (h11 - h10) };
        shadingSlope = this->ShadingGradient(hit.X, hit.Y);
      }
      const double g = (height - over.Reference) * over.Scale;
      const auto tangents = [&](const glm::dvec3& px, const glm::dvec3& py, const glm::dvec2& by)
      {
        return glm::cross(px + over.Scale * by.x * base.N + g * base.Nx,
          py + over.Scale * by.y * base.N + g * base.Ny);
      };
      const glm::dvec3 geometric = NormalToWorld(this->Inverse, tangents(base.Px, base.Py, slope));
      result.Geometric = glm::dot(geometric, ray) <= 0. ? geometric : -geometric;

      // For shading the base is the smooth surface that its normals stand for: dp/dx, dp/dy in the
      // plane at right angles to n, so that a flat map gives n itself.
      const glm::dvec3 px = base.Px - base.N * glm::dot(base.N, base.Px);
      const glm::dvec3 py = base.Py - base.N * glm::dot(base.N, base.Py);
      const double area = glm::dot(glm::cross(px, py), base.N);
      glm::dvec3 shading =
        area < 0. ? -tangents(px, py, shadingSlope) : tangents(px, py, shadingSlope);
      if (!mapped || area == 0. || !(glm::dot(shading, shading) > 0.))
      {
        shading = base.N;
      }
      if (!(glm::dot(shading, shading) > 0.))
      {
        shading = tangents(base.Px, base.Py, slope); // a mesh with normals of length 0
      }
      if (this->NormalMap && !hit.OnBase && !hit.Behind)
      {
        shading = this->MappedNormal(hit, patch, px, py, base.N).value_or(shading);
      }
      result.Shading = NormalToWorld(this->Inverse, shading);
      if (hit.Behind)
      {
        result.Shading = -result.Shading;
      }
      result.MapCoord = this->MapCoordAt(patch, hit);
      result.Relief = displaced ? std::min(std::max(1. - height, 0.), 1.) : 0.; // rounding
      result.TexelSize = 1e-3 * this->Diagonal;
      if (over.Map)
      {
        const glm::dmat3 linear(this->Matrix);
        result.TexelSize = std::max(1e-9 * this->Diagonal,
          std::min(glm::length(linear * base.Px), glm::length(linear * base.Py)));
      }
    });
  return result;
}

std::size_t MesoReferenceSurface::MemoryBytes() const
{
  return (this->Map ? this->Map->MemoryBytes() : 0) +
    (this->Shell ? this->Shell->MemoryBytes() : 0) +
    (this->Points.size() + this->Normals.size()) * sizeof(glm::dvec3) +
    this->Coordinates.size() * sizeof(glm::dvec2) +
    this->Triangles.size() * sizeof(this->Triangles[0]);
}

#ifndef MesoDicer_h
#define MesoDicer_h

/**
 * @class MesoDicer
 * @brief Fills the points of a MesoDicePlan with places on a MesoDisplacement.
 *
 * Real is the type of the arrays that are filled; all is computed in double. The three kinds of
 * points are filled in any order and by any number of threads, each number by one of them.
 *
 * A corner or an edge of the mesh that belongs to several charts has a diced point for each. Where
 * normal and height agree (MesoDisplacement::Agree) they take the position of the first, and all
 * take the mean of the normals of all triangles around (at corners weighted by their angles), so
 * that the surface is closed and shows no seam. Where they do not agree the surface is torn.
 */

#include "MesoCornerNormals.h"
#include "MesoDicePlan.h"
#include "MesoDisplacement.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <vector>

/// Arrays of MesoDicePlan::NumberOfPoints() tuples.
template <typename Real>
struct MesoDicedArrays
{
  Real* Positions;   ///< 3
  Real* Normals;     ///< 3
  Real* Coordinates; ///< 2, the mesh's own
  Real* Reliefs;     ///< 1 - h
  /// Where it is set, called for each point with those of the base that it lies between and their
  /// weights: (count, points, weights, diced point).
  std::function<void(int, const std::int64_t*, const double*, std::int64_t)> Carry;
};

template <typename Real>
class MesoDicer
{
public:
  /// All but the arrays are kept by reference. Normals are those of the displaced surface, or, with
  /// `detailNormals` false, n.
  MesoDicer(const MesoDicePlan& plan, const MesoDisplacement& surface, const MesoTriangleMesh& mesh,
    const MesoDicedArrays<Real>& arrays, bool detailNormals)
    : Plan(plan)
    , Surface(surface)
    , Arrays(arrays)
    , Mesh(mesh)
    , DetailNormals(detailNormals)
    , Measures(MesoMeasureTriangles(mesh))
  {
    for (const MesoDicePlan::Grid& grid : plan.GetGrids())
    {
      for (std::int64_t corner = 3 * grid.Triangle; corner < 3 * grid.Triangle + 3; ++corner)
      {
        this->Corners.push_back(corner);
      }
    }
    const auto key = [&](std::int64_t corner)
    { return std::make_tuple(mesh.VertexOf(corner), mesh.PointOf(corner), corner); };
    std::sort(this->Corners.begin(), this->Corners.end(),
      [&](std::int64_t a, std::int64_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      if (i == 0 || mesh.VertexOf(this->Corners[i]) != mesh.VertexOf(this->Corners[i - 1]))
      {
        this->Vertices.push_back(i);
      }
    }
    this->Vertices.push_back(this->Corners.size());
  }

  std::int64_t NumberOfVertices() const { return std::int64_t(this->Vertices.size()) - 1; }
  std::int64_t NumberOfEdges() const { return std::int64_t(this->Plan.GetEdges().size()) - 1; }

  /// Fills the points in the v-th merged vertex that triangles use.
  void FillVertex(std::int64_t v) const
  {
    std::vector<Place> places;
    for (std::size_t i = this->Vertices[v]; i < this->Vertices[v + 1]; ++i)
    {
      const std::int64_t corner = this->Corners[i];
      const std::int64_t point = this->Mesh.PointOf(corner);
      if (places.empty() || places.back().Number != this->Plan.NumberOf(point))
      {
        places.push_back(this->PlaceAt(this->Surface.At(point), this->Plan.NumberOf(point)));
        this->Carry<1>({ point }, { 1. }, places.back());
      }
      const std::int64_t triangle = corner / 3;
      this->AddNormal(this->Surface.DerivativesOf(triangle),
        this->Measures[triangle].Angles[corner % 3], places.back());
    }
    this->Write(places);
  }

  /// Fills the points inside an edge.
  void FillEdge(std::int64_t edge) const
  {
    const auto& sides = this->Plan.GetSides();
    const std::int64_t first = this->Plan.GetEdges()[edge];
    const std::int64_t end = this->Plan.GetEdges()[edge + 1];
    const std::int64_t segments = sides[first].Segments;
    std::vector<MesoDisplacement::Derivatives> derivatives;
    for (std::int64_t half = sides[first].FirstHalfEdge;
         segments > 1 && half < sides[end - 1].EndHalfEdge; ++half)
    {
      derivatives.push_back(this->Surface.DerivativesOf(this->Plan.GetHalfEdges()[half] / 3));
    }
    std::vector<Place> places;
    for (std::int64_t segment = 1; segment < segments; ++segment)
    {
      places.clear();
      for (std::int64_t s = first; s < end; ++s)
      {
        const MesoDicePlan::Side& side = sides[s];
        const double along = static_cast<double>(segment) / static_cast<double>(segments);
        places.push_back(this->PlaceAt(this->Surface.Between(side.Ends[0], side.Ends[1], along),
          this->Plan.PointOn(side, segment)));
        this->Carry<2>(side.Ends, { 1. - along, along }, places.back());
        for (std::int64_t half = side.FirstHalfEdge; half < side.EndHalfEdge; ++half)
        {
          this->AddNormal(derivatives[half - sides[first].FirstHalfEdge], 1., places.back());
        }
      }
      this->Write(places);
    }
  }

  /// Fills a row's points inside its triangle.
  void FillRow(const MesoDicePlan::Grid& grid, std::int64_t row) const
  {
    if (grid.Inside(row) == 0)
    {
      return;
    }
    const MesoDisplacement::Derivatives derivatives = this->Surface.DerivativesOf(grid.Triangle);
    for (std::int64_t k = 0; k < grid.Inside(row); ++k)
    {
      const MesoDicePlan::Inner inner = MesoDicePlan::InnerAt(grid, row, k);
      Place place =
        this->PlaceAt(this->Surface.Inside(grid.Triangle, inner.I, inner.J), inner.Point);
      this->Carry<3>(
        this->Mesh.Triangles[grid.Triangle], { 1. - inner.I - inner.J, inner.I, inner.J }, place);
      this->AddNormal(derivatives, 1., place);
      this->WriteOne(place, place);
    }
  }

  /// The largest distance between the sides of an edge, in object units; 0 where it is closed. To be
  /// asked when all points are filled.
  double TearOf(std::int64_t edge) const
  {
    const auto& sides = this->Plan.GetSides();
    const std::int64_t first = this->Plan.GetEdges()[edge];
    double tear = 0.;
    for (std::int64_t s = first + 1; s < this->Plan.GetEdges()[edge + 1]; ++s)
    {
      for (std::int64_t segment = 0; segment <= sides[s].Segments; ++segment)
      {
        const MesoVector a = this->PositionOf(this->Plan.PointOn(sides[first], segment));
        const MesoVector b = this->PositionOf(this->Plan.PointOn(sides[s], segment));
        tear = std::max(tear, MesoLength(MesoDifference(a, b)));
      }
    }
    return tear;
  }

private:
  /// A diced point while its normal is gathered.
  struct Place
  {
    std::int64_t Number;
    MesoBasePoint Base;
    MesoDisplacedPoint Point;
    std::array<double, 2> Gradient;
    MesoVector Normal;
  };

  Place PlaceAt(const MesoBasePoint& base, std::int64_t number) const
  {
    Place place = { number, base, this->Surface.Displaced(base), {}, { 0., 0., 0. } };
    if (this->DetailNormals)
    {
      place.Gradient = this->Surface.Gradient(place.Point);
    }
    return place;
  }

  template <std::size_t N>
  void Carry(const std::array<std::int64_t, N>& points, const std::array<double, N>& weights,
    const Place& place) const
  {
    if (this->Arrays.Carry)
    {
      this->Arrays.Carry(static_cast<int>(N), points.data(), weights.data(), place.Number);
    }
  }

  void AddNormal(
    const MesoDisplacement::Derivatives& derivatives, double weight, Place& place) const
  {
    const MesoVector normal = this->DetailNormals
      ? this->Surface.ShadingNormal(derivatives, place.Base, place.Point, place.Gradient)
      : place.Point.UnitNormal;
    place.Normal = MesoSum(place.Normal, MesoScaled(normal, weight));
  }

  void Write(std::vector<Place>& places) const
  {
    std::vector<std::size_t> first(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::size_t like = 0;
      while (like < i &&
        (first[like] != like || !this->Surface.Agree(places[like].Point, places[i].Point)))
      {
        ++like;
      }
      first[i] = like;
      if (like < i)
      {
        places[like].Normal = MesoSum(places[like].Normal, places[i].Normal);
      }
    }
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->WriteOne(places[i], places[first[i]]);
    }
  }

  /// The place's own coordinate, all else as at `like`.
  void WriteOne(const Place& place, const Place& like) const
  {
    double length = MesoLength(like.Normal);
    MesoVector normal = like.Normal;
    if (!(length > 0.))
    {
      normal = like.Point.UnitNormal;
      length = MesoLength(normal);
    }
    normal = length > 0. ? MesoScaled(normal, 1. / length) : MesoVector{ 0., 0., 1. };
    for (int k = 0; k < 3; ++k)
    {
      this->Arrays.Positions[3 * place.Number + k] = static_cast<Real>(like.Point.Position[k]);
      this->Arrays.Normals[3 * place.Number + k] = static_cast<Real>(normal[k]);
    }
    this->Arrays.Coordinates[2 * place.Number] = static_cast<Real>(place.Base.Coordinate[0]);
    this->Arrays.Coordinates[2 * place.Number + 1] = static_cast<Real>(place.Base.Coordinate[1]);
    this->Arrays.Reliefs[place.Number] = static_cast<Real>(1. - like.Point.Height);
  }

  MesoVector PositionOf(std::int64_t number) const
  {
    const Real* p = this->Arrays.Positions + 3 * number;
    return { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) };
  }

  const MesoDicePlan& Plan;
  const MesoDisplacement& Surface;
  MesoDicedArrays<Real> Arrays;
  const MesoTriangleMesh& Mesh;
  bool DetailNormals;
  std::vector<MesoTriangleMeasure> Measures;
  std::vector<std::int64_t> Corners; ///< used ones, by merged vertex and point
  std::vector<std::size_t> Vertices; ///< where each merged vertex begins in Corners
};

#endif

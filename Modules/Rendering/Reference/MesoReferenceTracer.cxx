#include "MesoReferenceTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Corners of a facet in units of a triangle's cuts. Row r of n has 2 (n - r) - 1 facets, upright ones
/// at even places and others between, so that before it there are n^2 - (n - r)^2.
std::array<glm::ivec2, 3> FacetCorners(std::uint32_t facet, std::uint32_t cuts)
{
  const double left = static_cast<double>(cuts) * cuts - facet; // exact: below 2^53
  const auto rows = static_cast<std::uint32_t>(std::ceil(std::sqrt(left)));
  const int row = static_cast<int>(cuts - rows);
  const auto inRow = static_cast<int>(facet - (cuts * cuts - rows * rows));
  const int i = inRow / 2;
  if (inRow % 2 == 0)
  {
    return { glm::ivec2(i, row), glm::ivec2(i + 1, row), glm::ivec2(i, row + 1) };
  }
  return { glm::ivec2(i + 1, row), glm::ivec2(i + 1, row + 1), glm::ivec2(i, row + 1) };
}

/// Point (i, j) of a triangular grid, rows one after the other.
std::uint32_t GridPoint(const glm::ivec2& at, std::uint32_t cuts)
{
  const auto row = static_cast<std::uint32_t>(at.y);
  return row * (cuts + 1) - row * (row - 1) / 2 + static_cast<std::uint32_t>(at.x);
}

glm::dvec2 PlaceOf(
  const std::array<glm::dvec2, 3>& places, const glm::dvec2& at, std::uint32_t cuts)
{
  const double second = at.x / cuts;
  const double third = at.y / cuts;
  return (1. - second - third) * places[0] + second * places[1] + third * places[2];
}
}

void MesoTraceWork::Add(const MesoTraceWork& other)
{
  this->Rays += other.Rays;
  this->Solver.Blocks += other.Solver.Blocks;
  this->Solver.Pieces += other.Solver.Pieces;
  this->Solver.Unresolved += other.Solver.Unresolved;
  this->Solver.LargestResidual =
    std::max(this->Solver.LargestResidual, other.Solver.LargestResidual);
}

/// One ray's way through the scene.
class MesoReferenceTracer::Query final : public MesoRayQuery
{
public:
  enum class Kind
  {
    Surface,
    BaseFront,
    BaseBack
  };

  Query(const MesoReferenceTracer& tracer, const Ray& ray, Kind kind, MesoTraceWork& work)
    : Tracer(tracer)
    , What(kind)
    , Work(work)
  {
    this->Origin = ray.Origin;
    this->Direction = ray.Direction;
    this->TMin = ray.TMin;
    this->TMax = ray.TMax;
    ++this->Work.Rays;
  }

  int Only = -1;    ///< the one surface that counts, or all
  int From = -1;    ///< the surface whose base, drawn from behind, does not count
  bool Any = false; ///< a shadow's ray: the first thing found ends it, whichever side it shows
  bool Found = false;
  MesoReferenceHit Best;

  void Test(int geometry, unsigned int primitive) override
  {
    const MesoReferenceSurface& surface = *this->Tracer.Surfaces[geometry];
    if (this->Only >= 0 && geometry != this->Only)
    {
      return;
    }
    this->Enter(geometry);
    if (surface.GetShell())
    {
      this->SolvePrism(geometry, primitive, *surface.GetShell());
      return;
    }
    surface.WithPatch(primitive,
      [&](const MesoBasePatch& patch, const MesoDisplacement& over)
      {
        switch (this->What)
        {
          case Kind::BaseFront:
            this->Solve(geometry, primitive, patch, surface.DrawnBase(), MesoFacing::Front);
            return;
          case Kind::BaseBack:
            this->SolveBack(geometry, primitive, patch);
            return;
          case Kind::Surface:
            break;
        }
        this->Solve(geometry, primitive, patch, over,
          this->HitsBacks(surface) ? MesoFacing::Both : MesoFacing::Front);
        this->SolveBack(geometry, primitive, patch);
      });
  }

  bool TestTriangle(int geometry, unsigned int primitive, double t, bool front) override
  {
    if ((this->Only >= 0 && geometry != this->Only) ||
      !(front || this->HitsBacks(*this->Tracer.Surfaces[geometry])))
    {
      return false;
    }
    MesoReferenceHit next;
    next.Object = geometry;
    next.Patch = primitive; // the facet, as yet
    next.T = t;
    next.Behind = !front;
    this->Take(next);
    return true;
  }

private:
  /// Whether the surface's backs are hit, beside its fronts.
  bool HitsBacks(const MesoReferenceSurface& surface) const
  {
    return this->Any || (surface.IsTwoSided() && !surface.IsDisplaced());
  }

  /// Bring the ray to a surface's own space, with its start near by, where numbers are small.
  void Enter(int geometry)
  {
    if (this->Entered == geometry)
    {
      return;
    }
    this->Entered = geometry;
    const MesoReferenceSurface& surface = *this->Tracer.Surfaces[geometry];
    const glm::dmat4& toObject = surface.WorldToObject();
    const glm::dvec3 origin = glm::dvec3(toObject * glm::dvec4(this->Origin, 1.));
    const glm::dvec3 direction = glm::dmat3(toObject) * this->Direction;
    this->Shift = glm::dot(surface.Centre() - origin, direction) / glm::dot(direction, direction);
    this->Start = origin + this->Shift * direction;
    this->Along = direction;
    this->Solver = MesoPatchSolver(origin + this->Shift * direction, direction,
      this->TMin - this->Shift, this->TMax - this->Shift);
  }

  void SolveBack(int geometry, unsigned int primitive, const MesoBasePatch& patch)
  {
    const MesoReferenceSurface& surface = *this->Tracer.Surfaces[geometry];
    if (surface.IsTwoSided() && surface.IsDisplaced() && geometry != this->From)
    {
      this->Solve(geometry, primitive, patch, surface.DrawnBase(), MesoFacing::Back, true);
    }
  }

  void Solve(int geometry, unsigned int primitive, const MesoBasePatch& patch,
    const MesoDisplacement& over, MesoFacing facing, bool onBase = false)
  {
    if (this->Done)
    {
      return;
    }
    // Up to and with the best so far: of hits at the same t the one of the lowest number counts,
    // whatever the order of asking.
    this->Solver.SetTMax(
      std::nextafter(this->TMax - this->Shift, std::numeric_limits<double>::infinity()));
    MesoPatchHit hit;
    const MesoSolverWork before = this->Solver.Work();
    const bool found = this->Solver.FirstHit(patch, over, facing, this->Any, hit);
    const MesoSolverWork& after = this->Solver.Work();
    this->Work.Solver.Blocks += after.Blocks - before.Blocks;
    this->Work.Solver.Pieces += after.Pieces - before.Pieces;
    this->Work.Solver.Unresolved += after.Unresolved - before.Unresolved;
    this->Work.Solver.LargestResidual =
      std::max(this->Work.Solver.LargestResidual, after.LargestResidual);
    if (found)
    {
      MesoReferenceHit next;
      next.Object = geometry;
      next.Patch = primitive;
      next.T = hit.T + this->Shift;
      next.X = hit.X;
      next.Y = hit.Y;
      next.OnBase = onBase;
      next.Behind = !hit.Front;
      this->Take(next);
    }
  }

  void SolvePrism(int geometry, unsigned int primitive, const MesoReferenceShell& shell)
  {
    MesoPrismHit hit;
    // Up to and with the best so far, as in Solve.
    const double last =
      std::nextafter(this->TMax - this->Shift, std::numeric_limits<double>::infinity());
    if (this->What == Kind::Surface && !this->Done &&
      MesoFirstInPrism(shell.PrismOf(primitive), shell.GetVolume(), this->Start, this->Along,
        this->TMin - this->Shift, last, hit, this->Work.Solver))
    {
      MesoReferenceHit next;
      next.Object = geometry;
      next.Patch = primitive;
      next.T = hit.T + this->Shift;
      next.X = hit.Place.x;
      next.Y = hit.Place.y;
      next.Z = hit.Place.z;
      next.Cut = hit.Cut;
      this->Take(next);
    }
  }

  void Take(const MesoReferenceHit& next)
  {
    const bool later = this->Found &&
      (next.T > this->Best.T ||
        (next.T == this->Best.T &&
          std::make_pair(next.Object, next.Patch) >=
            std::make_pair(this->Best.Object, this->Best.Patch)));
    if (!later)
    {
      this->Found = true;
      this->Best = next;
      this->TMax = std::min(this->TMax, next.T);
      this->Done = this->Any;
    }
  }

  const MesoReferenceTracer& Tracer;
  Kind What;
  MesoTraceWork& Work;
  int Entered = -1;
  double Shift = 0.;
  glm::dvec3 Start; ///< the ray in the space of the surface that it has entered
  glm::dvec3 Along;
  MesoPatchSolver Solver{ glm::dvec3(0.), glm::dvec3(0., 0., 1.), 0., 0. };
};

MesoReferenceTracer::MesoReferenceTracer(
  const std::vector<std::unique_ptr<MesoReferenceSurface>>& surfaces, double facetsPerTexel)
  : Surfaces(surfaces)
{
  for (const auto& surface : surfaces)
  {
    this->Patches.AddPrimitives(
      surface->NumberOfPatches(), [&](std::size_t patch) { return surface->BoundsOf(patch); });
    this->AnyTwoSided = this->AnyTwoSided || (surface->IsTwoSided() && surface->IsDisplaced());
  }
  this->Patches.Commit();
  if (facetsPerTexel > 0.)
  {
    this->Dice(facetsPerTexel);
  }
}

void MesoReferenceTracer::Dice(double facetsPerTexel)
{
  this->Diced = std::make_unique<MesoRayScene>();
  for (const auto& surface : this->Surfaces)
  {
    if (surface->IsSmooth())
    {
      throw MesoInputError("the surface 'smooth' cannot be diced");
    }
    if (surface->GetShell())
    {
      throw MesoInputError("a volume cannot be diced");
    }
    Dicing dicing;
    dicing.FirstFacet.push_back(0);
    for (std::size_t i = 0; i < surface->NumberOfTriangles(); ++i)
    {
      double cuts = 1.;
      if (surface->IsDisplaced())
      {
        const std::array<glm::dvec2, 3> places = surface->PlacesOf(i);
        for (int k = 0; k < 3; ++k)
        {
          cuts = std::max(
            cuts, std::ceil(facetsPerTexel * glm::length(places[(k + 1) % 3] - places[k])));
        }
      }
      this->Facets += static_cast<std::size_t>(std::min(cuts * cuts, 1e12));
      if (this->Facets > MostFacets)
      {
        throw MesoInputError(
          "the diced surface would have more than " + std::to_string(MostFacets) + " facets");
      }
      dicing.Cuts.push_back(static_cast<std::uint32_t>(cuts));
      dicing.FirstFacet.push_back(
        dicing.FirstFacet.back() + dicing.Cuts.back() * dicing.Cuts.back());
    }
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> facets;
    facets.reserve(dicing.FirstFacet.back());
    for (std::size_t i = 0; i < dicing.Cuts.size(); ++i)
    {
      const auto cuts = static_cast<int>(dicing.Cuts[i]);
      const auto first = static_cast<std::uint32_t>(points.size());
      const std::array<glm::dvec2, 3> places = surface->PlacesOf(i);
      for (int row = 0; row <= cuts; ++row)
      {
        for (int column = 0; column <= cuts - row; ++column)
        {
          const glm::dvec2 place = PlaceOf(places, { column, row }, cuts);
          points.push_back(surface->PositionAt(i, place.x, place.y));
        }
      }
      for (int facet = 0; facet < cuts * cuts; ++facet)
      {
        std::array<std::uint32_t, 3> corners;
        const auto at = FacetCorners(facet, cuts);
        for (int k = 0; k < 3; ++k)
        {
          corners[k] = first + GridPoint(at[k], cuts);
        }
        facets.push_back(corners);
      }
    }
    this->Diced->AddTriangles(points, std::move(facets));
    this->Dicings.push_back(std::move(dicing));
  }
  this->Diced->Commit();
}

void MesoReferenceTracer::FromFacet(const Ray& ray, MesoReferenceHit& hit) const
{
  const MesoReferenceSurface& surface = *this->Surfaces[hit.Object];
  const Dicing& dicing = this->Dicings[hit.Object];
  const std::uint32_t facet = hit.Patch;
  const auto after = std::upper_bound(dicing.FirstFacet.begin(), dicing.FirstFacet.end(), facet);
  hit.Patch = static_cast<unsigned int>(after - dicing.FirstFacet.begin()) - 1;
  const std::uint32_t cuts = dicing.Cuts[hit.Patch];
  const auto corners = FacetCorners(facet - dicing.FirstFacet[hit.Patch], cuts);
  const std::array<glm::dvec2, 3> places = surface.PlacesOf(hit.Patch);
  glm::dvec3 points[3];
  glm::dvec2 at[3];
  for (int k = 0; k < 3; ++k)
  {
    at[k] = PlaceOf(places, corners[k], cuts);
    points[k] = surface.PositionAt(hit.Patch, at[k].x, at[k].y);
  }
  const glm::dvec3 a = points[1] - points[0];
  const glm::dvec3 b = points[2] - points[0];
  const glm::dvec3 normal = glm::cross(a, b);
  const double towards = glm::dot(normal, ray.Direction);
  if (towards != 0.)
  {
    hit.T = glm::dot(points[0] - ray.Origin, normal) / towards;
  }
  const glm::dvec3 from = ray.Origin + hit.T * ray.Direction - points[0];
  const double perArea = 1. / glm::dot(normal, normal);
  const double second = glm::dot(glm::cross(from, b), normal) * perArea;
  const double third = glm::dot(glm::cross(a, from), normal) * perArea;
  const glm::dvec2 place = (1. - second - third) * at[0] + second * at[1] + third * at[2];
  hit.X = place.x;
  hit.Y = place.y;
}

void MesoReferenceTracer::AddClippingPlane(const glm::dvec3& point, const glm::dvec3& normal)
{
  this->ClippingPlanes.emplace_back(normal, -glm::dot(normal, point));
}

MesoReferenceTracer::Ray MesoReferenceTracer::Kept(const Ray& ray) const
{
  Ray kept = ray;
  for (const glm::dvec4& plane : this->ClippingPlanes)
  {
    const double above = glm::dot(plane, glm::dvec4(ray.Origin, 1.));
    const double rise = glm::dot(glm::dvec3(plane), ray.Direction);
    if (rise > 0.)
    {
      kept.TMin = std::max(kept.TMin, -above / rise);
    }
    else if (rise < 0.)
    {
      kept.TMax = std::min(kept.TMax, -above / rise);
    }
    else if (above < 0.)
    {
      kept.TMax = -std::numeric_limits<double>::infinity();
    }
  }
  return kept;
}

bool MesoReferenceTracer::Trace(const Ray& whole, MesoReferenceHit& hit, MesoTraceWork& work) const
{
  const Ray ray = this->Kept(whole);
  if (ray.TMin > ray.TMax)
  {
    return false;
  }
  Query query(*this, ray, Query::Kind::Surface, work);
  (this->Diced ? *this->Diced : this->Patches).Trace(query);
  if (this->Diced && query.Found)
  {
    this->FromFacet(ray, query.Best);
  }
  if (this->Diced && this->AnyTwoSided)
  {
    Ray rest = ray;
    rest.TMax = query.TMax;
    Query backs(*this, rest, Query::Kind::BaseBack, work);
    this->Patches.Trace(backs);
    query.Found = query.Found || backs.Found;
    query.Best = backs.Found ? backs.Best : query.Best;
  }
  if (query.Found)
  {
    hit = query.Best;
  }
  return query.Found;
}

bool MesoReferenceTracer::Blocked(const Ray& whole, int from, bool alone, MesoTraceWork& work) const
{
  const Ray ray = this->Kept(whole);
  if (ray.TMin > ray.TMax)
  {
    return false;
  }
  Query query(*this, ray, Query::Kind::Surface, work);
  query.From = from;
  query.Only = alone ? from : -1;
  query.Any = true;
  (this->Diced ? *this->Diced : this->Patches).Trace(query);
  return query.Found;
}

bool MesoReferenceTracer::MeetsBase(const Ray& ray, int surface, MesoTraceWork& work) const
{
  Query query(*this, ray, Query::Kind::BaseFront, work);
  query.Only = surface;
  query.Any = true;
  this->Patches.Trace(query);
  return query.Found;
}

std::size_t MesoReferenceTracer::MemoryBytes() const
{
  std::size_t bytes = this->Patches.MemoryBytes() + (this->Diced ? this->Diced->MemoryBytes() : 0);
  for (const Dicing& dicing : this->Dicings)
  {
    bytes += 2 * dicing.Cuts.size() * sizeof(std::uint32_t);
  }
  return bytes;
}

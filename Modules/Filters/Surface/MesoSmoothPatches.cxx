#include "MesoSmoothPatches.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace
{
// Of the angles around a point, what a site must have to stand for it.
constexpr double LeastShare = 0.8;
// More neighbours than this are thinned out.
constexpr std::int64_t MostNeighbours = 128;
constexpr std::size_t MostInRing = 128;
}

MesoSmoothPatches::MesoSmoothPatches(const MesoTriangleMesh& mesh, double featureAngle)
  : Mesh(mesh)
{
  const std::vector<MesoTriangleMeasure> measures = MesoMeasureTriangles(mesh);
  this->FindSites(measures, featureAngle);
  this->FindSitesOfPoints(measures);
  this->FindNeighbours(measures);
}

void MesoSmoothPatches::FindSites(
  const std::vector<MesoTriangleMeasure>& measures, double featureAngle)
{
  const MesoCornerNormals corners = MesoMakeCornerNormals(this->Mesh, measures, true, featureAngle);
  std::vector<std::int64_t> siteOfGroup(corners.Normals.size(), -1);
  this->SiteOfCorner.assign(this->Mesh.NumberOfCorners(), -1);
  for (std::int64_t c = 0; c < this->Mesh.NumberOfCorners(); ++c)
  {
    if (!(measures[c / 3].Area > 0.))
    {
      continue;
    }
    const std::int64_t point = this->Mesh.PointOf(c);
    std::int64_t& site = siteOfGroup[corners.Group[c]];
    if (site < 0)
    {
      site = this->NumberOfSites();
      this->Points.push_back(point);
      this->Normals.push_back(corners.Normals[corners.Group[c]]);
    }
    this->SiteOfCorner[c] = site;
  }
}

void MesoSmoothPatches::FindSitesOfPoints(const std::vector<MesoTriangleMeasure>& measures)
{
  const std::size_t points = this->Mesh.Positions.size();
  this->SiteOfPoint.assign(points, -1);
  this->ShareOfPoint.assign(points, 0.);
  // All sites are kept only of points that have several.
  std::vector<double> total(points, 0.);
  std::map<std::pair<std::int64_t, std::int64_t>, double> angles;
  std::vector<bool> several(points, false);
  for (const bool collect : { false, true })
  {
    for (std::int64_t c = 0; c < this->Mesh.NumberOfCorners(); ++c)
    {
      const std::int64_t point = this->Mesh.PointOf(c);
      const std::int64_t site = this->SiteOfCorner[c];
      if (site >= 0 && !collect)
      {
        std::int64_t& known = this->SiteOfPoint[point];
        several[point] = several[point] || (known >= 0 && known != site);
        known = site;
        total[point] += measures[c / 3].Angles[c % 3];
        this->ShareOfPoint[point] = 1.;
      }
      else if (site >= 0 && several[point])
      {
        this->SiteOfPoint[point] = -1;
        this->ShareOfPoint[point] = 0.;
        angles[{ point, site }] += measures[c / 3].Angles[c % 3];
      }
    }
  }
  for (const auto& item : angles)
  {
    const auto& [point, site] = item.first;
    if (item.second > LeastShare * total[point])
    {
      this->SiteOfPoint[point] = site;
      this->ShareOfPoint[point] = item.second / total[point];
    }
  }
}

void MesoSmoothPatches::FindNeighbours(const std::vector<MesoTriangleMeasure>& measures)
{
  // Each edge is noted from both of its triangles, and the second note is taken out afterwards.
  this->Start.assign(this->NumberOfSites() + 1, 0);
  const auto forEachPair = [&](auto&& visit)
  {
    for (std::int64_t c = 0; c < this->Mesh.NumberOfCorners(); ++c)
    {
      if (measures[c / 3].Area > 0.)
      {
        const std::int64_t a = this->SiteOfCorner[c];
        const std::int64_t b = this->SiteOfCorner[MesoTriangleMesh::Next(c)];
        visit(a, b);
        visit(b, a);
      }
    }
  };
  forEachPair([&](std::int64_t a, std::int64_t) { ++this->Start[a + 1]; });
  for (std::size_t i = 1; i < this->Start.size(); ++i)
  {
    this->Start[i] += this->Start[i - 1];
  }
  std::vector<std::int64_t> all(this->Start.back());
  std::vector<std::int64_t> next(this->Start.begin(), this->Start.end() - 1);
  forEachPair([&](std::int64_t a, std::int64_t b) { all[next[a]++] = b; });
  for (std::int64_t site = 0; site < this->NumberOfSites(); ++site)
  {
    const auto first = all.begin() + this->Start[site];
    const auto last = all.begin() + this->Start[site + 1];
    std::sort(first, last);
    this->Start[site] = static_cast<std::int64_t>(this->Neighbours.size());
    std::unique_copy(first, last, std::back_inserter(this->Neighbours));
  }
  this->Start.back() = static_cast<std::int64_t>(this->Neighbours.size());
}

void MesoSmoothPatches::Begin(std::int64_t site, Walk& walk) const
{
  if (walk.Seen.size() != this->Normals.size() ||
    walk.Number == std::numeric_limits<std::int32_t>::max())
  {
    walk.Seen.assign(this->Normals.size(), 0);
    walk.Number = 0;
  }
  ++walk.Number;
  walk.Seen[site] = walk.Number;
  walk.Centre = site;
  walk.Sites.clear();
  walk.RingEnds.clear();
}

bool MesoSmoothPatches::AddRing(Walk& walk) const
{
  const std::size_t rings = walk.RingEnds.size();
  const std::size_t last = walk.Sites.size();
  const auto visit = [&](std::int64_t from)
  {
    const std::int64_t size = this->Start[from + 1] - this->Start[from];
    const std::int64_t taken = std::min(size, MostNeighbours);
    for (std::int64_t i = 0; i < taken; ++i)
    {
      const std::int64_t site = this->Neighbours[this->Start[from] + i * size / taken];
      if (walk.Seen[site] != walk.Number)
      {
        walk.Seen[site] = walk.Number;
        walk.Sites.push_back(site);
      }
    }
  };
  if (rings == 0)
  {
    visit(walk.Centre);
  }
  for (std::size_t i = rings < 2 ? 0 : walk.RingEnds[rings - 2]; rings > 0 && i < last; ++i)
  {
    visit(walk.Sites[i]);
  }
  const std::size_t added = walk.Sites.size() - last;
  if (added > MostInRing)
  {
    for (std::size_t i = 0; i < MostInRing; ++i)
    {
      walk.Sites[last + i] = walk.Sites[last + i * added / MostInRing];
    }
    walk.Sites.resize(last + MostInRing);
  }
  walk.RingEnds.push_back(walk.Sites.size());
  return added > 0;
}

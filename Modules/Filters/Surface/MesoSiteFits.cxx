#include "MesoSiteFits.h"

namespace
{
constexpr std::size_t MostRings = 5;
constexpr double LeastNormalCosine = 0.17; // 80 degrees
}

void MesoGatherNeighbours(const MesoSmoothPatches& patches, std::int64_t site, std::size_t rings,
  std::size_t enough, std::size_t mostRings, MesoFitSpace& space)
{
  MesoSmoothPatches::Walk& walk = space.Walk;
  patches.Begin(site, walk);
  space.Offsets.clear();
  const MesoVector& centre = patches.PositionOf(site);
  const MesoVector& normal = patches.NormalOf(site);
  std::size_t next = 0;
  for (std::size_t ring = 0; ring < mostRings; ++ring)
  {
    if (ring >= rings && space.Offsets.size() >= enough)
    {
      break;
    }
    if (!patches.AddRing(walk))
    {
      break;
    }
    for (; next < walk.Sites.size(); ++next)
    {
      const std::int64_t neighbour = walk.Sites[next];
      if (MesoDot(patches.NormalOf(neighbour), normal) > LeastNormalCosine)
      {
        space.Offsets.push_back(MesoDifference(patches.PositionOf(neighbour), centre));
      }
    }
  }
}

MesoPrincipalCurvature MesoFitSiteCurvature(
  const MesoSmoothPatches& patches, std::int64_t site, MesoFitSpace& space)
{
  const MesoVector& normal = patches.NormalOf(site);
  MesoGatherNeighbours(patches, site, 2, MesoQuarticNeighbours, MostRings, space);
  MesoPrincipalCurvature result = MesoFitJet(space.Offsets, normal, 4, 4);
  if (result.Degree == 0)
  {
    const std::size_t rings = space.Walk.RingEnds.size() + 1;
    MesoGatherNeighbours(patches, site, rings, 0, rings, space);
    result = MesoFitJet(space.Offsets, normal);
  }
  return result;
}

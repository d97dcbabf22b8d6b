#ifndef MesoPatchSolver_h
#define MesoPatchSolver_h

/**
 * @class MesoPatchSolver
 * @brief The first hit of a ray with a displaced patch, in double precision, none missed.
 *
 * The surface is q(x, y) = P + (h - r) D N over a patch's domain, with h bilinear in each cell of
 * a height map. Blocks of cells come from the map's pyramid, nearest first: on a block, Taylor's
 * expansion in x, y and h encloses q in a parallelepiped of three half edges and a ball, and where
 * the ray misses that, the block holds no hit. Cells are left to MesoCellSolver.
 */

#include "MesoCellSolver.h"

class MESORENDERINGREFERENCE_EXPORT MesoPatchSolver
{
public:
  /// A ray o + t d in object space, d of any length but 0, t in (tMin, tMax).
  MesoPatchSolver(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax);

  /// The nearest hit with sides that face as told, before tMax; tMax then is where it lies. With
  /// `any`, some hit. False where there is none.
  bool FirstHit(const MesoBasePatch& patch, const MesoDisplacement& displacement, MesoFacing facing,
    bool any, MesoPatchHit& hit);

  void SetTMax(double tMax) { this->Cells.SetTMax(tMax); }
  const MesoSolverWork& Work() const { return this->Cells.Work; }

private:
  /// A block that may hold a hit, and where the ray comes to it at the earliest.
  struct Block
  {
    int Level;
    int I;
    int J;
    double TLow;
  };

  void VisitTiles(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1);
  void VisitTile(std::int64_t tileX, std::int64_t tileY);
  void VisitBlock(std::int64_t tileX, std::int64_t tileY, const Block& block);
  bool BlockReached(std::int64_t tileX, std::int64_t tileY, Block& block);
  /// Whether the ray may meet the surface over a rectangle with heights in a range.
  bool Reaches(const MesoRect& rect, double low, double high, double& tLow);
  void SolveCell(std::int64_t tileX, std::int64_t tileY, int i, int j);
  /// The part of a block that lies in the domain.
  MesoRect RectOf(std::int64_t tileX, std::int64_t tileY, int level, int i, int j) const;

  MesoCellSolver Cells;
  const MesoBasePatch* Patch = nullptr;
  MesoDisplacement Over;
};

#endif

#ifndef MesoPatchSolver_h
#define MesoPatchSolver_h

/**
 * @class MesoPatchSolver
 * @brief The first hit of a ray with a displaced patch, in double precision, none missed.
 *
 * The surface is q(x, y) = P + (h - r) D N over a patch's domain, with h bilinear in each cell of
 * a height map (MesoHeightPyramid). A hit is a root of the two components of q - o across the
 * ray's direction d.
 *
 * 1. Blocks of cells, from the map's pyramid, nearest first. On a block, Taylor's expansion in x, y
 *    and h encloses q in a parallelepiped of three half edges and a ball; where the ray's
 *    shadow along d misses that, by a separating axis, the block holds no hit.
 * 2. Cells, halved until the same enclosure (now with two half edges and h itself expanded)
 *    either excludes the piece, shows it to be turned away, or shows the map (x, y) -> f to be
 *    one-to-one on it: its Jacobian varies by less than its least singular value. There, Newton's
 *    method finds the only root there can be.
 *
 * Enclosures are widened by rounding, and neighbouring pieces overlap by 1e-11 of a cell, so that
 * no root falls between two. A piece that stays undecided through 60 halvings and is a point as the
 * ray sees it touches the ray to within rounding, tangentially or at a pole of its chart: it is a hit
 * where N says that it faces the right way. A cell that needs more than EvaluationLimit pieces (a
 * sheet seen edge-on) is given up and counted as unresolved.
 *
 * Moore, Kearfott, Cloud, "Introduction to Interval Analysis", SIAM 2009, chapters 6 and 8 (mean
 * value forms, uniqueness of roots); the separating axes are those of a zonotope's shadow.
 */

#include "MesoBasePatch.h"
#include "MesoHeightPyramid.h"

#include <cstdint>

/// How much there was to do.
struct MesoSolverWork
{
  std::uint64_t Blocks = 0;     ///< enclosures of blocks of cells
  std::uint64_t Pieces = 0;     ///< enclosures of cells and their pieces
  std::uint64_t Unresolved = 0; ///< cells given up
  double LargestResidual = 0.;  ///< of accepted hits: |q - ray| / size of what was added up
};

/// What is laid over a patch.
struct MesoDisplacement
{
  const MesoHeightPyramid* Map = nullptr; ///< null: Height everywhere
  double Height = 1.;
  double Scale = 0.;     ///< D, object units
  double Reference = 1.; ///< r, the height that lies on the base
};

struct MesoPatchHit
{
  double T;
  double X;
  double Y;
  bool Front; ///< seen from the side that is the front by the patch's own winding
};

class MESORENDERINGREFERENCE_EXPORT MesoPatchSolver
{
public:
  enum class Facing
  {
    Front,
    Back,
    Both
  };

  /// Pieces of one cell, at most.
  static constexpr int EvaluationLimit = 20000;

  /// A ray o + t d in object space, d of any length but 0, t in (tMin, tMax).
  MesoPatchSolver(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax);

  /// The nearest hit with sides that face as told, before tMax; tMax then is where it lies. With
  /// `any`, some hit. False where there is none.
  bool FirstHit(const MesoBasePatch& patch, const MesoDisplacement& displacement, Facing facing,
    bool any, MesoPatchHit& hit);

  void SetTMax(double tMax) { this->TMax = tMax; }
  const MesoSolverWork& Work() const { return this->Done; }

private:
  /// A middle, up to three half edges, and a ball around all.
  struct Enclosure
  {
    glm::dvec3 Middle;
    glm::dvec3 Edges[3];
    int NumberOfEdges;
    double Ball;
  };
  /// A cell's height as a bilinear function.
  struct Cell
  {
    double X0;
    double Y0;
    double H00;
    double HX;
    double HY;
    double HXY;
  };
  /// A block that may hold a hit, and where the ray comes to it at the earliest.
  struct Block
  {
    int Level;
    int I;
    int J;
    double TLow;
  };

  /// A piece of a cell, expanded about its middle to first order.
  struct Expansion
  {
    Enclosure Around;
    glm::dvec3 Normal; ///< N
    double ChangeX;    ///< by how much the first edge's derivative changes on the piece, at most
    double ChangeY;    ///< the second's
    bool Wild;         ///< nothing is known of derivatives
  };

  void VisitTiles(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1);
  void VisitTile(std::int64_t tileX, std::int64_t tileY);
  void VisitBlock(std::int64_t tileX, std::int64_t tileY, const Block& block);
  bool BlockReached(std::int64_t tileX, std::int64_t tileY, Block& block);
  MesoRect RectOf(std::int64_t tileX, std::int64_t tileY, int level, int i, int j) const;
  void SolveCell(std::int64_t tileX, std::int64_t tileY, int i, int j);
  Expansion Expand(const Cell& cell, const MesoRect& rect) const;
  void SolvePiece(const Cell& cell, const MesoRect& rect, int depth);
  /// Take a piece that cannot be decided as a hit where it is a point to the ray.
  void TakePinched(const Expansion& piece, const MesoRect& rect);
  bool Reaches(const MesoRect& rect, double low, double high, double& tLow);
  bool Touches(const Enclosure& enclosure, double& tLow) const;
  bool Newton(const Cell& cell, const MesoRect& rect);
  bool Finished() const { return this->Any && this->Found; }

  /// Height above the reference times D, and its derivatives.
  struct Offset
  {
    double G;
    double Gx;
    double Gy;
    double Gxy;
  };
  Offset OffsetAt(const Cell& cell, double x, double y) const;
  double Rounding(const glm::dvec3& middle) const;
  glm::dvec2 Across(const glm::dvec3& v) const
  {
    return { glm::dot(this->Axis0, v), glm::dot(this->Axis1, v) };
  }

  glm::dvec3 Origin;
  glm::dvec3 Direction;
  glm::dvec3 Axis0; ///< with Axis1 and the direction right-handed and orthonormal
  glm::dvec3 Axis1;
  double PerSquare;   ///< 1 / |d|^2
  double LargestPart; ///< of the origin
  double TMin;
  double TMax;

  const MesoBasePatch* Patch = nullptr;
  MesoDisplacement Over;
  double Wanted = 1.; ///< sign of the Jacobian of sides that count; 0: both
  bool Any = false;
  bool Found = false;
  MesoPatchHit Best = { 0., 0., 0., true };
  int Budget = 0;
  MesoSolverWork Done;
};

#endif

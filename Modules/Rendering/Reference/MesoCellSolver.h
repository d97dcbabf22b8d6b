#ifndef MesoCellSolver_h
#define MesoCellSolver_h

/**
 * @class MesoCellSolver
 * @brief The first hit of a ray with a displaced patch in one cell, in double precision.
 *
 * On a cell of a height map, h is bilinear, and q(x, y) = P + (h - r) D N is smooth. A hit is a root
 * of the two components f of q - o across the ray's direction d. Taylor's expansion about the middle
 * of a piece of the cell encloses q in a parallelogram and a ball for all that is of second order.
 * The cell is halved until a piece
 *
 * - is missed: an axis separates the shadows of enclosure and ray along d;
 * - is turned away: the sign of the Jacobian's determinant is certain; or
 * - holds one root at most: the Jacobian varies by less than its least singular value. There,
 *   Newton's method finds it.
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

/// A cell's height, a polynomial: the sum of H[j][i] a^i b^j for a = x - X0, b = y - Y0.
struct MesoHeightCell
{
  double X0;
  double Y0;
  double H[4][4];
  int Degree;    ///< along x, and along y: 1 bilinear, 3 bicubic
  double MostXX; ///< of the size of the second derivatives on the cell
  double MostXY;
  double MostYY;
};

struct MesoPatchHit
{
  double T;
  double X;
  double Y;
  bool Front; ///< seen from the side that is the front by the patch's own winding
};

/// The sides that count as hits.
enum class MesoFacing
{
  Front,
  Back,
  Both
};

class MESORENDERINGREFERENCE_EXPORT MesoCellSolver
{
public:
  /// Pieces of one cell, at most.
  static constexpr int EvaluationLimit = 20000;

  /// A middle, up to three half edges, and a ball around all.
  struct Enclosure
  {
    glm::dvec3 Middle;
    glm::dvec3 Edges[3];
    int NumberOfEdges;
    double Ball;
  };

  /// A ray o + t d in object space, d of any length but 0, t in (tMin, tMax).
  MesoCellSolver(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax);

  /// Turn to a patch; nothing is found there as yet. With `any`, the first hit found ends it.
  void Begin(
    const MesoBasePatch& patch, const MesoDisplacement& displacement, MesoFacing facing, bool any);

  /// Look for a hit in a part of a cell that comes before tMax, which then is where it lies.
  void Solve(const MesoHeightCell& cell, const MesoRect& rect);

  /// Whether the ray may meet an enclosure before tMax, and where it comes to it at the earliest.
  bool Touches(const Enclosure& enclosure, double& tLow) const;

  bool Found() const { return this->IsFound; }
  const MesoPatchHit& Hit() const { return this->Best; }
  /// Whether nothing more is asked for.
  bool Finished() const { return this->Any && this->IsFound; }
  double GetTMax() const { return this->TMax; }
  void SetTMax(double tMax) { this->TMax = tMax; }
  MesoSolverWork Work;

private:
  /// A piece of a cell, expanded about its middle to first order.
  struct Expansion
  {
    Enclosure Around;
    glm::dvec3 Normal; ///< N
    double ChangeX;    ///< by how much the first edge's derivative changes on the piece, at most
    double ChangeY;    ///< the second's
    bool Wild;         ///< nothing is known of derivatives
  };
  /// Height above the reference times D, and its derivatives.
  struct Offset
  {
    double G;
    double Gx;
    double Gy;
    double Gxx; ///< of these three the sizes, at most
    double Gxy;
    double Gyy;
  };

  Offset OffsetAt(const MesoHeightCell& cell, double x, double y) const;
  Expansion Expand(const MesoHeightCell& cell, const MesoRect& rect) const;
  void SolvePiece(const MesoHeightCell& cell, const MesoRect& rect, int depth);
  /// Find the only root of a piece; false where that does not succeed.
  bool Newton(const MesoHeightCell& cell, const MesoRect& rect);
  /// Take a piece that cannot be decided as a hit where it is a point to the ray.
  void TakePinched(const Expansion& piece, const MesoRect& rect);
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
  bool IsFound = false;
  MesoPatchHit Best = { 0., 0., 0., true };
  int Budget = 0;
};

#endif

#ifndef MesoVDMRays_h
#define MesoVDMRays_h

#include "MesoHeightLine.h"
#include "MesoVDMTable.h"

#include <vector>

/**
 * @class MesoVDMRays
 * @brief All rays of a table in one azimuth: where they meet the relief along a line over the map.
 *
 * The plane of ray and normal is bent about the centre of curvature (Shaders/Kernels/VDMTable.glsl). A ray
 * meets the bilinear relief where a point of it is first seen from the entry at no steeper an angle. A
 * flatter ray stays above a steeper one, so it meets the relief no nearer, and all polar angles are served by
 * one walk. Meetings are roots of parabolas between cuts: exact where the base is flat; where a texel spans
 * so large an angle at the centre that a parabola is not, they are polished.
 */
class MesoVDMRays
{
public:
  MesoVDMRays(const MesoVDMLayout& layout, MesoVDMCurved curved, double azimuth);

  /**
   * The numbers of a row of the table (MesoVDMNumbers) at a texel.
   *
   * @param profile of GetLine() over depths in tiles, a thread's own
   */
  void Trace(MesoHeightLine::Profile& profile, int column, int row, float* numbers) const;

  const MesoHeightLine& GetLine() const { return this->Line; }

private:
  struct Point
  {
    double Offset;
    double Depth;
  };
  struct Ray
  {
    double Sine;
    double Cosine;
    double Cotangent;
    double End;    ///< offset at which it is at the bottom, or comes out of the base
    bool ComesOut; ///< it comes out before it gets to the bottom
  };
  /// Rays of one curvature.
  struct Fan
  {
    double Curvature;
    std::vector<Ray> Rays;
    /// Of the angle psi at the centre, at the cuts and in the middle between, alternating.
    struct Arc
    {
      double Versine; ///< (1 - cos psi) / c
      double Cosine;
      double Sine; ///< sin psi / c
    };
    std::vector<Arc> Arcs;

    /// How far a point lies above a ray of this cotangent, seen along the entry's normal: continuous, and 0
    /// on the ray, wherever the ray goes.
    double Above(const Arc& arc, double depth, double cotangent) const
    {
      return arc.Versine + depth * arc.Cosine -
        cotangent * (1. - this->Curvature * depth) * arc.Sine;
    }
  };

  static double ReachOf(const MesoVDMLayout& layout);
  static Fan::Arc ArcOf(double curvature, double offset);
  static Ray MakeRay(const MesoVDMLayout& layout, double curvature, int polar);
  Fan MakeFan(double curvature) const;

  /// Where the rays of a fan meet the relief: the first of them, the steepest, do.
  std::vector<Point> Meet(MesoHeightLine::Profile& profile, const Fan& fan) const;
  /// Between a cut and the next, for how far the relief lies above the ray at both.
  bool MeetBetween(const MesoHeightLine::Profile& profile, const Fan& fan, const Ray& ray,
    std::size_t cut, double before, double after, Point& point) const;
  /// The point that is seen most flatly; result: cotangent of its polar angle.
  double Flattest(MesoHeightLine::Profile& profile, const Fan& fan, Point& point) const;
  /// Numbers of the first of a fan's rays, by the appendix from the points of curvature 0.
  std::vector<double> Bend(
    const std::vector<Point>& flat, const Fan& fan, double surfaceDepth) const;
  double NumberOf(double curvature, double sine, double cosine, const Point& point) const;

  MesoVDMLayout Layout;
  double Range;
  MesoHeightLine Line;
  std::vector<Fan> Fans; ///< one a curvature
  std::vector<Fan> Flat; ///< of curvature 0, from which others are bent; none where they are exact
};

#endif

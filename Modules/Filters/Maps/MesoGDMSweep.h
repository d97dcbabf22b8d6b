#ifndef MesoGDMSweep_h
#define MesoGDMSweep_h

#include "MesoVolumeRay.h"

/// The directions of a generalized displacement map: unit vectors in (x, y, F z).
struct MESOFILTERSMAPS_EXPORT MesoGDMDirections
{
  int Azimuths = 16; ///< phi = 2 pi a / Azimuths, from +x towards +y; at least 1
  int Polars = 32;   ///< from theta = 0 (+z) to pi, both included; at least 2
  /// Evenly over the sphere: equal steps of cos(theta), not of theta.
  bool Even = false;

  MesoVolumeField::Vector At(int azimuth, int polar) const;
};

/**
 * @class MesoGDMSweep
 * @brief How far the solid is from each point of a volume, in one direction at a time.
 *
 * A direction's rays are a lattice of parallel lines through the tile, one for each sample of the planes that
 * they cross: those of the axis along which they cross most, in samples. Each line is swept once, from its far end,
 * with the distance to what was met last; so a direction costs a constant time a sample, however far
 * rays go. Lines that run level go on through the next tiles, as far as `reach`. A point takes the mean of the
 * four lines around it; where these do not agree (one meets the solid and another passes, or they meet it
 * far from each other), its own ray is followed (MesoVolumeRay).
 *
 * Points lie at ((i + 0.5) / W, (j + 0.5) / H, k / (D - 1)): where the samples of the volume do in x and
 * y, on the planes z = 0 and z = 1 and evenly between them in z.
 *
 * Source: Wang2004, section 3.1; distances to the planes of section 4.1.
 */
class MESOFILTERSMAPS_EXPORT MesoGDMSweep
{
public:
  /// `reach`: the largest distance of the table, tile widths.
  MesoGDMSweep(const MesoVolumeField& field, double reach);

  /**
   * Distances along a direction, tile widths: to the solid; 0 where the point is in it; where the ray leaves
   * the shell before, to the plane that it leaves through; at most `reach`.
   *
   * @param distances of point (i, j, k) at (j W + i) stride + k
   * @return points whose own ray was followed
   */
  std::size_t Sweep(
    const MesoVolumeField::Vector& direction, float* distances, std::size_t stride) const;

  /// The same by following every point's own ray.
  void Cast(const MesoVolumeField::Vector& direction, float* distances, std::size_t stride) const;

private:
  class Lines;
  using Vector = MesoVolumeField::Vector;

  Vector PointAt(int i, int j, int k) const;
  float CastFrom(int i, int j, int k, const Vector& direction) const;

  const MesoVolumeField& Field;
  MesoVolumeRay Ray;
  double Reach;
  std::vector<float> Nodes; ///< the field at the points
};

#endif

#ifndef MesoFrames_h
#define MesoFrames_h

/**
 * @file MesoFrames.h
 * @brief Makes the tangent frame of a textured triangle mesh at each of its points.
 *
 * In a triangle with edges e1, e2 in space and (du1, dv1), (du2, dv2) in the texture, positions are
 * an affine function of the texture coordinates, with (Mikkelsen 2008, section 2.1)
 *
 *     det   = du1 dv2 - du2 dv1
 *     dp/du = (dv2 e1 - dv1 e2) / det        dp/dv = (du1 e2 - du2 e1) / det
 *
 * A point's dp/du and dp/dv are the means over the triangles around its merged vertex that belong
 * to its chart, weighted with their angles there and projected into the plane at right angles to
 * the normal n. Tangent and bitangent are their directions, not made orthogonal; Scale is their
 * lengths, in object units per unit of texture coordinate.
 *
 * A **chart** runs on across an edge, at each end of it, where the two triangles have
 * - the same texture coordinates at both ends; or coordinates that differ at both ends by the same
 *   shift, and derivatives that differ by less than half their length: the seam of a closed chart,
 *   at which dp/du and dp/dv run on;
 * - the same normal and the same handedness, the sign of (dp/du x dp/dv) . n, at that end.
 *
 * Equal texture coordinates alone do not make a chart: the faces of a cube may meet with (0, 0) in
 * one corner. A point in which several charts meet, or a chart and its mirror image, is split, for
 * their frames would cancel.
 *
 * Only differences of positions enter, so that a model far from the origin has the frames of the
 * same model at the origin, and frames scale with the model.
 *
 * - **Without area**, in space or in the texture (to within the rounding of the coordinates as they
 *   were stored), a triangle contributes nothing.
 * - **No frame** is where no triangle contributes, where directions cancel to less than 1/16 of
 *   their mean length (the centre of a polar chart with one texture coordinate), or where the sine
 *   between tangent and bitangent is below 1e-6. Valid is 0 there, tangent and bitangent are
 *   orthonormal around n, right-handed, and both scales are sqrt(area in space / area in the
 *   texture) of the whole mesh: a length of the mesh's own size, so that what divides by it stays
 *   small. It is 1 where the mesh has no frame at all.
 */

#include "MesoCornerNormals.h"
#include "mesoFiltersSurfaceModule.h" // for export macro

struct MesoFramesInput
{
  MesoTriangleMesh Mesh;
  std::vector<std::array<double, 2>> TextureCoordinates; ///< a point each, finite
  /// Rounding of the stored texture coordinates, relative to their size: 2^-24 for floats.
  double TextureRounding = 0.;
  /// A point each, or empty. Normals (of any length) are made where they are missing or 0.
  std::vector<MesoVector> Normals;
  /// Whether made normals are split at edges bent by more than FeatureAngle degrees.
  bool SplitNormals = false;
  double FeatureAngle = 30.;
};

/// `m` points: those of the input in their order, then the copies that splitting made.
struct MesoFrames
{
  std::vector<std::int64_t> Source; ///< m: the point of the input it has everything else from
  std::vector<std::array<std::int64_t, 3>> Triangles; ///< as in the input, with the points' copies
  std::vector<MesoVector> Normals;                    ///< m, unit
  std::vector<MesoVector> Tangents;                   ///< m, unit
  std::vector<MesoVector> Bitangents;                 ///< m, unit
  std::vector<std::array<double, 2>> Scales;          ///< m: |dp/du|, |dp/dv|
  std::vector<bool> Valid;                            ///< m
};

/// In linear time, with the same result in every run.
MESOFILTERSSURFACE_EXPORT MesoFrames MesoMakeFrames(const MesoFramesInput& input);

#endif

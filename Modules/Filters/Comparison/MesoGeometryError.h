#ifndef MesoGeometryError_h
#define MesoGeometryError_h

/**
 * @file MesoGeometryError.h
 * @brief Figures of error between what the pixels of two renderings know.
 *
 * A pixel is covered where `coverage` is at least 0.5. Pixels that the truth covers while its channel
 * `base` is below 0.5 are the class `boundary`: there the displaced sheet is seen beside its base, past
 * an open edge. They are counted and enter no other figure; both renderings count as not covering
 * them. Pixels of the test that hold NaN or Inf are counted, and enter no figure of depth, texture
 * coordinate, normal or shadow.
 */

#include "MesoAOVs.h"
#include "MesoErrorSpread.h"

/// What became of a pixel, the first that applies.
enum class MesoPixelClass : unsigned char
{
  Empty,         ///< neither covers it
  NotANumber,    ///< the test holds NaN or Inf
  Boundary,      ///< the truth is seen beside its base
  Hole,          ///< missing, away from the truth's outline
  Missing,       ///< the truth alone covers it
  Extra,         ///< the test alone covers it
  OtherObject,   ///< both cover it by different objects
  Nearer,        ///< the test is nearer by more than 1 % of D (where D = 0, of the depth)
  Farther,       ///< likewise farther
  ShadowDiffers, ///< the state of a light's shadow differs
  Equal
};

/// Errors of depth and texture coordinate of one object.
struct MesoObjectError
{
  int Number = 0;
  std::string Name;
  bool DepthInScale = false; ///< depth errors are fractions of D, else world units
  MesoErrorSpread Depth;
  MesoErrorSpread Texcoord;
};

/// Figures that the channels do not give, and means over no pixels, are not a number.
struct MesoGeometryError
{
  static constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

  /// Pixels that both cover over pixels that either covers; 1 where neither covers any.
  double CoverageIou = NotKnown;
  ///@{
  /// Distance between the outlines of the coverages, pixels: MesoOutline::Between().
  double SilhouetteMean = NotKnown;
  double SilhouetteMaximum = NotKnown;
  ///@}

  /// Difference of depth where both cover, as a fraction of the object's D. The objects without
  /// relief are left out unless there are no others; then it is in world units.
  MesoErrorSpread Depth;
  bool DepthInScale = false; ///< Depth is a fraction of D
  /// Distance of texture coordinates, each taken modulo one tile, in texels of the truth's map,
  /// where both cover by one object that has a map.
  MesoErrorSpread Texcoord;
  /// Angle between normals, degrees, where both cover and the truth has one; 180 where the test has
  /// none.
  MesoErrorSpread Normal;

  ///@{
  /// Part of the pixels, over all lights, whose state of shadow (threshold 0.5) differs: where the
  /// truth's normal faces away from the light, and elsewhere. 0 where there are no such pixels. Not
  /// known without attributes of lights and camera. The normal is the shading normal of the truth.
  double ShadowAttached = NotKnown;
  double ShadowCast = NotKnown;
  ///@}

  std::size_t NanPixels = 0;      ///< NaN or Inf in any channel of the test
  std::size_t VoidPixels = 0;     ///< only the truth covers them
  std::size_t ExtraPixels = 0;    ///< only the test covers them
  std::size_t HolePixels = 0;     ///< void, in 8-connected parts with none within 2 pixels of the
                                  ///< truth's outline
  std::size_t BoundaryPixels = 0; ///< of the class `boundary`
  std::size_t BothPixels = 0;     ///< both cover them
  std::size_t OtherObjectPixels = 0; ///< both cover them, by different objects

  std::vector<MesoObjectError> Objects; ///< by number, those that the truth shows
  std::vector<MesoPixelClass> Classes;  ///< of every pixel, row 0 = top
  std::vector<bool> Counts; ///< pixels that either covers and that are not of class `boundary`
};

/// Compare two renderings that MesoCheckComparable() lets pass.
MESOFILTERSCOMPARISON_EXPORT MesoGeometryError MesoCompareGeometry(
  const MesoAOVs& truth, const MesoAOVs& test);

#endif

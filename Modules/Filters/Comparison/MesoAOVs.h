#ifndef MesoAOVs_h
#define MesoAOVs_h

/**
 * @file MesoAOVs.h
 * @brief What each pixel of a rendering knows (AOVs), taken from an image of named channels.
 *
 * Channels and attributes are those of `meso render --aov all` (Documentation/AccuracyAndCost.md).
 */

#include "MesoExr.h"
#include "mesoFiltersComparisonModule.h" // for export macro

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// An object, from the attributes `meso.<number>.*`.
struct MesoAOVObject
{
  std::string Name;
  double Scale = 0.; ///< D in world units; 0 where the object has no relief
  int MapWidth = 0;  ///< texels; 0 where the object has no map
  int MapHeight = 0;
};

/// A light, from the attributes `meso.light.<k>.*`; k counts as the channels `shadow.<k>` do.
struct MesoAOVLight
{
  bool Positional = false;
  std::array<double, 3> Place = { 0., 0., 1. }; ///< position, or unit direction towards the light
};

/// Which point of the world a pixel shows, from the attributes `meso.camera.*`.
struct MesoAOVCamera
{
  std::array<double, 3> Position = { 0., 0., 0. };
  std::array<double, 3> Forward = { 0., 0., -1. }; ///< unit
  /// From the middle of the picture to that of its right and upper side: at the distance 1 from the
  /// camera, or at every distance where the projection is parallel.
  std::array<double, 3> Right = { 1., 0., 0. };
  std::array<double, 3> Up = { 0., 1., 0. };
  bool Parallel = false;
};

/// Channels that a file lacks are empty; all others have Width * Height values, row 0 = top.
struct MESOFILTERSCOMPARISON_EXPORT MesoAOVs
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Coverage;
  std::vector<float> Depth;
  std::array<std::vector<float>, 2> Texcoord;
  std::array<std::vector<float>, 3> Normal;
  std::vector<float> Object;
  std::vector<std::vector<float>> Shadows;
  /// 1 where the pixel's ray meets a front face of the base mesh at or before the hit. Only a truth
  /// has it.
  std::vector<float> Base;
  std::vector<bool> NotANumber; ///< pixels with NaN or Inf in any channel of the file

  std::map<int, MesoAOVObject> Objects; ///< by number
  std::vector<MesoAOVLight> Lights;     ///< as many as Shadows, or none where they are not known
  std::optional<MesoAOVCamera> Camera;

  std::size_t NumberOfPixels() const { return std::size_t(this->Width) * this->Height; }
  /// The point of the world that a pixel shows; needs Depth and Camera.
  std::array<double, 3> PointAt(std::size_t pixel) const;
};

/// Take the channels and attributes of an image. Throws MesoInputError where it has no `coverage`,
/// only a part of `texcoord` or `normal`, or an attribute of the wrong kind.
MESOFILTERSCOMPARISON_EXPORT MesoAOVs MesoAOVsOfImage(const MesoExrImage& image);

/// Throws MesoInputError, by a line that uses the names, where the two differ in size, channels or
/// number of objects, or where the truth itself has pixels that are no numbers.
MESOFILTERSCOMPARISON_EXPORT void MesoCheckComparable(const MesoAOVs& truth,
  const std::string& truthName, const MesoAOVs& test, const std::string& testName);

#endif

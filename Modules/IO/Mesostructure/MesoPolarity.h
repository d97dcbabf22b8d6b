#ifndef MesoPolarity_h
#define MesoPolarity_h

/**
 * @file MesoPolarity.h
 * @brief Tells by a normal map whether a map is of heights or of depths.
 *
 * Where a surface h(u, v) rises with u its normal leans towards -u: its x is -h_u times something
 * positive, its y -h_v. So over all texels the normal map's x goes down with the map's step in u
 * where brighter is higher, and up with it where brighter is deeper; y the same in v where the
 * normal map's y points up (OpenGL), and the other way round where it points down.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <string>

class vtkImageData;

struct MesoPolarity
{
  /// Correlation, from -1 to 1, of the map's steps in u with -x and in v with -y (y up) of the
  /// normals: about 1 where brighter is higher.
  double InU = 0.;
  double InV = 0.;

  enum class Reading
  {
    Height,
    Depth,
    Unknown
  };
  /// What both say, each by more than 0.15; in other cases it is not known. `isYUp` turns InV.
  Reading Says(bool isYUp) const;
  /// Whether y points down where the polarity is told by u; false where u says nothing.
  bool LooksYDown() const;
};

/**
 * Compares a map (first component) with a normal map of three components or more, in which the
 * middle of the type's range stands for 0 (8 and 16 bit; float holds [0, 1]). Sizes may differ.
 * Rows run from the bottom up in both. The border is not looked at.
 */
MESOIOMESOSTRUCTURE_EXPORT MesoPolarity MesoComparePolarity(
  vtkImageData* map, vtkImageData* normalMap);

/**
 * One line that says so where a normal map contradicts what a map is said to be, or whose y points
 * the other way; else an empty text.
 */
MESOIOMESOSTRUCTURE_EXPORT std::string MesoPolarityWarning(
  vtkImageData* map, vtkImageData* normalMap, bool isDepth, bool isYUp);

#endif

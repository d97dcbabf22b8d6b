#ifndef MesoContourLines_h
#define MesoContourLines_h

/**
 * @file MesoContourLines.h
 * @brief Which contour lines of a relief's height are drawn, and how.
 */

#include "mesoCommonCoreModule.h" // for export macro

#include <array>
#include <cstddef>
#include <string>
#include <vector>

/**
 * Lines of equal height on a relief, as wide on the screen everywhere. Heights are in [0,1]: 0 at the
 * deepest point, 1 at the base mesh.
 */
struct MESOCOMMONCORE_EXPORT MesoContourLines
{
  /// Most heights that can be given one by one; the shader holds no more.
  static constexpr std::size_t MostHeights = 32;
  /// Widest line, in pixels.
  static constexpr double MostWidth = 64.;
  /// Finest spacing: a float's height tells neighbouring lines apart a hundred times over.
  static constexpr double LeastSpacing = 1e-5;

  double Spacing = 0.; ///< lines at Offset and all multiples of this from it; 0: none
  double Offset = 0.;
  std::vector<double> Heights;                  ///< further lines, one by one
  std::array<double, 3> Color = { 0., 0., 0. }; ///< each in [0,1]; lines are not lit
  double Width = 1.5;                           ///< pixels

  bool Empty() const { return this->Spacing == 0. && this->Heights.empty(); }
  /// What is wrong with the numbers, in words; empty where nothing is.
  std::string Problem() const;
};

#endif

#ifndef MesoImageReport_h
#define MesoImageReport_h

/**
 * @file MesoImageReport.h
 * @brief Counts what is in an image: ranges, numbers that are none, and whether it tiles.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstddef>
#include <string>
#include <vector>

struct MesoChannelReport
{
  std::string Name;
  double Least = 0.; ///< of the finite values
  double Most = 0.;
  double Mean = 0.;
  std::size_t NotFinite = 0;
};

/**
 * How an image goes on over its border, of the first channel: the mean step from the last column
 * (or row) to the first, by the mean step between neighbours inside. 1 is an image that tiles.
 */
struct MesoTilingReport
{
  double AcrossBorder = 0.; ///< mean magnitude of the step, in stored numbers
  double Inside = 0.;
  /// AcrossBorder / Inside; 0 where no step is anywhere, infinite where all steps are at the border.
  double Ratio() const;
  /// "yes" up to 1.75, "nearly" up to 3.5, else "no".
  const char* Verdict() const;
};

struct MesoImageReport
{
  int Width = 0;
  int Height = 0;
  std::string Format;     ///< as in MesoImageHeader
  std::string StoredType; ///< as in MesoImageHeader
  std::vector<MesoChannelReport> Channels;
  std::array<MesoTilingReport, 2> Tiling; ///< over the border in u (columns), in v (rows)
  bool HasColorProfile = false;           ///< an ICC profile, which is left alone
  std::vector<std::string> Notes;
};

/// Reads an image file. Throws MesoInputError where it is none, or is damaged. Numbers that are not
/// finite are counted, not refused.
MESOIOMESOSTRUCTURE_EXPORT MesoImageReport MesoReportImage(const std::string& fileName);

#endif

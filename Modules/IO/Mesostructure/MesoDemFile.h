#ifndef MesoDemFile_h
#define MesoDemFile_h

/**
 * @file MesoDemFile.h
 * @brief Reads elevations of USGS digital elevation models (.dem), in metres.
 *
 * The form is that of USGS, Standards for Digital Elevation Models, 1998: a record A of 1024 bytes,
 * then a record B (or more, of 1024 bytes each) for each profile, which runs from south to north.
 * Elevations are their numbers times the record's resolution, feet brought to metres. Where the
 * ground is measured in arc-seconds or radians, distances are those on a sphere of 6371008.8 m at the
 * middle latitude. Places that no profile has, as along the slanted sides of a map sheet, and voids
 * get the lowest elevation and are counted in a note.
 *
 * VTK's own reader is not used: it believes counts and positions, and writes beyond its image where
 * a damaged file has others.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Bytes of a file, at most.
constexpr std::uintmax_t MesoLargestDemFile = std::uintmax_t(256) << 20;

struct MesoDem
{
  std::string Title;
  int Width = 0;                              ///< profiles, from west to east
  int Height = 0;                             ///< places of the longest column, from south to north
  std::vector<float> Elevations;              ///< metres, the southern row first
  std::array<double, 2> Spacing = { 1., 1. }; ///< metres between samples in x and y
  std::array<double, 2> Range = { 0., 0. };   ///< lowest and highest elevation
  std::vector<std::string> Notes;
};

/// Throws MesoInputError "file: byte N: reason".
MESOIOMESOSTRUCTURE_EXPORT MesoDem MesoParseDem(
  const std::string& bytes, const std::string& fileName);

#endif

#ifndef MesoColorMap_h
#define MesoColorMap_h

/**
 * @file MesoColorMap.h
 * @brief The colour maps that numbers are drawn with, by name, as published control points.
 *
 * - viridis: from dark blue to yellow, perceived as evenly spaced and read in grey as well. Every
 *   fifth of the 256 colours that Nathaniel Smith and Stefan van der Walt published in 2015
 *   (matplotlib, CC0); linear between them it keeps within 1/255 of theirs.
 * - coolwarm: blue, light grey in the middle, red: for numbers with a sign. Moreland2009, its two
 *   ends; between them Msh colours, as the paper has it and as vtkColorTransferFunction interpolates
 *   in its space `Diverging`.
 * - grey: black to white, linear.
 * - terrain: elevations, from the green of lowlands over sand and rock to snow; lighter throughout, so
 *   that it reads in grey as well. Our own.
 */

#include "mesoCommonCoreModule.h" // for export macro

#include <array>
#include <string>
#include <vector>

struct MesoColorMap
{
  std::string Name;
  bool Diverging = false; ///< interpolated in Msh around a neutral middle, else linear in RGB
  std::vector<std::array<double, 3>> Colors; ///< red, green, blue in [0,1], evenly spaced
};

/// viridis, coolwarm, grey, terrain.
MESOCOMMONCORE_EXPORT const std::vector<MesoColorMap>& MesoColorMaps();

MESOCOMMONCORE_EXPORT std::vector<std::string> MesoColorMapNames();

/// The map of that name. Throws std::out_of_range where there is none.
MESOCOMMONCORE_EXPORT const MesoColorMap& MesoColorMapNamed(const std::string& name);

#endif

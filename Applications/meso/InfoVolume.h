#ifndef InfoVolume_h
#define InfoVolume_h

#include <nlohmann/json.hpp>

#include <string>

struct MesoTilingReport;

/// How an image or a volume goes on over its border.
nlohmann::ordered_json JsonOfTiling(const MesoTilingReport& tiling);

/// Whether a file holds a volume: its name says so, it is a TIFF file of several images, or an image of
/// VTK's that is no baked table.
bool IsVolume(const std::string& fileName);

/// A volume's size, numbers and seams. Throws MesoInputError where it cannot be read.
nlohmann::ordered_json JsonOfVolume(const std::string& fileName);

#endif

#ifndef InfoPolarity_h
#define InfoPolarity_h

#include <nlohmann/json.hpp>

#include <string>

/**
 * What a normal map beside a map says of its polarity, or null where there is none: the file whose
 * name has "normal", "nor_gl" or the like where the map's has "height", "depth", "disp" or "bump".
 */
nlohmann::ordered_json JsonOfPolarity(const std::string& fileName);

#endif

#ifndef InfoScene_h
#define InfoScene_h

#include <nlohmann/json.hpp>

#include <string>

/**
 * A scene's nodes with what they draw, `missing` (each file that is not there, with its place) and,
 * where none is missing, `warnings` of building it. Throws MesoInputError where the scene cannot be
 * read, or not be built of its files.
 */
nlohmann::ordered_json JsonOfScene(const std::string& fileName);

#endif

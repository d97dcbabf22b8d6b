#ifndef InfoJson_h
#define InfoJson_h

#include <nlohmann/json.hpp>

#include <string>

/**
 * What a file holds, by the end of its name: a mesh, a scene (.json), a baked table (.vti), else an
 * image. `warnings` lists what is odd. Throws MesoInputError where it cannot be read.
 */
nlohmann::ordered_json JsonOfFile(const std::string& fileName);

#endif

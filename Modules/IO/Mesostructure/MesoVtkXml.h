#ifndef MesoVtkXml_h
#define MesoVtkXml_h

/**
 * @file MesoVtkXml.h
 * @brief Lets VTK's XML readers see only what they can take, and says what they say.
 */

#include <cstdint>
#include <string>

class vtkXMLReader;

/// No compression that VTK writes makes more of a byte (zlib's limit is 1032).
constexpr std::uintmax_t MesoXmlMostBytesOfOne = 1100;

/// Runs the reader on the bytes of a file. Throws MesoInputError "file: reason" where they are no VTK XML
/// file, or with the first error that any part of the reader gives; nothing goes to the screen.
void MesoReadVtkXml(vtkXMLReader* reader, const std::string& bytes, const std::string& fileName);

#endif

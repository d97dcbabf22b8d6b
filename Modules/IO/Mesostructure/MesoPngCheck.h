#ifndef MesoPngCheck_h
#define MesoPngCheck_h

/**
 * @file MesoPngCheck.h
 * @brief Looks a PNG file's chunks over before libpng does, which writes to standard error itself.
 */

#include <string>

/**
 * What is wrong with a PNG file, "byte N: ...", or an empty text: a header that is not the first
 * chunk or has no pixels, a chunk that is cut off or has a wrong checksum, no end. A file that does
 * not begin as a PNG is none of ours. Throws nothing.
 */
std::string MesoPngProblem(const std::string& fileName);

#endif

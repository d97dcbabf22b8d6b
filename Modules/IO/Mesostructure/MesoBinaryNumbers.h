#ifndef MesoBinaryNumbers_h
#define MesoBinaryNumbers_h

/**
 * @file MesoBinaryNumbers.h
 * @brief Numbers of binary files, of either byte order, wherever they lie.
 */

#include <algorithm>
#include <cstring>

/// The number that these bytes are. This machine's order is little-endian, as all that we build for.
template <typename T>
T MesoBinaryNumber(const char* bytes, bool isBigEndian)
{
  char ordered[sizeof(T)];
  std::copy(bytes, bytes + sizeof(T), ordered);
  if (isBigEndian)
  {
    std::reverse(ordered, ordered + sizeof(T));
  }
  T number;
  std::memcpy(&number, ordered, sizeof(T));
  return number;
}

#endif

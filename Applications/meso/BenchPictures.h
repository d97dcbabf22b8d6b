#ifndef BenchPictures_h
#define BenchPictures_h

#include "MesoImageError.h"

#include <string>

/// Write truth, test, FLIP error and classes side by side as a PNG. `error` has all of them.
void WriteStrip(const MesoPicture& truth, const MesoPicture& test, const MesoImageError& error,
  const std::string& fileName);

/// Write truth, test and classes around the pixel whose texture coordinate is worst, enlarged, side by
/// side as a PNG. The pixel itself lies in the middle unless the picture ends before.
void WriteWorst(const MesoPicture& truth, const MesoPicture& test, const MesoImageError& error,
  const std::string& fileName);

#endif

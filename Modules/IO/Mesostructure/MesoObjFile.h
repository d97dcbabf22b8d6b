#ifndef MesoObjFile_h
#define MesoObjFile_h

/**
 * @file MesoObjFile.h
 * @brief Scans a Wavefront OBJ file and checks all that it says.
 *
 * Reads `v`, `vt`, `vn` and `f`; a vertex' fourth number and colours are passed over, a missing
 * second texture coordinate is 0. Groups, smoothing groups and materials are passed over in
 * silence, lines, points, curves and unknown keywords with a note. Numbers are read as double.
 *
 * Refused with the line number: numbers that are missing, no numbers, not finite or beyond 1e30 in
 * magnitude; faces of fewer than 3 or more than MesoObjMostCorners corners; indices that are 0,
 * before the first or after the last element of the file (negative ones count back from the line
 * that they stand in); lines that do not begin with a word. Refused as a whole: files that are
 * empty, larger than MesoObjLargestFile or without a face.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Bytes of a file, at most; checked before memory is taken.
constexpr std::uintmax_t MesoObjLargestFile = 2147483647;
/// Corners of a face, at most.
constexpr std::size_t MesoObjMostCorners = 4096;

/// Numbers, from 0, of what meets at a face's corner; -1 where the file names none.
struct MesoObjCorner
{
  std::int32_t Position;
  std::int32_t TextureCoordinate;
  std::int32_t Normal;
};

struct MesoObjFile
{
  std::vector<std::array<double, 3>> Positions;
  std::vector<std::array<double, 2>> TextureCoordinates;
  std::vector<std::array<double, 3>> Normals; ///< as in the file, of any length
  std::vector<MesoObjCorner> Corners;
  /// Face i has Corners[FirstCorner[i]] to Corners[FirstCorner[i + 1] - 1], one more than faces.
  std::vector<std::size_t> FirstCorner = { 0 };
  std::vector<std::size_t> FaceLine; ///< the line, from 1, that face i begins in
  std::vector<std::string> Notes;    ///< what was passed over, a line each

  std::size_t NumberOfFaces() const { return this->FaceLine.size(); }
};

/// Throws MesoInputError "file: line N: reason".
MESOIOMESOSTRUCTURE_EXPORT MesoObjFile MesoReadObj(const std::string& fileName);

/// The same from text; `fileName` serves the messages only.
MESOIOMESOSTRUCTURE_EXPORT MesoObjFile MesoParseObj(
  const std::string& text, const std::string& fileName);

#endif

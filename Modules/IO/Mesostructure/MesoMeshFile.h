#ifndef MesoMeshFile_h
#define MesoMeshFile_h

/**
 * @file MesoMeshFile.h
 * @brief What a mesh file says, whatever its format: positions, faces, and what meets at a corner.
 *
 * Each format has a function of its own that fills this and checks all that its file says
 * (MesoObjFile.h, MesoPlyFile.h, ...). All refuse, with the file's name and the place in it: numbers
 * that are missing, no numbers, not finite or beyond MesoMeshLargestNumber in magnitude; faces of
 * fewer than 3 or more than MesoMeshMostCorners corners; indices of what is not there; files that
 * are empty, larger than MesoMeshLargestFile or without a face. What is passed over is a note.
 */

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkPointData;

/// Bytes of a file, at most; checked before memory is taken.
constexpr std::uintmax_t MesoMeshLargestFile = 2147483647;
/// Corners of a face, at most.
constexpr std::size_t MesoMeshMostCorners = 4096;
/// A number of a mesh in magnitude, at most: its square is far from overflow.
constexpr double MesoMeshLargestNumber = 1e30;

/// Numbers, from 0, of what meets at a face's corner; -1 where the file names none.
struct MesoMeshCorner
{
  std::int32_t Position;
  std::int32_t TextureCoordinate;
  std::int32_t Normal;
};

struct MesoMeshFile
{
  std::vector<std::array<double, 3>> Positions;
  std::vector<std::array<double, 2>> TextureCoordinates; ///< t up
  std::vector<std::array<double, 3>> Normals;            ///< as in the file, of any length
  std::vector<MesoMeshCorner> Corners;
  /// Face i has Corners[FirstCorner[i]] to Corners[FirstCorner[i + 1] - 1], one more than faces.
  std::vector<std::size_t> FirstCorner = { 0 };
  /// Where face i is, as a user would find it: the line or the face's number.
  std::vector<std::size_t> FacePlace;
  const char* PlaceName = "line"; ///< what FacePlace counts: "line" from 1, "face" from 0
  /// Further arrays, a tuple for each position; null in formats that have none.
  vtkSmartPointer<vtkPointData> PointData;
  std::vector<std::string> Notes; ///< what was passed over, a line each

  std::size_t NumberOfFaces() const { return this->FacePlace.size(); }
  /// Ends the face that the corners since the last face make.
  void CloseFace(std::size_t place)
  {
    this->FirstCorner.push_back(this->Corners.size());
    this->FacePlace.push_back(place);
  }
};

#endif

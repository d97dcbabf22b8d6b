#ifndef MesoMeshReport_h
#define MesoMeshReport_h

/**
 * @file MesoMeshReport.h
 * @brief Counts what is in a mesh and what is odd about it.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstddef>
#include <optional>

class vtkPolyData;

/// What texture coordinates do. Lengths and areas in texture space have no unit.
struct MesoChartReport
{
  std::array<double, 2> Least = { 0., 0. };
  std::array<double, 2> Most = { 0., 0. };
  std::size_t Charts = 0;     ///< triangles joined over edges at which coordinates agree
  std::size_t SeamEdges = 0;  ///< edges of two triangles that are no such joint
  std::size_t Mirrored = 0;   ///< triangles turned over in texture space
  std::size_t Degenerate = 0; ///< triangles without area in texture space
  /// Part of the covered texture space that two triangles or more cover, from 0 to 1, found at
  /// 512 x 512 places; nothing where that would take too long.
  std::optional<double> Overlap;
  /// Object units a unit of texture coordinates, the root of the ratio of all areas.
  double Scale = 0.;
};

struct MesoMeshReport
{
  std::size_t Points = 0;   ///< split at seams
  std::size_t Vertices = 0; ///< different positions
  std::size_t Triangles = 0;
  std::array<double, 3> Least = { 0., 0., 0. };
  std::array<double, 3> Most = { 0., 0., 0. };
  bool IsDouble = false; ///< positions that a float could not hold
  bool HasNormals = false;
  std::size_t Components = 0;          ///< triangles joined over common vertices
  std::size_t BoundaryEdges = 0;       ///< of one triangle
  std::size_t NonManifoldEdges = 0;    ///< of three triangles or more
  std::size_t TurnedEdges = 0;         ///< of two triangles of opposite winding
  std::size_t NonManifoldVertices = 0; ///< where several fans of triangles meet in nothing else
  std::size_t Degenerate = 0;          ///< triangles without area
  std::size_t Duplicate = 0;           ///< triangles over three vertices that had a triangle before
  /// What the surface encloses, negative where it is inside out; nothing unless it is closed and its
  /// winding agrees everywhere.
  std::optional<double> Volume;
  std::optional<MesoChartReport> Chart; ///< nothing without texture coordinates
};

/// Of a mesh of triangles, as vtkMesoMeshReader gives it. Points of equal position count as one
/// vertex. An area is none below 1e-12 of the square of the triangle's longest side.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshReport MesoReportMesh(vtkPolyData* mesh);

#endif

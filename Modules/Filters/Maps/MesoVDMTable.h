#ifndef MesoVDMTable_h
#define MesoVDMTable_h

/**
 * @file MesoVDMTable.h
 * @brief What a table of view-dependent displacements is: its axes, its numbers, its fields in a file.
 *
 * Source: Wang et al., "View-Dependent Displacement Mapping", SIGGRAPH 2003, sections 3.1 and 3.3.
 * Shaders/Kernels/VDMTable.glsl has the formulas.
 */

#include "mesoFiltersMapsModule.h" // for export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkImageData;

/// Grows when what is baked from the same map and layout changes.
constexpr double MesoVDMVersion = 4.;

/// What is stored of the point where a ray meets the relief; counts as VDMStores... of the kernel.
enum class MesoVDMStores
{
  Distance, ///< d = l / sin(polar), the paper's
  Depth,    ///< h on the ray's way down; on the way up again it counts on from the deepest point
  Offset    ///< l along the base
};

/// Where the polar angles lie; counts as VDMNodes... of the kernel.
enum class MesoVDMNodes
{
  Edges,   ///< evenly from 0 to 90 degrees, both among them
  Centres, ///< in the middles of even parts of 0 to 90 degrees
  Graded   ///< centres, but denser towards 90 degrees: (1 - polar / 90)^(4/5) is even
};

/// How other curvatures than 0 are baked.
enum class MesoVDMCurved
{
  Exact, ///< rays through the bent mesostructure
  Bent   ///< the appendix: the points of curvature 0 bent, and resampled over their new angles
};

/**
 * The axes of a table. Lengths are in tiles: the map is 1 x 1, its relief Depth deep.
 *
 * Sample (x, y) is at the map coordinate ((x + 0.5) / Width, (y + 0.5) / Height); azimuth a stands for the
 * direction of travel (cos, sin)(2 pi a / Azimuths) over the map; curvatures lie evenly from the first to
 * the last, in 1 / tile, positive where the base is convex.
 */
struct MESOFILTERSMAPS_EXPORT MesoVDMLayout
{
  int Width = 128;
  int Height = 128;
  int Azimuths = 32;
  int Polars = 8;
  int Curvatures = 16;
  double FirstCurvature = -2.;
  double LastCurvature = 3.;
  double Depth = 0.1; ///< F: of the deepest point, in tiles
  MesoVDMNodes Nodes = MesoVDMNodes::Graded;
  MesoVDMStores Stores = MesoVDMStores::Depth;

  double PolarAt(int i) const; ///< radians
  /// The same of the ray that stands for it: 0.01 below 90 degrees, where rays meet nothing.
  double RayPolarAt(int i) const;
  /// Where an angle in radians lies among those of the table, which end it: 0 is the first.
  double PolarPlace(double polar) const;
  double CurvatureAt(int i) const; ///< 1 / tile
  /// What the stored number 1 stands for, in tiles: no ray of the table's angles comes further.
  double Range() const;
  std::size_t Rows() const { return std::size_t(this->Width) * this->Height * this->Azimuths; }
  int DistanceColumns() const { return this->Polars * this->Curvatures; }
  int Columns() const { return this->DistanceColumns() + this->Curvatures; }

  /// Why these numbers make no table; empty where they do.
  std::string Problem() const;

  ///@{
  /// As field data of an image, and back; the latter throws std::runtime_error with the reason where the
  /// image has none that make sense.
  void Write(vtkImageData* image) const;
  static MesoVDMLayout Read(vtkImageData* image);
  ///@}
};

/**
 * The numbers of a table, all in [0, 1]: a row each (x, y, azimuth), x fastest. A row has for each
 * curvature, slowest, and polar angle what is stored, over Range(); then for each curvature the largest
 * polar angle at which a ray meets the relief (the maximal view polar angle map), over 90 degrees. Where a
 * ray meets nothing the first holds the point at that largest angle.
 */
using MesoVDMNumbers = std::vector<float>;

/// Why an image (vtkMesoVDM) does not hold what its layout says, or holds numbers that no table has; empty
/// where it does.
MESOFILTERSMAPS_EXPORT std::string MesoVDMProblem(vtkImageData* table, const MesoVDMLayout& layout);

#endif

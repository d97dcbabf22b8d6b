#ifndef MesoVolume_h
#define MesoVolume_h

/**
 * @file MesoVolume.h
 * @brief Canonical volumes: the form that every mesostructure that is no height field is given.
 *
 * A canonical volume is a vtkImageData of W x H x D samples, one tile, with
 * - the point scalars `MesoSignedDistance` (1, float): distance to the solid's surface, negative inside;
 * - the field data array `MesoVolumeDepth` (1, double): F, the thickness of the shell in tile widths;
 * - and, if it has colours, the point array `MesoColor` (3, float): red, green and blue, [0, 1].
 *
 * Sample (i, j, k) lies at ((i + 0.5) / W, (j + 0.5) / H, (k + 0.5) / D) of texture space, where a tile is
 * 1 x 1 in x, y and z runs from 0 at the shell's bottom to 1 at its top. Distances and directions are
 * measured in (x, y, F z), tile widths. Between samples the volume is trilinear; x and y repeat, z is
 * that of the border samples up to the planes z = 0 and z = 1, beyond which there is nothing. The
 * surface is the zero set of this interpolant and, where the solid reaches one of the planes, the cut
 * through it there.
 */

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkSmartPointer.h"       // for the image

#include <array>
#include <string>
#include <vector>

class vtkFloatArray;
class vtkImageData;

/// What keeps an image from being a canonical volume, or an empty text.
MESOFILTERSMAPS_EXPORT std::string MesoVolumeProblem(vtkImageData* volume);

/// The colours of a canonical volume, x fastest, or null where it has none.
MESOFILTERSMAPS_EXPORT vtkFloatArray* MesoVolumeColors(vtkImageData* volume);

/**
 * Gives a canonical volume the colours of an image of three dimensions that covers its tile: the first three
 * components, where whole numbers of 8 and 16 bits stand for [0, 1] and others are taken as they are and
 * clamped to it. Of another size than the volume it is resampled (vtkMesoVolumeTile). Returns why that
 * cannot be, or an empty text.
 */
MESOFILTERSMAPS_EXPORT std::string MesoSetVolumeColors(vtkImageData* volume, vtkImageData* colors);

/// F of a canonical volume.
MESOFILTERSMAPS_EXPORT double MesoVolumeDepth(vtkImageData* volume);

/**
 * A canonical volume of distances, x fastest. Its spacing is that of the samples in tile widths, and its
 * origin puts the tile's corner at 0, so that it looks right where an image is shown.
 */
MESOFILTERSMAPS_EXPORT vtkSmartPointer<vtkImageData> MesoMakeVolume(
  std::array<int, 3> size, double depth, const std::vector<float>& distances);

/// The samples of a volume, between which it is trilinear. Positions are in texture space.
class MESOFILTERSMAPS_EXPORT MesoVolumeField
{
public:
  using Vector = std::array<double, 3>;

  /// `values`: W x H x D, x fastest, negative inside.
  MesoVolumeField(std::array<int, 3> size, double depth, std::vector<float> values);
  /// Of a canonical volume.
  explicit MesoVolumeField(vtkImageData* volume);

  const std::array<int, 3>& GetSize() const { return this->Size; }
  double GetDepth() const { return this->Depth; }
  const std::vector<float>& GetValues() const { return this->Values; }

  /// A sample; i and j are wrapped, k is clamped.
  double Sample(int i, int j, int k) const;
  /// The eight samples from (i, j, k) on, by z, y, x.
  void Corners(int i, int j, int k, double (&corner)[2][2][2]) const;
  double At(const Vector& position) const;
  /// Of the interpolant itself, in tile widths: discontinuous from cell to cell.
  Vector Gradient(const Vector& position) const;

private:
  std::array<int, 3> Size;
  double Depth;
  std::vector<float> Values;
};

#endif

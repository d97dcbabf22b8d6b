#ifndef MesoVDMImage_h
#define MesoVDMImage_h

#include "MesoVDMTable.h"

#include <array>
#include <functional>

/// Bits of a stored weight.
constexpr int MesoVDMLeastBits = 8;
constexpr int MesoVDMMostBits = 16;

/// What linear interpolation between polar angles and between azimuths leaves, root mean square of the
/// distances' numbers: an eighth of second differences.
double MesoVDMAngularError(const MesoVDMLayout& layout, const MesoVDMNumbers& numbers);

/// The numbers as they are, of 16 bit each, as an image's arrays VDM and MVM (vtkMesoVDM).
void MesoStoreVDM(const MesoVDMLayout& layout, const MesoVDMNumbers& numbers, vtkImageData* image);

/**
 * The numbers' factors as an image's arrays (vtkMesoVDM). Numbers are changed in place: the largest angles
 * to what they leave to 90 degrees, scaled to the others' root mean square, so that weights are shared
 * fairly.
 *
 * @param ranks factors of the distances and of the angles, each at least 1
 * @param bits of a weight, 8 or 16
 * @param progress told how much is done, 0 to 1; false stops
 * @return false where it was stopped
 */
bool MesoStoreVDMFactors(const MesoVDMLayout& layout, MesoVDMNumbers& numbers,
  const std::array<int, 2>& ranks, int bits, const std::function<bool(double)>& progress,
  vtkImageData* image);

#endif

#ifndef MesoVolumeFormats_h
#define MesoVolumeFormats_h

/**
 * @file MesoVolumeFormats.h
 * @brief Volumes out of the bytes of files, each format for itself.
 *
 * Each gives an image of one component, of the file's type, with the samples' spacing, and throws
 * MesoInputError "file: reason" where the bytes are none of its format, or damaged. What else is needed is
 * read beside the file.
 */

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

/// NRRD (.nrrd, .nhdr): raw, gzip or text, here or in one file beside it.
vtkSmartPointer<vtkImageData> MesoParseNrrd(const std::string& bytes, const std::string& fileName);

/// MetaImage (.mha, .mhd): raw, compressed or text, here or in one file beside it.
vtkSmartPointer<vtkImageData> MesoParseMetaImage(
  const std::string& bytes, const std::string& fileName);

/// VTK's XML image (.vti), of which the scalars' first component counts.
vtkSmartPointer<vtkImageData> MesoParseVti(const std::string& bytes, const std::string& fileName);

#endif

#include "MesoVolumeFormats.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoVolumeNumbers.h"
#include "MesoVtkXml.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cstdio>

namespace
{
/// Throws where an extent has more samples than the file can hold: VTK takes memory for them before it
/// reads.
void CheckExtents(const std::string& bytes, const std::string& fileName)
{
  const std::string name = "Extent=";
  std::size_t place = 0;
  int found = 0;
  while ((place = bytes.find(name, place)) != std::string::npos)
  {
    place += name.size();
    long long extent[6];
    if (std::sscanf(bytes.c_str() + place + 1, "%lld %lld %lld %lld %lld %lld", extent, extent + 1,
          extent + 2, extent + 3, extent + 4, extent + 5) != 6)
    {
      throw MesoInputError(fileName + ": byte " + std::to_string(place) + ": is no extent");
    }
    double samples = 1.;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double side = double(extent[2 * axis + 1]) - double(extent[2 * axis]) + 1.;
      if (!(side >= 1. && side <= MesoVolumeLargestSide))
      {
        throw MesoInputError(fileName + ": has a side of " + MesoNumberText(float(side)) +
          " samples; allowed are 1 to " + std::to_string(MesoVolumeLargestSide));
      }
      samples *= side;
    }
    if (samples > double(bytes.size()) * double(MesoXmlMostBytesOfOne))
    {
      throw MesoInputError(fileName + ": holds fewer samples than its extent says");
    }
    ++found;
  }
  if (found == 0)
  {
    throw MesoInputError(fileName + ": has no extent: it is no image");
  }
}
}

vtkSmartPointer<vtkImageData> MesoParseVti(const std::string& bytes, const std::string& fileName)
{
  CheckExtents(bytes, fileName);
  vtkNew<vtkXMLImageDataReader> reader;
  MesoReadVtkXml(reader, bytes, fileName);
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  vtkPointData* data = image->GetPointData();
  if (!data->GetScalars() && data->GetNumberOfArrays() > 0 && data->GetArray(0))
  {
    data->SetActiveScalars(data->GetArrayName(0));
  }
  vtkDataArray* scalars = data->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    image->GetNumberOfPoints() == 0)
  {
    throw MesoInputError(fileName + ": holds no numbers for its samples");
  }
  int size[3];
  image->GetDimensions(size);
  image->SetExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  return image;
}

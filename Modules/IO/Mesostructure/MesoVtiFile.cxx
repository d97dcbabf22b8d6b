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
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{
/// The places behind `name="`, however it is quoted and spaced.
std::vector<std::size_t> ValuesOf(const std::string& name, const std::string& bytes)
{
  std::vector<std::size_t> places;
  const char* blanks = " \t\r\n";
  for (std::size_t place = 0; (place = bytes.find(name, place)) != std::string::npos;)
  {
    place += name.size();
    const std::size_t equals = bytes.find_first_not_of(blanks, place);
    const std::size_t quote = equals == std::string::npos || bytes[equals] != '='
      ? std::string::npos
      : bytes.find_first_not_of(blanks, equals + 1);
    if (quote != std::string::npos && (bytes[quote] == '"' || bytes[quote] == '\''))
    {
      places.push_back(quote + 1);
    }
  }
  return places;
}

double ComponentsOf(const std::string& bytes)
{
  double most = 1.;
  for (const std::size_t place : ValuesOf("NumberOfComponents", bytes))
  {
    most = std::max(most, std::strtod(bytes.c_str() + place, nullptr));
  }
  return most;
}

/// Throws where an extent has more samples than the file can hold: VTK takes memory for them before it
/// reads.
void CheckExtents(const std::string& bytes, const std::string& fileName)
{
  const std::vector<std::size_t> places = ValuesOf("Extent", bytes);
  const double components = ComponentsOf(bytes);
  for (const std::size_t place : places)
  {
    long long extent[6];
    if (std::sscanf(bytes.c_str() + place, "%lld %lld %lld %lld %lld %lld", extent, extent + 1,
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
    if (!(samples * components <= double(bytes.size()) * double(MesoXmlMostBytesOfOne)))
    {
      throw MesoInputError(fileName + ": holds fewer samples than its extent says");
    }
  }
  if (places.empty())
  {
    throw MesoInputError(fileName + ": has no extent: it is no image");
  }
}

/// VTK takes the standard one where it is none.
void CheckSpacing(const std::string& bytes, const std::string& fileName)
{
  for (const std::size_t place : ValuesOf("Spacing", bytes))
  {
    double spacing[3] = { 0., 0., 0. };
    std::sscanf(bytes.c_str() + place, "%lf %lf %lf", spacing, spacing + 1, spacing + 2);
    for (const double side : spacing)
    {
      if (!(side > 0.) || !std::isfinite(side))
      {
        throw MesoInputError(fileName + ": byte " + std::to_string(place) +
          ": has a Spacing that is not three finite numbers above 0");
      }
    }
  }
}
}

vtkSmartPointer<vtkImageData> MesoParseVti(const std::string& bytes, const std::string& fileName)
{
  CheckExtents(bytes, fileName);
  CheckSpacing(bytes, fileName);
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

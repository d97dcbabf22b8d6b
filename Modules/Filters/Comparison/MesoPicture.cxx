#include "MesoPicture.h"

#include "MesoImageFile.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

MesoPicture MesoPictureOfImage(vtkImageData* image)
{
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetNumberOfTuples() < 1)
  {
    throw MesoInputError("the image is empty");
  }
  const int* size = image->GetDimensions();
  const int components = values->GetNumberOfComponents();
  const int type = values->GetDataType();
  if (size[2] != 1 || components == 2 || components > 4)
  {
    throw MesoInputError("a picture has one slice and 1, 3 or 4 channels, not " +
      std::to_string(size[2]) + " and " + std::to_string(components));
  }
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT)
  {
    throw MesoInputError("a picture has values of 8 or 16 bits, not of type " +
      std::string(values->GetDataTypeAsString()));
  }
  const double most = type == VTK_UNSIGNED_CHAR ? 255. : 65535.;
  MesoPicture picture;
  picture.Width = size[0];
  picture.Height = size[1];
  picture.Rgb.resize(3 * picture.NumberOfPixels());
  std::size_t out = 0;
  for (int row = 0; row < size[1]; ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      const vtkIdType pixel = vtkIdType(size[1] - 1 - row) * size[0] + column;
      if (components == 4 && values->GetComponent(pixel, 3) != most)
      {
        throw MesoInputError("the pixel in column " + std::to_string(column) + " of row " +
          std::to_string(row) + " is transparent; colours behind it are not known");
      }
      for (int channel = 0; channel < 3; ++channel)
      {
        const double value = values->GetComponent(pixel, components == 1 ? 0 : channel);
        picture.Rgb[out++] = static_cast<float>(value / most);
      }
    }
  }
  return picture;
}

MesoPicture MesoReadPicture(const std::string& fileName)
{
  MesoImageInput file(fileName);
  const MesoImageHeader& header = file.Header();
  const int types[] = { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_FLOAT };
  vtkNew<vtkImageData> image;
  image->SetDimensions(header.Width, header.Height, 1);
  image->AllocateScalars(
    types[static_cast<int>(header.ValueType)], static_cast<int>(header.ChannelNames.size()));
  file.Read(image->GetScalarPointer(), MesoImageInput::RowOrder::BottomFirst);
  try
  {
    return MesoPictureOfImage(image);
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(fileName + ": " + problem.what());
  }
}

double MesoLinearOfSRGB(double encoded)
{
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

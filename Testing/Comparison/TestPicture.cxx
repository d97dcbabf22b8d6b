// Pictures out of images of VTK.

#include "MesoPicture.h"
#include "MesoScene.h" // for MesoInputError

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkImageData> Image(int type, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 3, 1);
  image->AllocateScalars(type, components);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 2; ++column)
    {
      for (int component = 0; component < components; ++component)
      {
        const bool alpha = component == 3;
        image->SetScalarComponentFromDouble(column, row, 0, component,
          alpha ? image->GetScalarTypeMax() : 10. * row + 3. * column + component);
      }
    }
  }
  return image;
}
}

TEST(Picture, BeginsAtTheTop)
{
  const MesoPicture picture = MesoPictureOfImage(Image(VTK_UNSIGNED_CHAR, 3));
  ASSERT_EQ(picture.Width, 2);
  ASSERT_EQ(picture.Height, 3);
  EXPECT_FLOAT_EQ(picture.Rgb[0], 20.f / 255.f);
  EXPECT_FLOAT_EQ(picture.Rgb[5], 25.f / 255.f);
  EXPECT_FLOAT_EQ(picture.Rgb[12], 0.f);
}

TEST(Picture, TakesGreyOpaqueAndSixteenBits)
{
  EXPECT_FLOAT_EQ(MesoPictureOfImage(Image(VTK_UNSIGNED_CHAR, 1)).Rgb[2], 20.f / 255.f);
  EXPECT_FLOAT_EQ(MesoPictureOfImage(Image(VTK_UNSIGNED_CHAR, 4)).Rgb[4], 24.f / 255.f);
  EXPECT_FLOAT_EQ(MesoPictureOfImage(Image(VTK_UNSIGNED_SHORT, 3)).Rgb[0], 20.f / 65535.f);
}

TEST(Picture, RefusesWhatItDoesNotUnderstand)
{
  vtkSmartPointer<vtkImageData> transparent = Image(VTK_UNSIGNED_CHAR, 4);
  transparent->SetScalarComponentFromDouble(1, 0, 0, 3, 254.);
  EXPECT_THROW(MesoPictureOfImage(transparent), MesoInputError);
  EXPECT_THROW(MesoPictureOfImage(Image(VTK_UNSIGNED_CHAR, 2)), MesoInputError);
  EXPECT_THROW(MesoPictureOfImage(Image(VTK_FLOAT, 3)), MesoInputError);
  EXPECT_THROW(MesoPictureOfImage(nullptr), MesoInputError);
  const vtkNew<vtkImageData> empty;
  EXPECT_THROW(MesoPictureOfImage(empty), MesoInputError);
}

TEST(Picture, DecodesSRGB)
{
  EXPECT_EQ(MesoLinearOfSRGB(0.), 0.);
  EXPECT_DOUBLE_EQ(MesoLinearOfSRGB(1.), 1.);
  EXPECT_NEAR(MesoLinearOfSRGB(0.5), 0.214041140, 1e-9);
  EXPECT_NEAR(MesoLinearOfSRGB(0.04045), 0.0031308, 1e-7);
}

// Errors as pictures.

#include "MesoErrorPictures.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>
#include <set>

TEST(ErrorPictures, ColoursGrowLighter)
{
  EXPECT_EQ(MesoColorOfError(0.), (MesoByteColor{ 0, 0, 4 }));
  EXPECT_EQ(MesoColorOfError(1.), (MesoByteColor{ 252, 253, 191 }));
  EXPECT_EQ(MesoColorOfError(-1.), MesoColorOfError(0.));
  EXPECT_EQ(MesoColorOfError(2.), MesoColorOfError(1.));
  double before = -1.;
  for (int i = 0; i <= 32; ++i)
  {
    const MesoByteColor color = MesoColorOfError(i / 32.);
    const double luma = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    EXPECT_GT(luma, before) << i;
    before = luma;
  }
}

TEST(ErrorPictures, ClassesHaveNamesAndColoursOfTheirOwn)
{
  std::set<std::string> names;
  std::set<MesoByteColor> colors;
  const int count = static_cast<int>(MesoPixelClass::Equal) + 1;
  for (int kind = 0; kind < count; ++kind)
  {
    names.insert(MesoNameOfClass(static_cast<MesoPixelClass>(kind)));
    colors.insert(MesoColorOfClass(static_cast<MesoPixelClass>(kind)));
  }
  EXPECT_EQ(names.size(), std::size_t(count));
  EXPECT_EQ(colors.size(), std::size_t(count));
}

TEST(ErrorPictures, BeginAtTheBottom)
{
  const auto errors = MesoPictureOfErrors({ 0.f, 1.f, 0.f, 0.f, 0.f, 0.f }, 2, 3);
  const auto* top = static_cast<unsigned char*>(errors->GetScalarPointer(1, 2, 0));
  EXPECT_EQ(top[0], 252);
  const auto classes = MesoPictureOfClasses(
    { MesoPixelClass::Empty, MesoPixelClass::Empty, MesoPixelClass::Hole, MesoPixelClass::Empty },
    2, 2);
  const auto* bottom = static_cast<unsigned char*>(classes->GetScalarPointer(0, 0, 0));
  EXPECT_EQ(bottom[0], 255);
  EXPECT_EQ(bottom[1], 0);
}

// vtkMesoImageError: the same figures as the functions that it forwards to.

#include "ErrorRecorder.h"
#include "MesoPictureError.h"
#include "PairsOfPictures.h"
#include "vtkMesoImageError.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkImageData> ImageOf(const MesoPicture& picture)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int i = 0; i < 3 * picture.Width; ++i)
    {
      image->SetScalarComponentFromDouble(i / 3, picture.Height - 1 - row, 0, i % 3,
        std::round(255. * picture.Rgb[std::size_t(row) * 3 * picture.Width + i]));
    }
  }
  return image;
}
}

TEST(ImageErrorFilter, GivesFiguresAndMap)
{
  const MesoPicture truth = PairsOfPictures::Smooth(0, 128);
  const MesoPicture test = PairsOfPictures::Smooth(2, 140);
  const MesoPictureError expected = MesoComparePictures(truth, test);
  vtkNew<vtkMesoImageError> filter;
  EXPECT_TRUE(std::isnan(filter->GetFlipMean()));
  filter->SetInputData(0, ImageOf(truth));
  filter->SetInputData(1, ImageOf(test));
  filter->Update();
  EXPECT_EQ(filter->GetFlipMean(), expected.FlipMean);
  EXPECT_EQ(filter->GetSsim(), expected.Ssim);
  EXPECT_EQ(filter->GetRmse(), expected.Rmse);
  vtkImageData* map = filter->GetOutput();
  ASSERT_EQ(map->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(map->GetScalarComponentAsFloat(23, PairsOfPictures::Height - 1 - 5, 0, 0),
    expected.FlipMap[PairsOfPictures::At(23, 5)]);
}

TEST(ImageErrorFilter, RefusesDifferentSizes)
{
  vtkNew<vtkMesoImageError> filter;
  vtkNew<vtkImageData> small;
  small->SetDimensions(2, 2, 1);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  filter->SetInputData(0, ImageOf(PairsOfPictures::Noisy(1)));
  filter->SetInputData(1, small);
  ErrorRecorder recorder;
  recorder.Watch(filter);
  filter->Update();
  EXPECT_EQ(recorder.Errors.size(), 1u);
  EXPECT_TRUE(std::isnan(filter->GetSsim()));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

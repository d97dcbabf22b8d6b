// The built-in volumes: canonical, with a surface, tiling, the same from size to size.

#include "ErrorRecorder.h"
#include "MesoVolume.h"
#include "MesoVolumePattern.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoVolumeSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkImageData> Make(const std::string& pattern, std::array<int, 3> size)
{
  vtkNew<vtkMesoVolumeSource> source;
  source->SetPattern(pattern.c_str());
  source->SetSize(size.data());
  source->Update();
  return source->GetOutput();
}
}

class VolumePatterns : public testing::TestWithParam<std::string>
{
};

TEST_P(VolumePatterns, GiveCanonicalVolumesWithSolidAndAir)
{
  const auto image = Make(GetParam(), { 32, 32, 16 });
  ASSERT_EQ(MesoVolumeProblem(image), "");
  const MesoVolumeField field(image);
  const auto& values = field.GetValues();
  const auto inside = std::count_if(values.begin(), values.end(), [](float v) { return v < 0.f; });
  const auto share = double(inside) / double(values.size());
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.9);
  EXPECT_EQ(field.GetDepth(), MesoVolumePattern(GetParam()).GetDepth());
}

TEST_P(VolumePatterns, RepeatInXAndYWithoutASeam)
{
  const MesoVolumePattern pattern(GetParam(), 7);
  for (double z : { 0.1, 0.45, 0.8 })
  {
    for (double t = 0.03; t < 1.; t += 0.1)
    {
      EXPECT_NEAR(pattern.At(t, 0.2, z), pattern.At(t + 3., 0.2 - 2., z), 1e-9);
      // As near across the border as a step of that length allows.
      constexpr double step = 1e-4;
      EXPECT_NEAR(pattern.At(-step, t, z), pattern.At(step, t, z), 20. * step);
      EXPECT_NEAR(pattern.At(t, -step, z), pattern.At(t, step, z), 20. * step);
    }
  }
}

TEST_P(VolumePatterns, HoldDistances)
{
  // No two samples differ by more than they are apart; nearly all by as much along some axis.
  const auto image = Make(GetParam(), { 48, 48, 16 });
  const MesoVolumeField field(image);
  const auto& size = field.GetSize();
  const double apart[3] = { 1. / size[0], 1. / size[1], field.GetDepth() / size[2] };
  int steep = 0;
  for (int k = 0; k + 1 < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double here = field.Sample(i, j, k);
        const double steps[3] = { field.Sample(i + 1, j, k) - here,
          field.Sample(i, j + 1, k) - here, field.Sample(i, j, k + 1) - here };
        double square = 0.;
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_LE(std::abs(steps[axis]), 1.06 * apart[axis]) << i << " " << j << " " << k;
          square += std::pow(steps[axis] / apart[axis], 2.);
        }
        steep += square > 0.5;
      }
    }
  }
  EXPECT_GT(steep, 0.75 * size[0] * size[1] * (size[2] - 1));
}

TEST_P(VolumePatterns, AreTheSameSurfaceInEverySize)
{
  const auto image = Make(GetParam(), { 32, 32, 16 });
  const MesoVolumeField field(image);
  const MesoVolumePattern pattern(GetParam(), 1);
  int agree = 0;
  int all = 0;
  for (double z = 0.05; z < 1.; z += 0.11)
  {
    for (double y = 0.01; y < 1.; y += 0.07)
    {
      for (double x = 0.02; x < 1.; x += 0.07)
      {
        agree += (field.At({ x, y, z }) < 0.) == (pattern.At(x, y, z) < 0.);
        ++all;
      }
    }
  }
  EXPECT_GT(agree, 0.93 * all);
}

INSTANTIATE_TEST_SUITE_P(All, VolumePatterns, testing::ValuesIn(MesoVolumePatternNames()),
  [](const auto& info) { return info.param; });

TEST(VolumeSource, GivesTheSameBytesForTheSameSeedAndOthersForAnother)
{
  const MesoVolumePattern first("foam", 3);
  const MesoVolumePattern same("foam", 3);
  const MesoVolumePattern other("foam", 4);
  std::vector<float> a(8 * 8 * 4);
  std::vector<float> b = a;
  std::vector<float> c = a;
  first.Slices({ 8, 8, 4 }, 0, 4, a.data());
  same.Slices({ 8, 8, 4 }, 0, 4, b.data());
  other.Slices({ 8, 8, 4 }, 0, 4, c.data());
  EXPECT_EQ(a, b);
  EXPECT_NE(a, c);
}

TEST(VolumeSource, SaysWhatIsWrong)
{
  EXPECT_NE(MesoVolumePatternProblem("wool").find("'weave'"), std::string::npos);
  EXPECT_NE(
    MesoVolumePatternProblem("weave", { { "threads", 3. } }).find("even"), std::string::npos);
  EXPECT_NE(MesoVolumePatternProblem("weave", { { "bars", 3. } }).find("unknown key 'bars'"),
    std::string::npos);
  EXPECT_NE(
    MesoVolumePatternProblem("chain", { { "depth", 0.1 } }).find("higher"), std::string::npos);
  EXPECT_NE(
    MesoVolumePatternProblem("chain", { { "width", 0.1 } }).find("no room"), std::string::npos);
  EXPECT_THROW(MesoVolumePattern("wool"), std::invalid_argument);
  vtkNew<vtkMesoVolumeSource> source;
  ErrorRecorder errors;
  errors.Watch(source);
  source->SetSize(1, 8, 8);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(source->GetErrorMessage().find("2 to 512"), std::string::npos);
}

TEST(CanonicalVolume, IsToldFromOtherImages)
{
  EXPECT_NE(MesoVolumeProblem(nullptr), "");
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_NE(MesoVolumeProblem(image).find("MesoSignedDistance"), std::string::npos);
  const auto good = MesoMakeVolume({ 2, 2, 2 }, 0.5, std::vector<float>(8, 1.f));
  EXPECT_EQ(MesoVolumeProblem(good), "");
  auto* distances = vtkFloatArray::SafeDownCast(good->GetPointData()->GetScalars());
  distances->SetValue(3, NAN);
  EXPECT_NE(MesoVolumeProblem(good).find("finite"), std::string::npos);
}

// vtkMesoPatternSource: maps tile, stay in [0,1], are the same in every run and the same surface at
// every size; what is unknown is refused in one line.

#include "ErrorRecorder.h"

#include "MesoPattern.h"
#include "vtkMesoPatternSource.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace
{
class PatternSource : public ::testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    this->Recorder.Watch(this->Source);
    this->Source->SetPattern(this->GetParam());
  }

  const float* Make(int width, int height)
  {
    this->Source->SetSize(width, height);
    this->Source->Update();
    EXPECT_TRUE(this->Recorder.Errors.empty());
    vtkImageData* image = this->Source->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], width);
    EXPECT_EQ(image->GetDimensions()[1], height);
    EXPECT_EQ(image->GetDimensions()[2], 1);
    EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
    EXPECT_EQ(image->GetNumberOfScalarComponents(), 1);
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Height");
    return static_cast<const float*>(image->GetScalarPointer());
  }

  ErrorRecorder Recorder;
  vtkNew<vtkMesoPatternSource> Source;
};
}

TEST_P(PatternSource, HeightsAreInTheUnitIntervalAndDiffer)
{
  const float* heights = this->Make(64, 96);
  const auto [least, most] = std::minmax_element(heights, heights + 64 * 96);
  EXPECT_GE(*least, 0.f);
  EXPECT_LE(*most, 1.f);
  EXPECT_GT(*most - *least, 0.3f);
}

TEST_P(PatternSource, TexelsAreTheFunctionAtTheirCentresFromTheBottomUp)
{
  const float* heights = this->Make(20, 12);
  const MesoPattern pattern(this->GetParam(), 1);
  for (int j = 0; j < 12; ++j)
  {
    for (int i = 0; i < 20; ++i)
    {
      ASSERT_EQ(heights[20 * j + i], static_cast<float>(pattern.At((i + 0.5) / 20, (j + 0.5) / 12)))
        << i << " " << j;
    }
  }
}

// The border's texels are those of the neighbouring tiles, one tile on.
TEST_P(PatternSource, TilesExactly)
{
  const float* heights = this->Make(48, 48);
  const MesoPattern pattern(this->GetParam(), 1);
  for (int k = 0; k < 48; ++k)
  {
    const double at = (k + 0.5) / 48;
    // Only the rounding of s and t differs; steep edges of a pattern make it larger.
    EXPECT_NEAR(heights[48 * k], pattern.At(1. + 0.5 / 48, at), 1e-6);
    EXPECT_NEAR(heights[48 * k + 47], pattern.At(-0.5 / 48, at), 1e-6);
    EXPECT_NEAR(heights[k], pattern.At(at, 1. + 0.5 / 48), 1e-6);
    EXPECT_NEAR(heights[48 * 47 + k], pattern.At(at, -0.5 / 48), 1e-6);
  }
}

TEST_P(PatternSource, IsTheSameInEveryRun)
{
  const float* heights = this->Make(32, 32);
  const std::vector<float> first(heights, heights + 32 * 32);
  this->Source->Modified();
  heights = this->Make(32, 32);
  EXPECT_EQ(std::memcmp(first.data(), heights, first.size() * sizeof(float)), 0);
  const bool seeded = this->GetParam() != std::string("step");
  this->Source->SetSeed(2);
  heights = this->Make(32, 32);
  EXPECT_EQ(std::memcmp(first.data(), heights, first.size() * sizeof(float)) != 0, seeded);
}

// A map of three times the size has the texel centres of the smaller one among its own.
TEST_P(PatternSource, SizesShowTheSameSurface)
{
  const float* heights = this->Make(16, 24);
  const std::vector<float> small(heights, heights + 16 * 24);
  heights = this->Make(48, 72);
  for (int j = 0; j < 24; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      ASSERT_NEAR(heights[48 * (3 * j + 1) + 3 * i + 1], small[16 * j + i], 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PatternSource, ::testing::Values("brick", "smooth", "noise", "step"));

TEST(PatternSourceSizes, MayBeOneTexelAndManyRows)
{
  vtkNew<vtkMesoPatternSource> source;
  source->SetPattern("smooth");
  source->SetSize(1, 1);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 1);
  source->SetSize(3, 201); // more rows than are made at once, and not a multiple of them
  source->Update();
  const MesoPattern pattern("smooth", 1);
  for (int row : { 0, 63, 64, 128, 200 })
  {
    EXPECT_EQ(source->GetOutput()->GetScalarComponentAsFloat(2, row, 0, 0),
      static_cast<float>(pattern.At(2.5 / 3, (row + 0.5) / 201)));
  }
}

TEST(PatternSourceErrors, AreOneLineAndGiveNothing)
{
  ErrorRecorder recorder;
  vtkNew<vtkMesoPatternSource> source;
  recorder.Watch(source);
  const auto expect = [&](const std::string& part)
  {
    recorder.Clear();
    source->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u) << part;
    EXPECT_NE(recorder.Errors[0].find(part), std::string::npos) << recorder.Errors[0];
    EXPECT_NE(source->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(source->GetOutput()->GetPointData()->GetScalars(), nullptr);
  };
  source->SetSize(8, 8);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 64);
  source->SetPattern("marble");
  expect("unknown pattern 'marble'");
  source->SetPattern(nullptr);
  expect("unknown pattern ''");
  source->SetPattern("noise");
  source->SetParameter("rows", 4.);
  expect("unknown key 'rows'");
  source->ClearParameters();
  source->SetParameter("gain", std::numeric_limits<double>::quiet_NaN());
  expect("'gain' is nan");
  source->ClearParameters();
  for (int wrong : { 0, -5, MesoPatternMaximumSize + 1 })
  {
    source->SetSize(8, wrong);
    expect("size 8 x " + std::to_string(wrong));
  }
  source->SetSize(8, 8);
  recorder.Clear();
  source->Update();
  EXPECT_TRUE(recorder.Errors.empty());
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 64);
}

TEST(PatternSourceTime, ChangesWithValuesOnly)
{
  vtkNew<vtkMesoPatternSource> source;
  source->SetParameter("rows", 6.);
  const vtkMTimeType time = source->GetMTime();
  source->SetPattern("brick");
  source->SetSize(256, 256);
  source->SetSeed(1);
  source->SetParameter("rows", 6.);
  EXPECT_EQ(source->GetMTime(), time);
  source->SetParameter("rows", 4.);
  EXPECT_GT(source->GetMTime(), time);
}

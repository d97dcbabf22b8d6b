// Normals of height maps, and what every filter over a whole height map refuses.

#include "ErrorRecorder.h"
#include "vtkMesoNormalMap.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
vtkSmartPointer<vtkImageData> MakeMap(
  int width, int height, const std::function<double(double, double)>& heightAt)
{
  vtkNew<vtkFloatArray> heights;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      heights->InsertNextValue(
        static_cast<float>(heightAt((column + 0.5) / width, (row + 0.5) / height)));
    }
  }
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->SetDimensions(width, height, 1);
  map->GetPointData()->SetScalars(heights);
  return map;
}

std::array<double, 3> NormalAt(vtkMesoNormalMap* filter, int column, int row)
{
  vtkImageData* output = filter->GetOutput();
  std::array<double, 3> normal;
  output->GetPointData()->GetScalars("Normal")->GetTuple(
    vtkIdType(row) * output->GetDimensions()[0] + column, normal.data());
  return normal;
}

std::string Refusal(vtkImageData* map)
{
  vtkNew<vtkMesoNormalMap> filter;
  ErrorRecorder recorder;
  recorder.Watch(filter);
  filter->SetInputData(map);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(recorder.Errors.size(), 1u);
  return recorder.Errors.empty() ? "" : recorder.Errors.front();
}
}

TEST(NormalMap, OfAWaveIsTheClosedForm)
{
  // h = 1/2 + 1/4 cos(2 pi u) + 1/4 sin(4 pi v) over a tile of 2 x 0.5, 0.3 deep.
  const double pi = vtkMath::Pi();
  const int size = 256;
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(MakeMap(size, size / 2,
    [&](double u, double v)
    { return 0.5 + 0.25 * std::cos(2. * pi * u) + 0.25 * std::sin(4. * pi * v); }));
  filter->SetScale(0.3);
  filter->SetTileSize(2., 0.5);
  filter->Update();
  double largest = 0.;
  for (int row = 0; row < size / 2; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double u = (column + 0.5) / size;
      const double v = (row + 0.5) / (size / 2);
      double expected[3] = { 0.3 / 2. * 0.5 * pi * std::sin(2. * pi * u),
        -0.3 / 0.5 * pi * std::cos(4. * pi * v), 1. };
      vtkMath::Normalize(expected);
      const auto normal = NormalAt(filter, column, row);
      largest = std::max(largest, std::acos(std::min(1., vtkMath::Dot(expected, normal.data()))));
    }
  }
  // A central difference is low by the part (2 pi k / n)^2 / 6 of the slope: 1.6e-3 for 2 waves
  // over 128 texels, which turns a slope of about 1 by half of it.
  EXPECT_LT(largest, 1e-3);
  EXPECT_GT(largest, 1e-5);
}

TEST(NormalMap, LooksBeyondTheBorderAsWrapSays)
{
  // A ramp from 0 to 1 along u: at its left border repeat sees a cliff, clamp half of the slope.
  const auto ramp = MakeMap(16, 4, [](double u, double) { return u; });
  const auto slopeAtBorder = [&](MesoWrap wrap)
  {
    vtkNew<vtkMesoNormalMap> filter;
    filter->SetInputData(ramp);
    filter->SetScale(1.);
    filter->SetWrap(wrap);
    filter->Update();
    EXPECT_NEAR(NormalAt(filter, 8, 1)[0] / NormalAt(filter, 8, 1)[2], -1., 1e-5);
    EXPECT_NEAR(NormalAt(filter, 8, 1)[1], 0., 1e-6);
    const auto normal = NormalAt(filter, 0, 1);
    return -normal[0] / normal[2];
  };
  EXPECT_NEAR(slopeAtBorder(MesoWrap::Repeat), 0.5 * (1.5 - 15.5), 1e-4);
  EXPECT_NEAR(slopeAtBorder(MesoWrap::Clamp), 0.5, 1e-5);
  EXPECT_NEAR(slopeAtBorder(MesoWrap::Mirror), 0.5, 1e-5);
}

TEST(NormalMap, OfAFlatMapOrWithoutDepthPointsStraightUp)
{
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(MakeMap(1, 1, [](double, double) { return 0.7; }));
  filter->Update();
  EXPECT_EQ(NormalAt(filter, 0, 0), (std::array<double, 3>{ 0., 0., 1. }));
  filter->SetInputData(MakeMap(3, 5, [](double u, double v) { return u * v; }));
  filter->SetScale(0.);
  filter->Update();
  EXPECT_EQ(NormalAt(filter, 2, 3), (std::array<double, 3>{ 0., 0., 1. }));
}

TEST(HeightMapAlgorithm, RefusesWhatIsNoHeightMap)
{
  vtkNew<vtkImageData> empty;
  EXPECT_NE(Refusal(empty).find("no height map"), std::string::npos);
  vtkNew<vtkImageData> bytes;
  bytes->SetDimensions(2, 2, 1);
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  EXPECT_NE(Refusal(bytes).find("no height map"), std::string::npos);
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_NE(Refusal(volume).find("no height map"), std::string::npos);
  for (const double wrong : { 1.5, -0.1, std::numeric_limits<double>::quiet_NaN() })
  {
    const auto map =
      MakeMap(4, 3, [&](double u, double v) { return u > 0.5 && v > 0.7 ? wrong : 0.5; });
    EXPECT_NE(Refusal(map).find("texel (2, 2)"), std::string::npos);
  }
}

TEST(HeightMapAlgorithm, CanBeAborted)
{
  vtkNew<vtkMesoNormalMap> filter;
  filter->SetInputData(MakeMap(4, 400, [](double, double) { return 0.5; }));
  int reports = 0;
  struct Counter
  {
    vtkMesoNormalMap* Filter;
    int* Reports;
    void Stop(vtkObject*, unsigned long, void*)
    {
      if (++*this->Reports == 3)
      {
        this->Filter->AbortExecuteOn();
      }
    }
  } counter = { filter, &reports };
  filter->AddObserver(vtkCommand::ProgressEvent, &counter, &Counter::Stop);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(reports, 10);
}

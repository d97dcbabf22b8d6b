// Distances to the surface between samples, against closed forms and against brute force.

#include "ErrorRecorder.h"
#include "MesoVolume.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoSignedDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using Function = std::function<double(double, double, double)>;

/// An image of a function of (x, y, z) in tile widths, over a tile of depth `depth`.
vtkSmartPointer<vtkImageData> Sampled(
  std::array<int, 3> size, double depth, const Function& function)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetSpacing(1. / size[0], 1. / size[1], depth / size[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* target = static_cast<float*>(image->GetScalarPointer());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        *target++ = static_cast<float>(
          function((i + 0.5) / size[0], (j + 0.5) / size[1], (k + 0.5) / size[2] * depth));
      }
    }
  }
  return image;
}

MesoVolumeField Distances(vtkImageData* image, double threshold = 0.)
{
  vtkNew<vtkMesoSignedDistance> filter;
  filter->SetInputData(image);
  filter->SetThreshold(threshold);
  filter->Update();
  EXPECT_EQ(MesoVolumeProblem(filter->GetOutput()), "");
  return MesoVolumeField(filter->GetOutput());
}

/// The largest difference from a function, in voxels along x.
double WorstError(const MesoVolumeField& field, const Function& truth)
{
  const auto& size = field.GetSize();
  double worst = 0.;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double distance =
          truth((i + 0.5) / size[0], (j + 0.5) / size[1], (k + 0.5) / size[2] * field.GetDepth());
        worst = std::max(worst, std::abs(distance - field.Sample(i, j, k)) * size[0]);
      }
    }
  }
  return worst;
}

double ToCentre(double x, double y, double z)
{
  return std::hypot(std::hypot(x - 0.5, y - 0.5), z - 0.25);
}
}

TEST(SignedDistance, OfASphereIsRightToAFewHundredthsOfAVoxel)
{
  // Squares of distances, so that the input is no distance itself. The voxels are no cubes.
  const auto image = Sampled({ 40, 40, 24 }, 0.5,
    [](double x, double y, double z) { return 0.04 - std::pow(ToCentre(x, y, z), 2.); });
  const double worst = WorstError(
    Distances(image), [](double x, double y, double z) { return ToCentre(x, y, z) - 0.2; });
  EXPECT_LT(worst, 0.05);
}

TEST(SignedDistance, OfATiltedPlaneIsExactWherePlanesAreNearest)
{
  // Two planes a tile, since it repeats: |x - 1/2| = 1/8 + z/4.
  const double slope = 0.25;
  const double length = std::hypot(1., slope);
  const auto truth = [=](double x, double, double z)
  { return (std::abs(x - 0.5) - 0.125 - slope * z) / length; };
  const auto image =
    Sampled({ 64, 4, 32 }, 0.5, [&](double x, double y, double z) { return -3. * truth(x, y, z); });
  const MesoVolumeField field = Distances(image);
  for (int k = 8; k < 24; ++k)
  {
    for (int i = 36; i < 60; ++i) // away from the edges where both planes are as near
    {
      const double distance = truth((i + 0.5) / 64., 0., (k + 0.5) / 64.);
      EXPECT_NEAR(field.Sample(i, 1, k), distance, 0.01 / 64.) << i << " " << k;
    }
  }
}

TEST(SignedDistance, SeesTheSurfaceOfTheNextTile)
{
  const auto truth = [](double x, double y, double z)
  {
    double nearest = 9.;
    for (int tile = 0; tile < 9; ++tile)
    {
      nearest = std::min(nearest,
        std::hypot(std::hypot(x - 0.05 + tile % 3 - 1, y - 0.95 + tile / 3 - 1), z - 0.25) - 0.15);
    }
    return nearest;
  };
  const auto image =
    Sampled({ 32, 32, 16 }, 0.5, [&](double x, double y, double z) { return -truth(x, y, z); });
  EXPECT_LT(WorstError(Distances(image), truth), 0.08);
}

TEST(SignedDistance, OfGreyValuesPlacesTheSurfaceBetweenSamples)
{
  // Voxels hold how much of them is solid: below z = 0.3.
  const auto image = Sampled({ 8, 8, 16 }, 0.5,
    [](double, double, double z) { return std::clamp(0.5 + (0.3 - z) * 32., 0., 1.) * 255.; });
  const MesoVolumeField field = Distances(image, 127.5);
  for (int k = 0; k < 16; ++k)
  {
    EXPECT_NEAR(field.Sample(3, 3, k), (k + 0.5) / 32. - 0.3, 0.1 / 32.) << k;
  }
}

TEST(SignedDistance, WithoutASurfaceIsOneAndTheDepth)
{
  for (const double number : { 0., 1. })
  {
    const auto image = Sampled({ 4, 4, 4 }, 0.25, [=](double, double, double) { return number; });
    const MesoVolumeField field = Distances(image, 0.5);
    for (const float distance : field.GetValues())
    {
      EXPECT_EQ(distance, number > 0.5 ? -1.25f : 1.25f);
    }
  }
}

TEST(SignedDistance, TakesTheThresholdItselfForSolidAndCanTurnTheSides)
{
  const auto image =
    Sampled({ 4, 4, 4 }, 0.25, [](double, double, double z) { return z < 0.125 ? 1. : 0.; });
  vtkNew<vtkMesoSignedDistance> filter;
  filter->SetInputData(image);
  filter->SetThreshold(1.);
  filter->SetDepth(2.);
  filter->Update();
  const MesoVolumeField field(filter->GetOutput());
  EXPECT_EQ(field.GetDepth(), 2.);
  EXPECT_LT(field.Sample(0, 0, 0), 0.);
  EXPECT_GT(field.Sample(0, 0, 3), 0.);
  filter->SetThreshold(0.5);
  filter->SolidBelowOn();
  filter->Update();
  EXPECT_GT(MesoVolumeField(filter->GetOutput()).Sample(0, 0, 0), 0.);
}

TEST(SignedDistance, RefusesWhatIsNoVolume)
{
  const auto image =
    Sampled({ 4, 4, 4 }, 0.25, [](double x, double, double) { return x > 0.7 ? NAN : 1.; });
  vtkNew<vtkMesoSignedDistance> filter;
  ErrorRecorder errors;
  errors.Watch(filter);
  filter->SetInputData(image);
  filter->Update();
  ASSERT_EQ(errors.Errors.size(), 1u);
  EXPECT_NE(errors.Errors[0].find("finite"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// The table of distances through a volume: against rays followed by brute force, and its factors.

#include "ErrorRecorder.h"
#include "MesoGDMShape.h"
#include "MesoGDMSweep.h"
#include "MesoKernels.h"
#include "MesoVolume.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGDMTable.h"
#include "vtkMesoVolumeSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using Vector = MesoVolumeField::Vector;
constexpr double Reach = 3.;

/// Samples of a function of texture space.
MesoVolumeField Field(std::array<int, 3> size, double depth,
  const std::function<double(double, double, double)>& function)
{
  std::vector<float> values;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        values.push_back(static_cast<float>(
          function((i + 0.5) / size[0], (j + 0.5) / size[1], (k + 0.5) / size[2])));
      }
    }
  }
  return MesoVolumeField(size, depth, values);
}

MesoVolumeField Pattern(const char* name, std::array<int, 3> size)
{
  vtkNew<vtkMesoVolumeSource> source;
  source->SetPattern(name);
  source->SetSize(size.data());
  source->Update();
  return MesoVolumeField(source->GetOutput());
}

Vector PointAt(const MesoVolumeField& field, int i, int j, int k)
{
  const auto& size = field.GetSize();
  return { (i + 0.5) / size[0], (j + 0.5) / size[1], double(k) / (size[2] - 1) };
}

/// The distance by steps of a thousandth of a tile: no method but patience.
double Marched(const MesoVolumeField& field, const Vector& origin, const Vector& direction)
{
  constexpr double step = 1e-3;
  const double end =
    std::min(Reach, MesoVolumeRay::ToPlane(origin[2], direction[2], field.GetDepth()));
  for (double t = 0.; t < end; t += step)
  {
    const Vector place = { origin[0] + t * direction[0], origin[1] + t * direction[1],
      origin[2] + t * direction[2] / field.GetDepth() };
    if (field.At(place) < 0.)
    {
      return t;
    }
  }
  return end;
}

double ToSphere(double x, double y, double z)
{
  return std::hypot(std::hypot(x - 0.5, y - 0.5), 0.5 * (z - 0.5)) - 0.2;
}

vtkSmartPointer<vtkImageData> Volume(const char* pattern, std::array<int, 3> size)
{
  vtkNew<vtkMesoVolumeSource> source;
  source->SetPattern(pattern);
  source->SetSize(size.data());
  source->Update();
  return source->GetOutput();
}
}

TEST(VolumeRay, MeetsWhatSmallStepsMeet)
{
  const MesoVolumeField field = Pattern("weave", { 16, 16, 8 });
  const MesoVolumeRay ray(field);
  const MesoGDMDirections directions = { 5, 9, false };
  int hits = 0;
  for (int a = 0; a < directions.Azimuths; ++a)
  {
    for (int t = 0; t < directions.Polars; ++t)
    {
      const Vector direction = directions.At(a, t);
      for (const Vector& origin : { Vector{ 0.13, 0.77, 0. }, Vector{ 0.4, 0.2, 1. },
             Vector{ 0.5, 0.5, 0.97 }, Vector{ 0.999, 0., 0.03 } })
      {
        const auto hit = ray.Cast(origin, direction, Reach);
        // A step of a thousandth may pass what the ray grazes, but never stops before it.
        const double marched = Marched(field, origin, direction);
        EXPECT_LE(hit.Distance, marched + 1e-9) << a << " " << t;
        const Vector place = { origin[0] + hit.Distance * direction[0],
          origin[1] + hit.Distance * direction[1],
          origin[2] + hit.Distance * direction[2] / field.GetDepth() };
        if (hit.IsHit && hit.Distance > 0.)
        {
          ++hits;
          EXPECT_NEAR(field.At(place), 0., 1e-7) << a << " " << t;
        }
        EXPECT_NEAR(hit.Distance, marched, 2e-2) << a << " " << t;
      }
    }
  }
  EXPECT_GT(hits, 30);
}

TEST(GDMSweep, AgreesWithRaysFollowedOneByOne)
{
  for (const char* pattern : { "weave", "grid", "foam" })
  {
    const MesoVolumeField field = Pattern(pattern, { 16, 16, 8 });
    const MesoGDMSweep sweep(field, Reach);
    const MesoGDMDirections directions = { 7, 12, false };
    double squares = 0.;
    int off = 0;
    int count = 0;
    for (int a = 0; a < directions.Azimuths; ++a)
    {
      for (int t = 0; t < directions.Polars; ++t)
      {
        const Vector direction = directions.At(a, t);
        std::vector<float> swept(16 * 16 * 8, -1.f);
        std::vector<float> cast = swept;
        sweep.Sweep(direction, swept.data(), 8);
        sweep.Cast(direction, cast.data(), 8);
        for (std::size_t i = 0; i < swept.size(); ++i, ++count)
        {
          const double error = std::abs(swept[i] - cast[i]);
          squares += error * error;
          off += error > 1. / 16.; // a voxel
        }
      }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.18 / 16.) << pattern;
    EXPECT_LT(off, 0.01 * count) << pattern;
  }
}

TEST(GDMSweep, IsBruteForceOnATinyVolume)
{
  const MesoVolumeField field = Field({ 6, 5, 4 }, 0.5, ToSphere);
  const MesoGDMSweep sweep(field, Reach);
  const MesoGDMDirections directions = { 6, 7, false };
  for (int a = 0; a < directions.Azimuths; ++a)
  {
    for (int t = 0; t < directions.Polars; ++t)
    {
      const Vector direction = directions.At(a, t);
      std::vector<float> cast(6 * 5 * 4);
      sweep.Cast(direction, cast.data(), 4);
      for (int j = 0; j < 5; ++j)
      {
        for (int i = 0; i < 6; ++i)
        {
          for (int k = 0; k < 4; ++k)
          {
            const double marched = Marched(field, PointAt(field, i, j, k), direction);
            EXPECT_NEAR(cast[(j * 6 + i) * 4 + k], marched, 5e-3) << i << " " << j << " " << k;
          }
        }
      }
    }
  }
}

TEST(GDMSweep, OfNothingIsTheDistanceToThePlaneThatTheRayLeavesThrough)
{
  const MesoVolumeField field = Field({ 4, 4, 3 }, 0.5, [](double, double, double) { return 1.; });
  const MesoGDMSweep sweep(field, Reach);
  const MesoGDMDirections directions = { 8, 9, false };
  for (int a = 0; a < 8; ++a)
  {
    for (int t = 0; t < 9; ++t)
    {
      const Vector direction = directions.At(a, t);
      std::vector<float> swept(4 * 4 * 3);
      EXPECT_EQ(sweep.Sweep(direction, swept.data(), 3), 0u);
      for (int k = 0; k < 3; ++k)
      {
        const double height = direction[2] > 0. ? 0.25 * (2 - k) : 0.25 * k;
        const double distance =
          direction[2] == 0. ? Reach : std::min(Reach, height / std::abs(direction[2]));
        for (int column = 0; column < 16; ++column)
        {
          EXPECT_NEAR(swept[column * 3 + k], distance, 1e-5) << a << " " << t << " " << k;
        }
      }
    }
  }
}

TEST(GDMSweep, OfSolidIsNothingEverywhere)
{
  const MesoVolumeField field = Field({ 4, 4, 3 }, 0.5, [](double, double, double) { return -1.; });
  const MesoGDMSweep sweep(field, Reach);
  std::vector<float> swept(4 * 4 * 3, 7.f);
  for (const Vector& direction :
    { Vector{ 0., 0., 1. }, Vector{ 0.6, 0., -0.8 }, Vector{ 1., 0., 0. } })
  {
    sweep.Sweep(direction, swept.data(), 3);
    EXPECT_EQ(*std::max_element(swept.begin(), swept.end()), 0.f);
  }
}

TEST(GDMSweep, SeesOneVoxelOfTheNextTiles)
{
  // One sample of 8 x 8 x 5 is solid, and it is seen from each side, over the border as well.
  std::vector<float> values(8 * 8 * 5, 1.f);
  values[(2 * 8 + 1) * 8 + 6] = -1.f;
  const MesoVolumeField field({ 8, 8, 5 }, 0.5, values);
  const MesoGDMSweep sweep(field, Reach);
  std::vector<float> swept(8 * 8 * 5);
  const auto at = [&](int i, int j, int k) { return swept[(j * 8 + i) * 5 + k]; };
  sweep.Sweep({ 1., 0., 0. }, swept.data(), 5);
  EXPECT_NEAR(at(2, 1, 2), 3.5 / 8., 1e-4); // the surface is halfway to the sample
  EXPECT_NEAR(at(7, 1, 2), 6.5 / 8., 1e-4); // over the border
  EXPECT_EQ(at(2, 4, 2), static_cast<float>(Reach));
  EXPECT_EQ(at(6, 1, 2), 0.f);
  sweep.Sweep({ 0., -1., 0. }, swept.data(), 5);
  EXPECT_NEAR(at(6, 0, 2), 6.5 / 8., 1e-4);
  sweep.Sweep({ 0., 0., -1. }, swept.data(), 5);
  EXPECT_NEAR(at(6, 1, 4), 0.5 - (2.5 / 5. * 0.5 + 0.05), 1e-4);
  EXPECT_NEAR(at(5, 1, 4), 0.5, 1e-6);
}

TEST(GDMSweep, TellsHitsFromPlanesByTheVolumeAtTheEnd)
{
  const MesoVolumeField field = Pattern("grid", { 16, 16, 8 });
  const MesoGDMSweep sweep(field, Reach);
  const MesoVolumeRay ray(field);
  const Vector direction = MesoGDMDirections{ 16, 32, false }.At(3, 20);
  std::vector<float> exact(16 * 16 * 8);
  sweep.Cast(direction, exact.data(), 8);
  int hits = 0;
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      for (int k = 0; k < 8; ++k)
      {
        const Vector origin = PointAt(field, i, j, k);
        const double d = exact[(j * 16 + i) * 8 + k];
        const double there = field.At({ origin[0] + d * direction[0], origin[1] + d * direction[1],
          origin[2] + d * direction[2] / field.GetDepth() });
        const bool isHit = ray.Cast(origin, direction, Reach).IsHit;
        EXPECT_EQ(there < 1e-4, isHit) << i << " " << j << " " << k;
        hits += isHit;
      }
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 1948);
}

TEST(GDMTable, LeavesLessWithEachProductAndNothingWithAll)
{
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(Volume("foam", { 8, 8, 4 }));
  table->SetAzimuths(6);
  table->SetPolars(8);
  table->SetRank(32); // as many as there are columns
  table->SetBits(32);
  table->Update();
  ASSERT_EQ(MesoGDMTableProblem(table->GetOutput()), "");
  const auto& errors = table->GetFactorErrors();
  ASSERT_EQ(errors.size(), 32u);
  for (std::size_t rank = 1; rank < errors.size(); ++rank)
  {
    EXPECT_LE(errors[rank], errors[rank - 1]);
  }
  EXPECT_GT(errors[0], 0.005);
  EXPECT_LT(errors[31], 1e-5);

  vtkNew<vtkMesoGDMTable> whole;
  whole->SetInputData(table->GetInputDataObject(0, 0));
  whole->SetAzimuths(6);
  whole->SetPolars(8);
  whole->SetRank(0);
  whole->SetBits(32);
  whole->Update();
  ASSERT_EQ(MesoGDMTableProblem(whole->GetOutput()), "");
  vtkDataArray* distances = whole->GetOutput()->GetPointData()->GetArray("MesoGDMDistances");
  vtkDataArray* weights = table->GetOutput()->GetPointData()->GetArray("MesoGDMWeights");
  vtkDataArray* functions = table->GetOutput()->GetFieldData()->GetArray("MesoGDMFunctions");
  for (vtkIdType row = 0; row < weights->GetNumberOfTuples(); row += 7)
  {
    for (int column = 0; column < 32; ++column)
    {
      double sum = 0.;
      for (int r = 0; r < 32; ++r)
      {
        sum += weights->GetComponent(row, r) * functions->GetComponent(column, r);
      }
      EXPECT_NEAR(sum, distances->GetComponent(row, column), 1e-4);
    }
  }
}

TEST(GDMTable, KeepsWeightsInWholeNumbersToTheirStep)
{
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(Volume("chain", { 8, 8, 4 }));
  table->SetAzimuths(4);
  table->SetPolars(6);
  table->SetRank(5);
  table->SetBits(32);
  table->Update();
  vtkNew<vtkImageData> floats;
  floats->DeepCopy(table->GetOutput());
  for (const int bits : { 8, 16 })
  {
    table->SetBits(bits);
    table->Update();
    ASSERT_EQ(MesoGDMTableProblem(table->GetOutput()), "");
    const double steps = std::exp2(bits) - 1.;
    vtkDataArray* range = table->GetOutput()->GetFieldData()->GetArray("MesoGDMWeightRange");
    vtkDataArray* whole = table->GetOutput()->GetPointData()->GetScalars();
    vtkDataArray* exact = floats->GetPointData()->GetScalars();
    for (int r = 0; r < 5; ++r)
    {
      const double least = range->GetComponent(0, r);
      const double span = range->GetComponent(1, r) - least;
      for (vtkIdType row = 0; row < whole->GetNumberOfTuples(); ++row)
      {
        EXPECT_NEAR(least + span * whole->GetComponent(row, r) / steps, exact->GetComponent(row, r),
          0.51 * span / steps);
      }
    }
  }
}

TEST(GDMTable, OfEmptyAndOfSolidVolumesIsRight)
{
  for (const float number : { 1.f, -1.f })
  {
    vtkNew<vtkMesoGDMTable> table;
    table->SetInputData(MesoMakeVolume({ 4, 4, 3 }, 0.5, std::vector<float>(48, number)));
    table->SetAzimuths(4);
    table->SetPolars(5);
    table->SetRank(4);
    table->Update();
    ASSERT_EQ(MesoGDMTableProblem(table->GetOutput()), "");
    EXPECT_LT(table->GetFactorErrors().back(), 1e-5); // a constant of each column
    double range[2];
    table->GetOutput()->GetFieldData()->GetArray("MesoGDMFunctions")->GetFiniteRange(range, -1);
    EXPECT_TRUE(std::isfinite(range[1]));
  }
}

TEST(GDMTable, IsTheSameOnAnyNumberOfThreads)
{
  const auto volume = Volume("foam", { 8, 8, 4 });
  const auto make = [&]()
  {
    vtkNew<vtkMesoGDMTable> table;
    table->SetInputData(volume);
    table->SetAzimuths(4);
    table->SetPolars(6);
    table->SetRank(4);
    table->Update();
    vtkDataArray* weights = table->GetOutput()->GetPointData()->GetScalars();
    const auto* first = static_cast<const unsigned short*>(weights->GetVoidPointer(0));
    return std::vector<unsigned short>(first, first + weights->GetNumberOfValues());
  };
  const auto all = make();
  std::vector<unsigned short> one;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&]() { one = make(); });
  EXPECT_EQ(all, one);
}

TEST(GDMTable, DirectionsAreEvenOverTheSphereWhereAsked)
{
  const MesoGDMDirections even = { 4, 5, true };
  EXPECT_NEAR(even.At(0, 1)[2], 0.5, 1e-12);
  EXPECT_EQ(even.At(0, 2)[2], 0.);
  EXPECT_EQ(even.At(2, 4)[2], -1.);
  const MesoGDMDirections angles = { 4, 5, false };
  EXPECT_NEAR(angles.At(0, 1)[2], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(angles.At(1, 2)[1], 1., 1e-12);
  EXPECT_EQ(angles.At(1, 2)[0], 0.);
}

TEST(GDMTable, RefusesWhatIsNoVolumeAndStopsWhenAsked)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_FLOAT, 1);
  vtkNew<vtkMesoGDMTable> table;
  ErrorRecorder errors;
  errors.Watch(table);
  table->SetInputData(image);
  table->Update();
  ASSERT_EQ(errors.Errors.size(), 1u);
  EXPECT_NE(errors.Errors[0].find("MesoSignedDistance"), std::string::npos);
  EXPECT_NE(MesoGDMTableProblem(table->GetOutput()), "");
  EXPECT_NE(MesoGDMTableProblem(nullptr), "");

  table->SetInputData(MesoMakeVolume({ 1, 4, 4 }, 0.5, std::vector<float>(16, 1.f)));
  table->Update();
  ASSERT_EQ(errors.Errors.size(), 2u);
  EXPECT_NE(errors.Errors[1].find("2 x 2 x 2"), std::string::npos);
}

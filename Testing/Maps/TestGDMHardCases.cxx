// Tables of the smallest volumes, of all of them; and tables that are damaged.

#include "MesoGDMShape.h"
#include "MesoGDMSweep.h"
#include "MesoKernels.h"
#include "MesoVolume.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGDMTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
using Vector = MesoVolumeField::Vector;
constexpr double Reach = 1.5;

/// 2 x 2 x 2 samples, each solid (-1) or empty (1) as the bits of a number say.
MesoVolumeField Corners(int bits)
{
  std::vector<float> values;
  for (int i = 0; i < 8; ++i)
  {
    values.push_back((bits >> i) & 1 ? -1.f : 1.f);
  }
  return { { 2, 2, 2 }, 0.5, values };
}

Vector Place(const MesoVolumeField& field, const Vector& origin, const Vector& direction, double t)
{
  return { origin[0] + t * direction[0], origin[1] + t * direction[1],
    origin[2] + t * direction[2] / field.GetDepth() };
}

/// By steps of a thousandth of a tile and a bisection of the step that comes into the solid.
double BruteForce(const MesoVolumeField& field, const Vector& origin, const Vector& direction)
{
  const double end =
    std::min(Reach, MesoVolumeRay::ToPlane(origin[2], direction[2], field.GetDepth()));
  constexpr double step = 1e-3;
  const auto isSolid = [&](double t) { return field.At(Place(field, origin, direction, t)) < 0.; };
  if (isSolid(0.))
  {
    return 0.;
  }
  for (double t = step; t < end + step; t += step)
  {
    double high = std::min(t, end);
    if (isSolid(high))
    {
      double low = t - step;
      for (int i = 0; i < 40; ++i)
      {
        const double middle = 0.5 * (low + high);
        (isSolid(middle) ? high : low) = middle;
      }
      return high;
    }
  }
  return end;
}

vtkSmartPointer<vtkImageData> Table(int rank, int bits)
{
  std::vector<float> values(4 * 4 * 3, 0.3f);
  values[21] = -0.2f;
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(MesoMakeVolume({ 4, 4, 3 }, 0.5, values));
  table->SetAzimuths(4);
  table->SetPolars(5);
  table->SetRank(rank);
  table->SetBits(bits);
  table->Update();
  return table->GetOutput();
}

/// Why a table is refused after a change.
std::string AfterChange(
  int rank, int bits, const std::function<void(vtkImageData*, vtkFieldData*)>& change)
{
  const auto table = Table(rank, bits);
  EXPECT_EQ(MesoGDMTableProblem(table), "");
  change(table, table->GetFieldData());
  return MesoGDMTableProblem(table);
}
}

TEST(GDMHardCases, EveryVolumeOfEightSamplesIsBruteForce)
{
  const MesoGDMDirections directions = { 5, 6, false };
  int off = 0;
  int all = 0;
  for (int bits = 0; bits < 256; ++bits)
  {
    const MesoVolumeField field = Corners(bits);
    const MesoGDMSweep sweep(field, Reach);
    const Vector direction = directions.At(bits % 5, bits / 5 % 6);
    std::vector<float> cast(8);
    std::vector<float> swept(8);
    sweep.Cast(direction, cast.data(), 2);
    sweep.Sweep(direction, swept.data(), 2);
    for (int point = 0; point < 8; ++point)
    {
      const int i = point / 2 % 2;
      const int j = point / 4;
      const Vector origin = { (i + 0.5) / 2., (j + 0.5) / 2., double(point % 2) };
      const double brute = BruteForce(field, origin, direction);
      // What a step passes is grazed, and no deeper than it is long.
      EXPECT_LE(cast[point], brute + 1e-6) << bits << " " << point;
      EXPECT_NEAR(cast[point], brute, 0.05) << bits << " " << point;
      EXPECT_TRUE(swept[point] >= 0.f && swept[point] <= static_cast<float>(Reach));
      ++all;
      off += std::abs(swept[point] - brute) > 0.5; // a voxel
    }
  }
  // Lines two samples long pass corners between their planes, as the page says; few of them.
  EXPECT_LT(off, all / 50);
}

TEST(GDMHardCases, FarAndTinyNumbersDoNoHarm)
{
  // Numbers that no distance has: what counts is where they change their sign.
  for (const float scale : { 1e-38f, 1e-20f, 1e20f, 1e37f })
  {
    const auto valuesOf = [](float unit)
    {
      std::vector<float> values(8 * 8 * 4, unit);
      values[100] = -unit;
      values[141] = -unit;
      return values;
    };
    const MesoVolumeField field({ 8, 8, 4 }, 0.5, valuesOf(scale));
    const MesoVolumeField unit({ 8, 8, 4 }, 0.5, valuesOf(1.f));
    const MesoGDMDirections directions = { 3, 5, false };
    for (int polar = 0; polar < 5; ++polar)
    {
      std::vector<float> found(8 * 8 * 4);
      std::vector<float> expected(8 * 8 * 4);
      MesoGDMSweep(field, Reach).Sweep(directions.At(1, polar), found.data(), 4);
      MesoGDMSweep(unit, Reach).Sweep(directions.At(1, polar), expected.data(), 4);
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i], expected[i], 1e-3) << scale << " " << polar << " " << i;
      }
    }
  }
}

TEST(GDMHardCases, ConstantTablesHaveProductsOfNothing)
{
  // Everything is solid: all singular values are 0.
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(MesoMakeVolume({ 4, 4, 3 }, 0.5, std::vector<float>(48, -1.f)));
  table->SetAzimuths(4);
  table->SetPolars(5);
  table->SetRank(16); // more than its 15 columns
  for (const int bits : { 8, 16, 32 })
  {
    table->SetBits(bits);
    table->Update();
    ASSERT_EQ(MesoGDMTableProblem(table->GetOutput()), "") << bits;
    double range[2];
    table->GetOutput()->GetFieldData()->GetArray("MesoGDMWeightRange")->GetRange(range, -1);
    EXPECT_NEAR(range[1], bits == 32 ? std::sqrt(16.) : 0., bits == 32 ? 5. : 1e-6) << bits;
    EXPECT_LT(table->GetFactorErrors().back(), 1e-9);
  }
}

TEST(GDMHardCases, DamagedTablesAreRefused)
{
  for (const int rank : { 3, 0 })
  {
    for (const char* name : { "MesoGDMShape", "MesoVolumeDepth", "MesoGDMVolume" })
    {
      EXPECT_NE(
        AfterChange(rank, 16, [&](vtkImageData*, vtkFieldData* data) { data->RemoveArray(name); }),
        "")
        << rank << " without " << name;
    }
    for (int number = 0; number < 8; ++number)
    {
      for (const double wrong : { -1., 0.5, 7., 1e300, std::nan("") })
      {
        if ((number == 5 && wrong != -1. && wrong != 1e300 && !std::isnan(wrong)) ||
          (number == 6 && (wrong == 0.5 || wrong == 7.)) ||
          (number == 7 && rank == 0 && wrong == 0.5))
        {
          continue; // which is another table's, and no damage
        }
        EXPECT_NE(AfterChange(rank, 16,
                    [&](vtkImageData*, vtkFieldData* data)
                    { data->GetArray("MesoGDMShape")->SetTuple1(number, wrong); }),
          "")
          << rank << ": number " << number << " of the shape is " << wrong;
      }
    }
    EXPECT_NE(AfterChange(rank, 16,
                [](vtkImageData*, vtkFieldData* data)
                { data->GetArray("MesoVolumeDepth")->SetTuple1(0, 0.); }),
      "");
    EXPECT_NE(AfterChange(rank, 16,
                [](vtkImageData* table, vtkFieldData*) { table->GetPointData()->Initialize(); }),
      "");
    EXPECT_NE(AfterChange(rank, 32,
                [](vtkImageData* table, vtkFieldData*)
                {
                  table->GetPointData()->GetScalars()->SetComponent(
                    5, 1, std::numeric_limits<double>::quiet_NaN());
                }),
      "")
      << rank;
  }
  for (const char* name : { "MesoGDMFunctions", "MesoGDMWeightRange" })
  {
    EXPECT_NE(
      AfterChange(3, 16, [&](vtkImageData*, vtkFieldData* data) { data->RemoveArray(name); }), "");
    EXPECT_NE(AfterChange(3, 16,
                [&](vtkImageData*, vtkFieldData* data) {
                  data->GetArray(name)->SetComponent(1, 2, std::numeric_limits<double>::infinity());
                }),
      "")
      << name;
  }
}

TEST(GDMHardCases, LookUpsAreFiniteInEveryDirection)
{
  const auto table = Table(0, 32);
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  vtkDataArray* scalars = table->GetPointData()->GetScalars();
  std::vector<float> numbers;
  for (vtkIdType row = 0; row < scalars->GetNumberOfTuples(); ++row)
  {
    for (int c = 0; c < scalars->GetNumberOfComponents(); ++c)
    {
      numbers.push_back(static_cast<float>(scalars->GetComponent(row, c)));
    }
  }
  const MesoKernels::Float::GDMWhole kernel({ shape.Size[0], shape.Size[1], shape.Size[2] },
    { shape.Azimuths, shape.Polars }, shape.Even, 0, numbers, {});
  const float tiny = 1e-30f;
  for (const glm::vec3& direction : { glm::vec3(0.f, 0.f, 1.f), glm::vec3(0.f, 0.f, -1.f),
         glm::vec3(1.f, 0.f, 0.f), glm::vec3(-1.f, -0.f, 0.f), glm::vec3(1.f, -tiny, 0.f),
         glm::vec3(tiny, tiny, 1.f), glm::vec3(-tiny, 0.f, -1.f), glm::vec3(1.f, 0.f, tiny) })
  {
    for (const glm::vec3& place : { glm::vec3(0.f), glm::vec3(1.f), glm::vec3(-3.7f, 12.2f, 0.5f),
           glm::vec3(0.5f, 0.5f, -0.1f), glm::vec3(0.5f, 0.5f, 1.1f) })
    {
      const float d = kernel.gdmDistance(place, direction);
      EXPECT_TRUE(d >= 0.f && d <= 8.f) << direction.x << " " << direction.y << " " << direction.z;
    }
  }
  // Just before phi = 0 is what is at phi = 0.
  EXPECT_NEAR(kernel.gdmDistance({ 0.1f, 0.3f, 0.f }, { 0.8f, -1e-6f, 0.6f }),
    kernel.gdmDistance({ 0.1f, 0.3f, 0.f }, { 0.8f, 0.f, 0.6f }), 1e-4f);
}

TEST(GDMHardCases, CautiousTablesHaveTheNearerHitsBesideAndNothingElse)
{
  // A thin wall in an open shell; every number against those around it.
  std::vector<float> values(16 * 4 * 6);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(std::abs(double(i % 16) - 8.) / 16. - 0.03);
  }
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(MesoMakeVolume({ 16, 4, 6 }, 0.5, values));
  table->SetAzimuths(6);
  table->SetPolars(7);
  table->SetRank(0);
  table->SetBits(32);
  table->SetReach(2.);
  table->Update();
  vtkNew<vtkImageData> own;
  own->DeepCopy(table->GetOutput());
  table->CautiousOn();
  table->Update();
  vtkDataArray* before = own->GetPointData()->GetScalars();
  vtkDataArray* after = table->GetOutput()->GetPointData()->GetScalars();
  const MesoGDMDirections directions = { 6, 7, false };
  const double voxel = 1. / 16.;
  int changed = 0;
  for (int azimuth = 0; azimuth < 6; ++azimuth)
  {
    for (vtkIdType place = 0; place < 16 * 4; ++place)
    {
      for (int polar = 0; polar < 7; ++polar)
      {
        for (int k = 0; k < 6; ++k)
        {
          double nearest = 100.;
          for (int da = -1; da <= 1; ++da)
          {
            for (int beside = std::max(polar - 1, 0); beside <= std::min(polar + 1, 6); ++beside)
            {
              const vtkIdType row = vtkIdType((azimuth + da + 6) % 6) * 64 + place;
              const double d = before->GetComponent(row, beside * 6 + k);
              const double free =
                std::min(2., MesoVolumeRay::ToPlane(k / 5., directions.At(0, beside)[2], 0.5));
              nearest = d < free - 0.1 * voxel ? std::min(nearest, d) : nearest;
            }
          }
          const double was = before->GetComponent(azimuth * 64 + place, polar * 6 + k);
          const double is = after->GetComponent(azimuth * 64 + place, polar * 6 + k);
          EXPECT_NEAR(is, nearest < was - voxel ? nearest : was, 1e-5)
            << azimuth << " " << place << " " << polar << " " << k;
          changed += is != was;
        }
      }
    }
  }
  EXPECT_GT(changed, 500);
  EXPECT_LT(changed, 6 * 64 * 42 / 2);
}

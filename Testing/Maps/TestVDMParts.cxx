// Tables of view-dependent displacements that are baked in two goes, on more threads, and what they say of
// their own errors.

#include "VDMTables.h"
#include "vtkCommand.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace
{
using namespace VDMTables;

/// Azimuths that are kept in memory.
struct Shelf
{
  std::map<int, std::vector<float>> Kept;
  int Found = 0; ///< azimuths whose rays were followed

  vtkMesoVDM::Parts Parts()
  {
    return { [this](int azimuth, float* numbers, std::size_t count)
      {
        const auto kept = this->Kept.find(azimuth);
        if (kept == this->Kept.end())
        {
          return false;
        }
        EXPECT_EQ(kept->second.size(), count);
        std::copy(kept->second.begin(), kept->second.end(), numbers);
        return true;
      },
      [this](int azimuth, const float* numbers, std::size_t count)
      {
        ++this->Found;
        this->Kept[azimuth].assign(numbers, numbers + count);
      } };
  }
};

/// Aborts a filter once it has told a part of its progress.
struct Abort
{
  vtkAlgorithm* Filter;
  double Part;
  void Check(vtkObject*, unsigned long, void* done)
  {
    if (*static_cast<double*>(done) >= this->Part)
    {
      this->Filter->AbortExecuteOn();
    }
  }
};

void Prepare(vtkMesoVDM* filter, Shelf& shelf, int rank)
{
  filter->SetInputData(RandomMap(8, 8));
  filter->SetLayout(SmallLayout(8, 8));
  filter->SetRanks(rank, rank);
  filter->SetParts(shelf.Parts());
}

void ExpectSame(vtkImageData* one, vtkImageData* other)
{
  ASSERT_GT(one->GetPointData()->GetNumberOfArrays(), 0);
  for (int i = 0; i < one->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* a = one->GetPointData()->GetArray(i);
    vtkDataArray* b = other->GetPointData()->GetArray(i);
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                std::size_t(a->GetNumberOfValues()) * a->GetDataTypeSize()),
      0)
      << a->GetName();
  }
  ASSERT_EQ(one->GetFieldData()->GetNumberOfArrays(), other->GetFieldData()->GetNumberOfArrays());
  for (int i = 0; i < one->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* a = one->GetFieldData()->GetArray(i);
    vtkDataArray* b = other->GetFieldData()->GetArray(i);
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << a->GetName();
    for (vtkIdType k = 0; k < a->GetNumberOfValues(); ++k)
    {
      EXPECT_EQ(a->GetVariantValue(k).ToDouble(), b->GetVariantValue(k).ToDouble()) << a->GetName();
    }
  }
}
}

TEST(VDMParts, AStoppedBakeGoesOnFromWhereItWas)
{
  for (const int rank : { 0, 6 })
  {
    Shelf whole;
    vtkNew<vtkMesoVDM> filter;
    Prepare(filter, whole, rank);
    filter->Update();
    EXPECT_EQ(whole.Found, 12);

    Shelf shelf;
    vtkNew<vtkMesoVDM> stopped;
    Prepare(stopped, shelf, rank);
    // Rays are half of the way to factors.
    Abort abort = { stopped, (rank > 0 ? 0.5 : 1.) * 4.9 / 12. };
    stopped->AddObserver(vtkCommand::ProgressEvent, &abort, &Abort::Check);
    stopped->Update();
    EXPECT_EQ(stopped->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(shelf.Found, 5);

    vtkNew<vtkMesoVDM> again;
    Prepare(again, shelf, rank);
    again->Update();
    EXPECT_EQ(shelf.Found, 12); // none twice
    ExpectSame(again->GetOutput(), filter->GetOutput());
  }
}

TEST(VDMParts, ABakeThatStopsAmongItsFactorsHasNoRaysToFollowAgain)
{
  Shelf shelf;
  vtkNew<vtkMesoVDM> stopped;
  Prepare(stopped, shelf, 6);
  Abort abort = { stopped, 0.7 };
  stopped->AddObserver(vtkCommand::ProgressEvent, &abort, &Abort::Check);
  stopped->Update();
  EXPECT_EQ(stopped->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(stopped->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(shelf.Found, 12);
  vtkNew<vtkMesoVDM> again;
  Prepare(again, shelf, 6);
  again->Update();
  EXPECT_EQ(shelf.Found, 12);
  EXPECT_GT(again->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(VDMParts, ThreadsDoNotMatter)
{
  vtkSmartPointer<vtkImageData> map = RandomMap(19, 13);
  const std::string usual = vtkSMPTools::GetBackend();
  vtkSmartPointer<vtkImageData> several = Bake(map, SmallLayout(19, 13), 6);
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  vtkSmartPointer<vtkImageData> one = Bake(map, SmallLayout(19, 13), 6);
  vtkSMPTools::SetBackend(usual.c_str());
  ExpectSame(one, several);
}

TEST(VDMParts, FactorsSayWhatTheyLeave)
{
  const MesoVDMLayout layout = SmallLayout(16, 16);
  vtkSmartPointer<vtkImageData> map = RandomMap(16, 16);
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  vtkSmartPointer<vtkImageData> factored = Bake(map, layout, 5, MesoVDMCurved::Exact, 8);
  vtkDataArray* errors = factored->GetFieldData()->GetArray("FactorErrors");
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->GetNumberOfTuples(), 3);
  EXPECT_NEAR(errors->GetTuple1(0), RootMeanSquareError(factored, table, layout, 5), 1e-5);
  vtkDataArray* numbers = table->GetPointData()->GetArray("VDM");
  vtkDataArray* angles = table->GetPointData()->GetArray("MVM");
  double largest = 0.;
  double squares = 0.;
  for (vtkIdType tuple = 0; tuple < numbers->GetNumberOfTuples(); ++tuple)
  {
    for (int column = 0; column < layout.DistanceColumns(); ++column)
    {
      largest = std::max(largest,
        std::abs(
          FactoredAt(factored, tuple, column, 5) - numbers->GetComponent(tuple, column) / 65535.));
    }
    for (int k = 2; k < 4; ++k) // 1.5 and 3: those over which a ray may meet nothing
    {
      const double off = 1. - FactoredAt(factored, tuple, k, 5, "MVMFunctions") -
        angles->GetComponent(tuple, k) / 65535.;
      squares += off * off;
    }
  }
  EXPECT_NEAR(errors->GetTuple1(1), largest, 1e-5);
  EXPECT_NEAR(
    errors->GetTuple1(2), std::sqrt(squares / 2. / double(numbers->GetNumberOfTuples())), 1e-5);
}

TEST(VDMParts, TablesSayWhatLiesBetweenTheirAngles)
{
  // An eighth of second differences, around the azimuths without an end and between the polar angles' ends.
  const MesoVDMLayout layout = SmallLayout(6, 5);
  vtkSmartPointer<vtkImageData> table = Bake(RandomMap(6, 5), layout);
  double squares[2] = { 0., 0. };
  double counts[2] = { 0., 0. };
  for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
  {
    for (int texel = 0; texel < layout.Width * layout.Height; ++texel)
    {
      for (int k = 0; k < layout.Curvatures; ++k)
      {
        for (int i = 0; i < layout.Polars; ++i)
        {
          const auto at = [&](int a, int p)
          {
            return NumberAt(table, layout, texel % layout.Width, texel / layout.Width,
              (a + layout.Azimuths) % layout.Azimuths, p, k);
          };
          const auto add = [&](int axis, double before, double after)
          {
            const double eighth = (before - 2. * at(azimuth, i) + after) / 8.;
            squares[axis] += eighth * eighth;
            counts[axis] += 1.;
          };
          add(0, at(azimuth - 1, i), at(azimuth + 1, i));
          if (i > 0 && i + 1 < layout.Polars)
          {
            add(1, at(azimuth, i - 1), at(azimuth, i + 1));
          }
        }
      }
    }
  }
  EXPECT_NEAR(table->GetFieldData()->GetArray("AngularError")->GetTuple1(0),
    std::sqrt(squares[0] / counts[0] + squares[1] / counts[1]), 1e-5);
}

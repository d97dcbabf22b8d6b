// Tables of view-dependent displacements: closed forms, tiny maps by brute force, factors.

#include "BentRelief.h"
#include "ErrorRecorder.h"
#include "VDMTables.h"

#include <gtest/gtest.h>

namespace
{
using namespace VDMTables;

/// What is to be stored of a point, in tiles.
double Expected(const MesoVDMLayout& layout, double polar, double curvature,
  const BentRelief::Place& place, double length)
{
  switch (layout.Stores)
  {
    case MesoVDMStores::Offset:
      return place.Offset;
    case MesoVDMStores::Distance:
      return place.Offset / std::sin(polar);
    default:
      break;
  }
  // The ray is deepest at the foot of the perpendicular from the centre.
  const bool rises = curvature > 0. && length > std::cos(polar) / curvature;
  return rises ? 2. * (1. - std::sin(polar)) / curvature - place.Depth : place.Depth;
}

/// Each direction and curvature of a table at some of its places, against steps along the ray.
void ExpectBruteForce(vtkImageData* map, const MesoVDMLayout& layout)
{
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  const double range = layout.Range();
  int met = 0;
  int missed = 0;
  for (int k = 0; k < layout.Curvatures; ++k)
  {
    for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
    {
      for (int i = 0; i < layout.Polars; ++i)
      {
        const int column = (azimuth * 5 + i + k) % layout.Width;
        const int row = (azimuth + 3 * i + k) % layout.Height;
        const double polar = layout.PolarAt(i);
        const double curvature = layout.CurvatureAt(k);
        const BentRelief relief(
          map, layout, column, row, 2. * Pi * azimuth / layout.Azimuths, curvature);
        BentRelief::Place place = {};
        double length = 0.;
        const double angle = AngleAt(table, layout, column, row, azimuth, k);
        if (!relief.March(polar, place, length))
        {
          ++missed;
          EXPECT_LT(angle, polar + 1e-4);
          continue;
        }
        ++met;
        EXPECT_GT(angle, polar - 1e-4);
        EXPECT_NEAR(NumberAt(table, layout, column, row, azimuth, i, k) * range,
          Expected(layout, polar, curvature, place, length), 2e-5 * range + 1e-6)
          << static_cast<int>(layout.Stores) << ": " << column << " " << row << " " << azimuth
          << " " << i << " " << k;
      }
    }
  }
  EXPECT_GT(met, 150);
  EXPECT_GT(missed, 10);
}
}

TEST(VDM, OfTinyMapsIsThatOfBruteForce)
{
  for (const auto stores : { MesoVDMStores::Depth, MesoVDMStores::Distance, MesoVDMStores::Offset })
  {
    MesoVDMLayout layout = SmallLayout(8, 6);
    layout.Stores = stores;
    ExpectBruteForce(RandomMap(8, 6), layout);
  }
}

TEST(VDM, OfPitsAndTopsIsThatOfBruteForce)
{
  // Rays that end on the bottom, and others that come out of the base between tops.
  MesoVDMLayout layout = SmallLayout(8, 6);
  layout.Polars = 8;
  layout.Curvatures = 7; // -1.5, -.75, 0, .75, ... 3
  ExpectBruteForce(SteppedMap(8, 6), layout);
}

TEST(VDM, LargestAnglesAreThoseOfBruteForce)
{
  MesoVDMLayout layout = SmallLayout(8, 6);
  layout.Polars = 2; // none near the largest angles
  int beyond = 0;
  for (const bool stepped : { false, true })
  {
    vtkSmartPointer<vtkImageData> map = stepped ? SteppedMap(8, 6) : RandomMap(8, 6);
    vtkSmartPointer<vtkImageData> table = Bake(map, layout);
    for (int k = 0; k < layout.Curvatures; ++k)
    {
      for (int i = 0; i < 3 * layout.Azimuths; ++i)
      {
        const int azimuth = i % layout.Azimuths;
        const int column = (5 * i + 2 * k) % layout.Width;
        const int row = (3 * i + i / 12 + k) % layout.Height;
        const double angle = AngleAt(table, layout, column, row, azimuth, k);
        if (layout.CurvatureAt(k) <= 0.)
        {
          EXPECT_NEAR(angle, Pi / 2., 1e-9); // every ray comes down
          continue;
        }
        const BentRelief relief(
          map, layout, column, row, 2. * Pi * azimuth / layout.Azimuths, layout.CurvatureAt(k));
        if (relief.ReliefAt(0.) <= 0.)
        {
          EXPECT_NEAR(angle, Pi / 2., 1e-9);
          continue;
        }
        const double flattest = relief.Flattest();
        EXPECT_NEAR(angle, flattest, 1.5e-5) << column << " " << row << " " << azimuth << " " << k;
        beyond += flattest > layout.PolarAt(1) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(beyond, 10);
}

TEST(VDM, OfALevelMapIsTheClosedForm)
{
  MesoVDMLayout layout = SmallLayout(4, 4);
  vtkSmartPointer<vtkImageData> map = MakeMap(9, 5, [](int, int) { return 0.25; });
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  const double depth = 0.75 * layout.Depth;
  for (int k = 0; k < layout.Curvatures; ++k)
  {
    // A ray that touches the level's circle is the flattest that meets it.
    const double flattest = std::asin(std::min(1., 1. - layout.CurvatureAt(k) * depth));
    EXPECT_NEAR(
      AngleAt(table, layout, 1, 2, 3, k), layout.CurvatureAt(k) > 0. ? flattest : Pi / 2., 3e-5);
    for (int i = 0; i < layout.Polars; ++i)
    {
      // Where it is missed: the point that is touched, which is as deep.
      EXPECT_NEAR(
        NumberAt(table, layout, 1, 2, 3, i, k) * layout.Range(), depth, 2e-5 * layout.Range());
    }
  }
}

TEST(VDM, OfAHighMapLiesOnTheBase)
{
  const MesoVDMLayout layout = SmallLayout(4, 4);
  vtkSmartPointer<vtkImageData> table = Bake(MakeMap(4, 4, [](int, int) { return 1.; }), layout);
  for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
  {
    for (int k = 0; k < layout.Curvatures; ++k)
    {
      EXPECT_EQ(NumberAt(table, layout, 1, 2, azimuth, 3, k), 0.);
      EXPECT_NEAR(AngleAt(table, layout, 1, 2, azimuth, k), Pi / 2., 1e-12);
    }
  }
}

TEST(VDM, BendsFlatPointsAsTheAppendixDoes)
{
  // Of a level map the bent points lie on the bent level, so that only the resampling is off: flat points
  // stand for what they are where many angles are sampled.
  MesoVDMLayout layout = SmallLayout(4, 4);
  layout.Polars = 40;
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 8);
  vtkSmartPointer<vtkImageData> level = MakeMap(4, 4, [](int, int) { return 0.25; });
  vtkSmartPointer<vtkImageData> bent = Bake(level, layout, 0, MesoVDMCurved::Bent);
  for (int k = 0; k < layout.Curvatures; ++k)
  {
    for (int i = 0; i < layout.Polars; ++i)
    {
      EXPECT_NEAR(NumberAt(bent, layout, 1, 2, 3, i, k) * layout.Range(), 0.75 * layout.Depth,
        2e-5 * layout.Range());
    }
  }
  // Both ways agree where the base is flat, and differ elsewhere by what is seen after bending alone.
  vtkSmartPointer<vtkImageData> exact = Bake(map, layout);
  bent = Bake(map, layout, 0, MesoVDMCurved::Bent);
  double sum = 0.;
  for (int i = 0; i < layout.Polars; ++i)
  {
    for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
    {
      EXPECT_EQ(
        NumberAt(exact, layout, 1, 2, azimuth, i, 1), NumberAt(bent, layout, 1, 2, azimuth, i, 1));
      sum += std::abs(
        NumberAt(exact, layout, 1, 2, azimuth, i, 2) - NumberAt(bent, layout, 1, 2, azimuth, i, 2));
    }
  }
  const double mean = sum / layout.Polars / layout.Azimuths * layout.Range();
  EXPECT_GT(mean, 1e-6);
  EXPECT_LT(mean, 0.05 * layout.Depth);
}

TEST(VDM, MoreFactorsLeaveLess)
{
  const MesoVDMLayout layout = SmallLayout(16, 16);
  vtkSmartPointer<vtkImageData> map = RandomMap(16, 16);
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  vtkSmartPointer<vtkImageData> factored = Bake(map, layout, layout.Columns());
  double before = 1.;
  for (const int rank : { 1, 2, 4, 8, 12 })
  {
    const double error = RootMeanSquareError(factored, table, layout, rank);
    EXPECT_LT(error, before);
    before = error;
  }
  // All of them are the table, to the bits of weights and of the table.
  EXPECT_LT(RootMeanSquareError(factored, table, layout, layout.Columns()), 3e-5);
  // Fewer bits leave more: of each factor a twelfth of a code's square, spread over the columns, of which
  // the largest angles' are a few.
  const double of16 = RootMeanSquareError(Bake(map, layout, 8), table, layout, 8);
  vtkSmartPointer<vtkImageData> coarse = Bake(map, layout, 8, MesoVDMCurved::Exact, 8);
  const double of8 = RootMeanSquareError(coarse, table, layout, 8);
  double expected = 0.;
  for (int i = 0; i < 8; ++i)
  {
    const double code = coarse->GetFieldData()->GetArray("WeightWidth")->GetTuple1(i) / 255.;
    expected += code * code / 12. / layout.Columns();
  }
  EXPECT_GT(of8 * of8 - of16 * of16, 0.6 * expected);
  EXPECT_LT(of8 * of8 - of16 * of16, 1.5 * expected);
}

TEST(VDM, ErrorsOfFactorsAreThoseOfTheirMatrix)
{
  // Of each rank, of distances and of largest angles that are scaled to the distances' root mean square.
  const MesoVDMLayout layout = SmallLayout(8, 6);
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  vtkSmartPointer<vtkImageData> factored = Bake(map, layout, 4);
  vtkDataArray* numbers = table->GetPointData()->GetArray("VDM");
  vtkDataArray* angles = table->GetPointData()->GetArray("MVM");
  const auto squares = [&](int rank, bool ofAngles)
  {
    vtkDataArray* array = ofAngles ? angles : numbers;
    double sum = 0.;
    for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
    {
      for (int column = 0; column < array->GetNumberOfComponents(); ++column)
      {
        const double number = array->GetComponent(tuple, column) / 65535.;
        const double error = (ofAngles ? 1. - number : number) -
          FactoredAt(factored, tuple, column, rank, ofAngles ? "MVMFunctions" : "VDMFunctions");
        sum += error * error;
      }
    }
    return sum;
  };
  const double scale =
    squares(0, false) / layout.DistanceColumns() / (squares(0, true) / layout.Curvatures);
  for (int rank = 1; rank <= 4; ++rank)
  {
    const double square = (squares(rank, false) + scale * squares(rank, true)) /
      (double(layout.Rows()) * layout.Columns());
    EXPECT_NEAR(factored->GetFieldData()->GetArray("Errors")->GetTuple1(rank - 1),
      std::sqrt(square), 0.01 * std::sqrt(square))
      << rank;
  }
}

TEST(VDM, FactorsOfAConstantTableAreIt)
{
  const MesoVDMLayout layout = SmallLayout(4, 4);
  vtkSmartPointer<vtkImageData> map = MakeMap(4, 4, [](int, int) { return 1.; });
  vtkSmartPointer<vtkImageData> factored = Bake(map, layout, 4);
  EXPECT_LT(RootMeanSquareError(factored, Bake(map, layout), layout, 4), 1e-6);
}

TEST(VDM, ResamplesMapsOfAnySize)
{
  // A wave over 4 tables' texels: of it as large a map and a finer one are the same to the mean over a
  // texel.
  const MesoVDMLayout layout = SmallLayout(32, 32);
  const auto wave = [](int size)
  {
    return MakeMap(
      size, size, [size](int i, int) { return 0.5 + 0.3 * std::cos(2. * Pi * (i + 0.5) / size); });
  };
  const auto heightAt = [](vtkImageData* table, int i)
  { return table->GetFieldData()->GetArray("Heights")->GetTuple1(i); };
  vtkSmartPointer<vtkImageData> same = Bake(wave(32), layout);
  vtkSmartPointer<vtkImageData> finer = Bake(wave(96), layout);
  vtkSmartPointer<vtkImageData> coarser = Bake(wave(16), layout);
  for (int i = 0; i < 32; ++i)
  {
    const double exact = 0.5 + 0.3 * std::cos(2. * Pi * (i + 0.5) / 32);
    EXPECT_NEAR(heightAt(same, i), exact, 1e-6);
    EXPECT_NEAR(heightAt(finer, i), exact, 2e-3);
    EXPECT_NEAR(heightAt(coarser, i), exact, 2e-2);
  }
  // Of what is finer than a texel all counts: of a texel's three a spike of 1 and two of 0.
  vtkSmartPointer<vtkImageData> spikes =
    Bake(MakeMap(96, 32, [](int i, int) { return i % 3 == 0 ? 1. : 0.; }), layout);
  for (int i = 0; i < 32; ++i)
  {
    EXPECT_NEAR(heightAt(spikes, i), 1. / 3., 1e-6);
  }
}

TEST(VDM, ReadsItsLayoutBack)
{
  MesoVDMLayout layout = SmallLayout(5, 7);
  layout.Nodes = MesoVDMNodes::Graded;
  layout.Stores = MesoVDMStores::Offset;
  vtkSmartPointer<vtkImageData> table = Bake(RandomMap(5, 7), layout);
  const MesoVDMLayout read = MesoVDMLayout::Read(table);
  EXPECT_EQ(read.Width, 5);
  EXPECT_EQ(read.Azimuths, layout.Azimuths);
  EXPECT_EQ(read.Nodes, layout.Nodes);
  EXPECT_EQ(read.Stores, layout.Stores);
  EXPECT_EQ(read.Depth, layout.Depth);
  EXPECT_EQ(read.Range(), layout.Range());
  table->GetFieldData()->RemoveArray("VDMNumbers");
  EXPECT_THROW(MesoVDMLayout::Read(table), std::runtime_error);
}

TEST(VDM, RefusesWhatMakesNoTable)
{
  struct Case
  {
    std::function<void(MesoVDMLayout&)> Change;
    const char* Says;
  };
  const Case cases[] = {
    { [](MesoVDMLayout& layout) { layout.Depth = 0.4; }, "beyond the centre of the curvature" },
    { [](MesoVDMLayout& layout) { layout.Depth = 0.; }, "the depth must be" },
    { [](MesoVDMLayout& layout) { layout.Polars = 1; }, "polar angles" },
    { [](MesoVDMLayout& layout) { layout.FirstCurvature = 4.; }, "less than the last" },
  };
  for (const Case& wrong : cases)
  {
    MesoVDMLayout layout = SmallLayout(4, 4);
    wrong.Change(layout);
    EXPECT_NE(layout.Problem().find(wrong.Says), std::string::npos) << layout.Problem();
    vtkNew<vtkMesoVDM> filter;
    ErrorRecorder recorder;
    recorder.Watch(filter);
    filter->SetInputData(RandomMap(4, 4));
    filter->SetLayout(layout);
    filter->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u);
    EXPECT_NE(recorder.Errors[0].find(wrong.Says), std::string::npos) << recorder.Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(VDM, StopsWhereItIsAborted)
{
  struct Abort
  {
    vtkMesoVDM* Filter;
    void AtOnce(vtkObject*, unsigned long, void*) { this->Filter->AbortExecuteOn(); }
  };
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(RandomMap(8, 8));
  filter->SetLayout(SmallLayout(8, 8));
  Abort abort = { filter };
  filter->AddObserver(vtkCommand::ProgressEvent, &abort, &Abort::AtOnce);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

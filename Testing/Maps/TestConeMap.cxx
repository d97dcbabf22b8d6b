// Cones of free space and maxima of height maps, against the definition, texel by texel.

#include "ErrorRecorder.h"
#include "HeightSearchCases.h"
#include "vtkMesoConeMap.h"
#include "vtkMesoMaximumMip.h"

#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkImageData> ImageOf(const SearchMap& map)
{
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfValues(vtkIdType(map.Heights.size()));
  std::copy(map.Heights.begin(), map.Heights.end(), heights->GetPointer(0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(map.Width, map.Height, 1);
  image->GetPointData()->SetScalars(heights);
  return image;
}

/// The least steepness that a texel's cone of this apex needs, by all texels of two periods ahead.
double LeastSteepness(
  const SearchMap& map, const TrueSurface& surface, int column, int row, int way, double apex)
{
  const int du = way & 1 ? -1 : 1;
  const int dv = way & 2 ? -1 : 1;
  double least = 0.;
  for (int j = 0; j <= 2 * map.Height + 1; ++j)
  {
    for (int i = j == 0 ? 1 : 0; i <= 2 * map.Width + 1; ++i)
    {
      const double depth = 1. - surface.Texel(column + du * i, row + dv * j);
      least = std::max(least, (apex - depth) / double(i + j));
    }
  }
  return least;
}

class StopAt : public vtkCommand
{
public:
  static StopAt* New() { return new StopAt; }
  void Execute(vtkObject* caller, unsigned long, void* part) override
  {
    ++this->Told;
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(*static_cast<double*>(part) > this->Part);
  }
  double Part = 2.;
  int Told = 0;
};
}

TEST(ConeMap, EveryConeIsFreeAndNoneMuchSteeperThanItMustBe)
{
  std::mt19937 generator(7);
  int wide = 0;
  for (const SearchMap& map : HardMaps(generator))
  {
    for (MesoWrap wrap : AllWraps)
    {
      vtkNew<vtkMesoConeMap> filter;
      filter->SetInputData(ImageOf(map));
      filter->SetWrap(wrap);
      filter->Update();
      vtkPointData* arrays = filter->GetOutput()->GetPointData();
      auto* steepness = vtkUnsignedCharArray::SafeDownCast(arrays->GetScalars("ConeSteepness"));
      auto* apex = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray("ConeApex"));
      ASSERT_TRUE(steepness && apex);
      const TrueSurface surface(map, wrap);
      for (int row = 0; row < map.Height; ++row)
      {
        for (int column = 0; column < map.Width; ++column)
        {
          for (int way = 0; way < 4; ++way)
          {
            const vtkIdType texel = vtkIdType(row) * map.Width + column;
            const double a = apex->GetTypedComponent(texel, way) / 255.;
            const double code = steepness->GetTypedComponent(texel, way) / 255.;
            const int du = way & 1 ? -1 : 1;
            const int dv = way & 2 ? -1 : 1;
            const double patch = 1. -
              std::max({ surface.Texel(column, row), surface.Texel(column + du, row),
                surface.Texel(column, row + dv), surface.Texel(column + du, row + dv) });
            // The apex is the patch's highest corner, 8 bits or less above it.
            ASSERT_LE(a, patch + 1.6e-7) << map.Name;
            ASSERT_GE(a, patch - 1.01 / 255.) << map.Name;
            const double least = LeastSteepness(map, surface, column, row, way, a);
            const double m = 0.5 * code * code;
            ASSERT_GE(m, least - 1.6e-7)
              << map.Name << " " << MesoName(wrap) << " " << column << " " << row << " way " << way;
            // A quarter for what triangles grow by, and a code.
            const double next = 0.5 * std::pow(std::sqrt(2. * 1.25 * least) + 1.01 / 255., 2);
            ASSERT_LE(m, next + 1e-5)
              << map.Name << " " << MesoName(wrap) << " " << column << " " << row << " way " << way;
            wide += m > 0. && m < 0.05 ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(wide, 1000);
}

TEST(ConeMap, TellsProgressAndStopsWhereAsked)
{
  std::mt19937 generator(8);
  const SearchMap map = HardMaps(generator)[6];
  vtkNew<vtkMesoConeMap> filter;
  filter->SetInputData(ImageOf(map));
  vtkNew<StopAt> stop;
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_GT(stop->Told, 20);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), map.Width * map.Height);
  stop->Part = 0.5;
  stop->Told = 0;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ConeMap, RefusesWhatIsNoHeightMap)
{
  const SearchMap map = { "too high", 2, 1, { 0.5f, 1.5f } };
  vtkNew<vtkMesoConeMap> filter;
  ErrorRecorder recorder;
  recorder.Watch(filter);
  filter->SetInputData(ImageOf(map));
  filter->Update();
  ASSERT_EQ(recorder.Errors.size(), 1u);
  EXPECT_NE(recorder.Errors.front().find("texel (1, 0)"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MaximumMip, HoldsTheGreatestOfEachBlockOfPatches)
{
  std::mt19937 generator(9);
  for (const SearchMap& map : HardMaps(generator))
  {
    for (MesoWrap wrap : AllWraps)
    {
      vtkNew<vtkMesoMaximumMip> filter;
      filter->SetInputData(ImageOf(map));
      filter->SetWrap(wrap);
      filter->Update();
      vtkImageData* output = filter->GetOutput();
      auto* sizes = vtkIntArray::SafeDownCast(output->GetFieldData()->GetArray("MaximumSizes"));
      ASSERT_TRUE(sizes);
      const TrueSurface surface(map, wrap);
      const int levels = int(sizes->GetNumberOfTuples());
      for (int level = 0; level < levels; ++level)
      {
        auto* maxima = vtkFloatArray::SafeDownCast(level == 0
            ? output->GetPointData()->GetScalars("Maximum")
            : output->GetFieldData()->GetArray(("Maximum" + std::to_string(level)).c_str()));
        ASSERT_TRUE(maxima) << level;
        const int width = sizes->GetTypedComponent(level, 0);
        const int height = sizes->GetTypedComponent(level, 1);
        ASSERT_EQ(width, std::max(1, ((map.Width - 1) >> level) + 1));
        ASSERT_EQ(height, std::max(1, ((map.Height - 1) >> level) + 1));
        ASSERT_EQ(maxima->GetNumberOfValues(), vtkIdType(width) * height);
        for (int row = 0; row < height; ++row)
        {
          for (int column = 0; column < width; ++column)
          {
            double greatest = 0.;
            for (int j = row << level; j <= std::min((row + 1) << level, map.Height); ++j)
            {
              for (int i = column << level; i <= std::min((column + 1) << level, map.Width); ++i)
              {
                greatest = std::max(greatest, surface.Texel(i, j));
              }
            }
            ASSERT_EQ(double(maxima->GetValue(vtkIdType(row) * width + column)), greatest)
              << map.Name << " " << MesoName(wrap) << " level " << level;
          }
        }
      }
      ASSERT_EQ(
        sizes->GetTypedComponent(levels - 1, 0) * sizes->GetTypedComponent(levels - 1, 1), 1);
    }
  }
}

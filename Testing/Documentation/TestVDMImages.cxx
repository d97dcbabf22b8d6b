// Wang2003, Figure 4: what a table holds of a height field for four directions of view, as grey levels, beside
// the height field; against rays that are followed by small steps.

#include "BentRelief.h"
#include "MesoBaseline.h"
#include "MesoTestScene.h"
#include "VDMTables.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace
{
using namespace VDMTables;

constexpr int Size = 96; // texels and pixels
constexpr int Gap = 6;

struct Direction
{
  int Azimuth;
  int Polar;
};
// 20, 50, 70 and 70 degrees off the normal; the last two from opposite sides.
constexpr std::array<Direction, 4> Directions = { { { 1, 2 }, { 1, 5 }, { 1, 7 }, { 5, 7 } } };

/// Distances along rays over a flat base.
MesoVDMLayout LayoutOfFigure()
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = Size;
  layout.Azimuths = 8;
  layout.Curvatures = 1;
  layout.FirstCurvature = layout.LastCurvature = 0.;
  layout.Nodes = MesoVDMNodes::Edges;
  layout.Polars = 10; // every 10 degrees
  layout.Stores = MesoVDMStores::Distance;
  return layout;
}

/// Grey pictures of Size x Size in a row.
class Row
{
public:
  explicit Row(int count)
    : Image(vtkSmartPointer<vtkImageData>::New())
  {
    this->Image->SetDimensions(count * (Size + Gap) - Gap, Size, 1);
    this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    this->Image->GetPointData()->GetScalars()->Fill(255.);
  }

  /// levels: row by row, in [0, 1].
  void Add(const std::vector<double>& levels)
  {
    for (int i = 0; i < Size * Size; ++i)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        this->Image->SetScalarComponentFromDouble(this->Count * (Size + Gap) + i % Size, i / Size,
          0, channel, std::round(255. * levels[i]));
      }
    }
    ++this->Count;
  }

  vtkSmartPointer<vtkImageData> Image;

private:
  int Count = 0;
};
}

TEST(VDMImages, OfAHeightFieldFromFourDirections)
{
  const MesoVDMLayout layout = LayoutOfFigure();
  const auto map = MesoTestScene::Pattern("stone", Size, Size);
  const auto table = Bake(map, layout);
  std::vector<double> heights;
  heights.reserve(Size * Size);
  for (int i = 0; i < Size * Size; ++i)
  {
    heights.push_back(map->GetScalarComponentAsDouble(i % Size, i / Size, 0, 0));
  }
  Row row(1 + int(Directions.size()));
  row.Add(heights);
  std::vector<std::vector<double>> pictures;
  for (const Direction& direction : Directions)
  {
    const double polar = layout.PolarAt(direction.Polar);
    std::vector<double> distances;
    distances.reserve(Size * Size);
    for (int i = 0; i < Size * Size; ++i)
    {
      distances.push_back(
        NumberAt(table, layout, i % Size, i / Size, direction.Azimuth, direction.Polar, 0) *
        layout.Range());
    }
    for (int i = 0; i < Size * Size; i += 23)
    {
      const BentRelief relief(
        map, layout, i % Size, i / Size, 2. * Pi * direction.Azimuth / layout.Azimuths, 0.);
      BentRelief::Place place = {};
      double length = 0.;
      ASSERT_TRUE(relief.March(polar, place, length));
      EXPECT_NEAR(distances[i], length, 2e-5 * layout.Range())
        << direction.Azimuth << " " << direction.Polar << " " << i;
    }
    pictures.push_back(distances);
    // White: as far as a ray of 66 degrees comes to the bottom.
    for (double& distance : distances)
    {
      distance = std::min(1., 0.4 * distance / layout.Depth);
    }
    row.Add(distances);
  }
  // The flatter a ray, the further it comes, and the less deep: it ends at what rises before it.
  std::vector<double> means;
  for (const std::vector<double>& picture : pictures)
  {
    means.push_back(std::accumulate(picture.begin(), picture.end(), 0.) / (Size * Size));
    const double cosine = std::cos(layout.PolarAt(Directions[means.size() - 1].Polar));
    std::printf("mean distance %.4f, depth %.4f tiles\n", means.back(), means.back() * cosine);
  }
  for (std::size_t i = 1; i < 3; ++i)
  {
    EXPECT_GT(means[i], 1.05 * means[i - 1]);
    EXPECT_LT(means[i] * std::cos(layout.PolarAt(Directions[i].Polar)),
      0.95 * means[i - 1] * std::cos(layout.PolarAt(Directions[i - 1].Polar)));
  }
  // From the other side the same places are seen at other distances.
  double apart = 0.;
  for (int i = 0; i < Size * Size; ++i)
  {
    apart += std::abs(pictures[2][i] - pictures[3][i]) / (Size * Size);
  }
  EXPECT_GT(apart, 0.1 * means[2]);
  EXPECT_TRUE(MesoCompareWithBaseline(
    row.Image, "VDMImages", MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));
}

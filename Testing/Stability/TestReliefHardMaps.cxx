// Height maps that strain the search: all 0, all 1, one-texel spike and slot, checkerboard at
// Nyquist, 1 x 1, 1 x N, sizes that are no power of two, every wrap; and huge and tiny D.

#include "MesoAOVChecks.h"
#include "MesoExpectedMessages.h"

#include "vtkPointData.h"

#include <functional>
#include <iostream>

namespace
{
vtkSmartPointer<vtkImageData> Map(
  int width, int height, const std::function<float(int, int)>& heightOf)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      *value++ = heightOf(column, row);
    }
  }
  return image;
}

class ReliefHardMaps : public MesoReliefAOVs
{
protected:
  void SetUp() override { this->Use(MesoTestScene::Shape("plane")); }

  int Check(vtkImageData* map)
  {
    this->Mapper->SetHeightMap(map);
    return this->MesoReliefAOVs::Check();
  }

  /// Least and greatest relief over the covered pixels.
  std::pair<float, float> ReliefRange() const
  {
    std::pair<float, float> range(1.f, 0.f);
    const auto values = this->Pass->GetInterleaved({ "coverage", "relief" });
    for (std::size_t i = 0; i < values.size(); i += 2)
    {
      if (values[i] > 0.f)
      {
        range = { std::min(range.first, values[i + 1]), std::max(range.second, values[i + 1]) };
      }
    }
    return range;
  }
};
}

TEST_P(ReliefHardMaps, HighEverywhere)
{
  EXPECT_GT(this->Check(Map(8, 8, [](int, int) { return 1.f; })), 3000);
  EXPECT_EQ(this->ReliefRange(), (std::pair<float, float>(0.f, 0.f)));
}

TEST_P(ReliefHardMaps, LowEverywhere)
{
  EXPECT_GT(this->Check(Map(8, 8, [](int, int) { return 0.f; })), 3000);
  EXPECT_EQ(this->ReliefRange(), (std::pair<float, float>(1.f, 1.f)));
}

TEST_P(ReliefHardMaps, OneTexel)
{
  this->Check(Map(1, 1, [](int, int) { return 0.25f; }));
  EXPECT_NEAR(this->ReliefRange().first, 0.75, 1e-6);
  EXPECT_NEAR(this->ReliefRange().second, 0.75, 1e-6);
}

TEST_P(ReliefHardMaps, OneRowAndOneColumn)
{
  this->Check(Map(7, 1, [](int column, int) { return column % 2 ? 1.f : 0.f; }));
  EXPECT_LT(this->ReliefRange().first, 0.2);
  this->Check(Map(1, 7, [](int, int row) { return row % 2 ? 1.f : 0.f; }));
  EXPECT_LT(this->ReliefRange().first, 0.2);
}

TEST_P(ReliefHardMaps, SpikeAndSlot)
{
  this->Check(
    Map(33, 17, [](int column, int row) { return column == 16 && row == 8 ? 1.f : 0.f; }));
  EXPECT_LT(this->ReliefRange().first, 0.5) << "the spike is not seen";
  this->Check(
    Map(33, 17, [](int column, int row) { return column == 16 && row == 8 ? 0.f : 1.f; }));
  EXPECT_GT(this->ReliefRange().second, 0.3) << "the slot is not seen";
}

TEST_P(ReliefHardMaps, CheckerboardInEveryWrap)
{
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Tiles = { 2.5, 2.5 };
  for (MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror })
  {
    options.Wrap = wrap;
    this->Mapper->SetOptions(options);
    EXPECT_GT(
      this->Check(Map(31, 63, [](int column, int row) { return (column + row) % 2 ? 1.f : 0.f; })),
      3000);
  }
}

TEST_P(ReliefHardMaps, TinyAndHugeScale)
{
  const auto map = MesoTestScene::Pattern("noise");
  for (double scale : { 1e-30, 1e-12, 1e-6, 10., 1e6, 1e12, 1e30 })
  {
    this->Mapper->SetScale(scale);
    EXPECT_GT(this->Check(map), 3000) << scale;
  }
}

TEST_P(ReliefHardMaps, TenThousandTiles)
{
  this->Mapper->SetTiles(1e4, 1e4);
  this->Mapper->SetScale(1e-5);
  EXPECT_GT(this->Check(MesoTestScene::Pattern("brick")), 3000);
}

TEST_P(ReliefHardMaps, TenThousandTilesOfFourThousandTexels)
{
  // The last third of the last of 10^4 tiles along u and v, where floats are 4 texels apart.
  constexpr double Tiles = 1e4;
  constexpr double Part = 1. / 32768.; // of the chart, exact in floats
  const auto map = Map(4096, 64, [](int column, int row) { return float((column / 8 + row) % 2); });
  this->Mapper->SetScale(1e-6); // no parallax: where a ray hits is where it comes in
  const int covered = this->Check(map);
  EXPECT_GT(covered, 3000);
  const auto places = this->Pass->GetInterleaved({ "coverage", "texcoord.u", "texcoord.v" });
  const auto corner = vtkSmartPointer<vtkPolyData>::New();
  corner->DeepCopy(MesoTestScene::Shape("plane"));
  vtkDataArray* coordinates = corner->GetPointData()->GetTCoords();
  const auto moved = [](double place) { return 1. - (1. - place) * Part; };
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, moved(coordinates->GetComponent(i, 0)));
    coordinates->SetComponent(i, 1, moved(coordinates->GetComponent(i, 1)));
  }
  this->Use(corner);
  this->Mapper->SetTiles(Tiles, Tiles);
  EXPECT_EQ(this->Check(map), covered) << "holes";
  const auto hits = this->Pass->GetInterleaved({ "coverage", "texcoord.u", "texcoord.v" });
  double worst = 0.;
  for (std::size_t i = 0; i < hits.size(); i += 3)
  {
    for (std::size_t axis = 1; hits[i] > 0.f && axis < 3; ++axis)
    {
      const double place = Tiles * moved(double(places[i + axis]));
      worst = std::max(worst, std::abs(double(hits[i + axis]) - place));
    }
  }
  std::cout << "off by " << 4096. * worst << " texels of 4096 a tile\n";
  EXPECT_LT(4096. * worst, 48.); // what interpolating a float over the picture leaves
}

TEST_P(ReliefHardMaps, WrongMapsAreRefusedAndTheBaseIsDrawn)
{
  vtkNew<vtkImageData> colour;
  colour->SetDimensions(4, 4, 1);
  colour->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  MesoExpectedMessages expected("one component of float");
  EXPECT_GT(this->Check(colour), 3000);
  EXPECT_EQ(this->ReliefRange().second, 0.f);
}

MESO_FOR_RELIEF_ARMS(ReliefHardMaps);

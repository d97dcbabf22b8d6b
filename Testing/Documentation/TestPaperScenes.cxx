// Figures 1, 11, 12, 13, 16 and 18 of Oliveira2005: what scenes of relief show, in numbers.
// Documentation/Techniques/ReliefFigures.md shows the pictures.

#include "PaperFigure.h"

#include "MesoFlip.h"
#include "ShadowComparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Every object of a room: the same pixels as in the truth, at the same depth, and its relief is seen.
void CheckRoom(const std::string& file, double coverage, double depth)
{
  const PaperFigure figure(file);
  const MesoExrImage image = DrawnImage(figure.Scene, figure.Width, figure.Height);
  const MesoAOVs drawn = MesoAOVsOfImage(image);
  const MesoGeometryError error = figure.ErrorOf(drawn);
  const std::vector<float> relief = ChannelOf(image, "relief");
  std::cout << file << ": iou " << error.CoverageIou << ", depth p95 " << error.Depth.P95
            << ", holes " << error.HolePixels << "\n";
  EXPECT_EQ(error.NanPixels, 0u);
  EXPECT_EQ(error.HolePixels, 0u);
  EXPECT_GT(error.CoverageIou, 0.99);
  std::size_t seen = 0;
  for (std::size_t node = 0; node < figure.Scene.Nodes.size(); ++node)
  {
    const float number = float(node + 1);
    const std::string& name = figure.Scene.Nodes[node].Name;
    double both = 0.;
    double either = 0.;
    std::vector<float> depths; // within the relief
    for (std::size_t i = 0; i < drawn.NumberOfPixels(); ++i)
    {
      const bool inTruth = figure.Truth().Object[i] == number;
      const bool inDrawn = drawn.Object[i] == number;
      both += inTruth && inDrawn ? 1. : 0.;
      either += inTruth || inDrawn ? 1. : 0.;
      if (inDrawn)
      {
        depths.push_back(relief[i]);
      }
    }
    ASSERT_GT(both, 100.) << name;
    EXPECT_GT(both / either, coverage) << name;
    std::cout << "  " << name << ": iou " << both / either;
    if (figure.Scene.Nodes[node].Map)
    {
      std::sort(depths.begin(), depths.end());
      const double spread =
        double(depths[std::size_t(0.98 * double(depths.size()))] - depths[depths.size() / 50]);
      std::cout << ", relief seen over " << spread << " of D";
      EXPECT_GT(spread, 0.3) << name;
      for (const MesoObjectError& object : error.Objects)
      {
        if (object.Number == int(node + 1))
        {
          std::cout << ", depth p95 " << object.Depth.P95;
          EXPECT_LT(object.Depth.P95, depth) << name;
        }
      }
    }
    std::cout << "\n";
    ++seen;
  }
  EXPECT_GE(seen, 6u);
}

MesoPicture PictureOf(const MesoScene& scene, int width, int height)
{
  DrawnScene drawn(scene, width, height);
  return MesoPictureOfImage(MesoGrabWindow(drawn.Window));
}

double MeanFlip(const MesoPicture& a, const MesoPicture& b)
{
  const std::vector<float> error = MesoFlip(a, b);
  return std::accumulate(error.begin(), error.end(), 0.) / double(error.size());
}

std::size_t PixelsOf(const MesoAOVs& pixels, int object)
{
  return std::size_t(std::count(pixels.Object.begin(), pixels.Object.end(), float(object)));
}

/// The relief around a torus, in a row on its upper side, by the angle of the point that a pixel shows.
std::vector<double> ReliefAround(
  const MesoExrImage& image, int object, const MesoSceneNode& node, int bins)
{
  constexpr double TubeAngle = Pi / 3.; // from the outside up
  const MesoAOVs pixels = MesoAOVsOfImage(image);
  const std::vector<float> relief = ChannelOf(image, "relief");
  std::vector<double> sums(std::size_t(bins), 0.);
  std::vector<double> counts(std::size_t(bins), 0.);
  for (std::size_t i = 0; i < relief.size(); ++i)
  {
    if (pixels.Object[i] != float(object))
    {
      continue;
    }
    const std::array<double, 3> point = pixels.PointAt(i);
    const double size = node.Matrix[0];
    const double x = (point[0] - node.Matrix[3]) / size; // a torus of radius 1
    const double z = point[2] / size;
    const double around = std::atan2(point[1] / size, std::hypot(x, z) - 1.);
    if (std::abs(around - TubeAngle) < 0.5 / node.Mesostructure.Tiles[1])
    {
      const auto bin = std::size_t((std::atan2(z, x) / (2. * Pi) + 1.) * bins) % std::size_t(bins);
      sums[bin] += double(relief[i]);
      counts[bin] += 1.;
    }
  }
  for (std::size_t bin = 0; bin < sums.size(); ++bin)
  {
    // A bin that no pixel's centre falls into is like the one before.
    sums[bin] = counts[bin] > 0. ? sums[bin] / counts[bin] : (bin > 0 ? sums[bin - 1] : 0.);
  }
  return sums;
}

/// Of values around a circle with the same moved on.
double Correlation(const std::vector<double>& values, std::size_t moved)
{
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
  double product = 0.;
  double square = 0.;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    product += (values[i] - mean) * (values[(i + moved) % values.size()] - mean);
    square += (values[i] - mean) * (values[i] - mean);
  }
  return product / square;
}
}

TEST(PaperScenes, Figure1ARoomOfColumnsStonesAndWalls)
{
  CheckRoom("../room", 0.97, 0.3);
}

TEST(PaperScenes, Figure16AHallWithItsCeilingAndPath)
{
  CheckRoom("FigureHall", 0.99, 0.2);
}

TEST(PaperScenes, Figure11TheExactAndTheApproximateDistanceLookDifferent)
{
  // The report finds them all but equal. They are not, and the approximate one is nearer to the truth.
  const PaperFigure figure("CurvedQuadric");
  const MesoPicture truth =
    MesoPictureOfImage(MesoReference(figure.Scene).Render(figure.Width, figure.Height).Picture);
  const MesoPicture approximate =
    PictureOf(figure.With(MesoTechnique::ReliefQuadric), figure.Width, figure.Height);
  const MesoPicture exact =
    PictureOf(figure.With(MesoTechnique::ReliefQuadricExact), figure.Width, figure.Height);
  const double apart = MeanFlip(approximate, exact);
  const double ofApproximate = MeanFlip(truth, approximate);
  const double ofExact = MeanFlip(truth, exact);
  std::cout << "FLIP of exact and approximate " << apart << ", to the truth: exact " << ofExact
            << ", approximate " << ofApproximate << "\n";
  EXPECT_GT(apart, 0.15);
  EXPECT_GT(ofExact, 1.5 * ofApproximate);
}

TEST(PaperScenes, Figure12EachOfTwoCylindersHasThePixelsThatItHasInTruth)
{
  const PaperFigure figure("DepthCylinders", 120, 90);
  const MesoAOVs drawn = figure.Drawn();
  for (int object = 1; object <= 2; ++object)
  {
    const double truth = double(PixelsOf(figure.Truth(), object));
    const double ours = double(PixelsOf(drawn, object));
    std::cout << figure.Scene.Nodes[std::size_t(object - 1)].Name << ": " << ours << " pixels of "
              << truth << "\n";
    EXPECT_GT(truth, 1000.);
    EXPECT_NEAR(ours, truth, 0.02 * truth);
  }
  // Without the depth of the relief the cylinder that is drawn last would hide the other.
  MesoScene flat = figure.Scene;
  for (MesoSceneNode& node : flat.Nodes)
  {
    node.Mesostructure.Effects = { false,
      MesoEffectsOfTechnique(MesoTechnique::ReliefQuadric).Without({ MesoEffect::Depth }) };
  }
  const MesoAOVs coincident = DrawnAOVs(flat, figure.Width, figure.Height);
  const double bricks = double(PixelsOf(figure.Truth(), 1));
  EXPECT_GT(std::abs(double(PixelsOf(coincident, 1)) - bricks), 0.2 * bricks);
}

TEST(PaperScenes, Figure13ReliefCastsAndTakesShadows)
{
  constexpr int Width = 120;
  constexpr int Height = 90;
  enum
  {
    Floor = 1,
    Column = 2
  };
  const MesoScene scene = MesoReadScene(MESO_SCENES "/Documentation/ShadowsFloor.json");
  MesoScene plainFloor = scene;
  plainFloor.Nodes[Floor - 1].Mesostructure.Technique = MesoTechnique::Plain;

  // Relief onto a plain floor; plain objects onto the relief of a column; relief onto relief.
  const auto check = [&](
                       const char* what, const ShadowComparison& shadows, int object, double within)
  {
    for (int light = 0; light < 2; ++light)
    {
      const ShadowCount count = shadows.Count(object, light);
      std::cout << what << ", light " << light << ": " << count << "\n";
      EXPECT_GT(count.Both, 150) << what;
      const double truth = count.Both + count.Missing;
      EXPECT_NEAR(double(count.Both + count.Extra), truth, within * truth) << what << " " << light;
      EXPECT_GT(count.Iou(), 1. - 1.2 * within) << what << " " << light;
    }
  };
  const ShadowComparison ontoPlain(plainFloor, plainFloor, Width, Height);
  check("relief onto a plain floor", ontoPlain, Floor, 0.015);
  const ShadowComparison ontoRelief(scene, scene, Width, Height);
  check("onto the relief of the column", ontoRelief, Column, 0.04);
  check("relief onto relief", ontoRelief, Floor, 0.015);

  // It is the relief that casts: the shadow of its mesh alone is another.
  MesoScene plainBoth = plainFloor;
  plainBoth.Nodes[Column - 1].Mesostructure.Technique = MesoTechnique::Plain;
  const ShadowComparison bare(plainFloor, plainBoth, Width, Height);
  std::cout << "of the column's mesh onto a plain floor: " << bare.Count(Floor) << "\n";
  EXPECT_LT(bare.Count(Floor).Iou(), 1. - 2. * (1. - ontoPlain.Count(Floor).Iou()));
}

TEST(PaperScenes, Figure18TheReliefRepeatsAsOftenAsItsTiles)
{
  const PaperFigure figure("FigureTiles", 400, 150);
  const MesoExrImage drawn = DrawnImage(figure.Scene, figure.Width, figure.Height);
  for (int object = 1; object <= 3; ++object)
  {
    constexpr int Bins = 256;
    const MesoSceneNode& node = figure.Scene.Nodes[std::size_t(object - 1)];
    const std::vector<double> relief = ReliefAround(drawn, object, node, Bins);
    const auto tile = std::size_t(Bins / node.Mesostructure.Tiles[0]);
    double best = -1.; // of shorter periods
    for (std::size_t moved = tile / 4; moved <= tile - tile / 4; ++moved)
    {
      best = std::max(best, Correlation(relief, moved));
    }
    const double own = Correlation(relief, tile);
    std::cout << node.Mesostructure.Tiles[0] << " tiles around: correlation after a tile " << own
              << ", after less " << best << "\n";
    EXPECT_GT(own, 0.5);
    EXPECT_LT(best, 0.6 * own);
  }
  EXPECT_GT(figure.ErrorOf(MesoAOVsOfImage(drawn)).CoverageIou, 0.98);
}

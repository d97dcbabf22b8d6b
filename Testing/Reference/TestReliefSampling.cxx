// How relief is read between texels and where they are smaller than pixels: cubic heights against the
// reference's own, and pictures from afar against the truth averaged over each pixel.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numeric>
#include <unistd.h>

namespace
{
using Picture = std::vector<double>; ///< RGB of all pixels, [0,1], row 0 at the bottom

Picture DrawnPicture(const MesoScene& scene, int width, int height)
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  static_cast<vtkRenderWindow*>(window)->GetPixelData(0, 0, width - 1, height - 1, 0, bytes);
  Picture picture;
  for (vtkIdType i = 0; i < bytes->GetNumberOfValues(); ++i)
  {
    picture.push_back(bytes->GetValue(i) / 255.);
  }
  return picture;
}

Picture TruePicture(const MesoScene& scene, int width, int height, int samples)
{
  const auto image = MesoReference(scene).Render(width, height, samples).Picture;
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  Picture picture;
  for (int i = 0; i < 3 * width * height; ++i)
  {
    picture.push_back(bytes[i] / 255.);
  }
  return picture;
}

/// Root mean square of the differences.
double Distance(const Picture& a, const Picture& b)
{
  EXPECT_EQ(a.size(), b.size());
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / double(a.size()));
}

/// A field of relief under a light from the side, seen from a distance in units of its side.
MesoScene Field(double distance, const std::string& filter, const std::string& pattern = "noise")
{
  const std::string away = std::to_string(distance);
  return MesoParseScene(R"({ "meso": 1,
    "camera": {"position": [0, -)" +
      away + ", " + away + R"(], "view_angle": 20, "view_up": [0, 0, 1]},
    "lights": [{"type": "directional", "direction": [-1, 0.4, -0.8]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [100, 100]},
      "mesostructure": {"technique": "relief", "filter": ")" +
      filter + R"(", "scale": 0.05,
      "tiles": [100, 100], "quality": "low", "effects": ["shading", "occlusion", "depth"],
      "height_map": {"pattern": ")" +
      pattern + R"(", "size": [64, 64]}}}] })",
    "field.json");
}

/// A file for a test's colours, gone with it: a checkerboard of texels.
class CheckersFile
{
public:
  CheckersFile()
    : Name(testing::TempDir() + "meso_checkers_" + std::to_string(getpid()) + ".png")
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(64, 64, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 64 * 64; ++i)
    {
      const bool bright = (i % 64 / 2 + i / 64 / 2) % 2 == 0;
      for (int channel = 0; channel < 3; ++channel)
      {
        *bytes++ = bright ? 255 : 0;
      }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->Name.c_str());
    writer->Write();
  }
  ~CheckersFile() { std::remove(this->Name.c_str()); }

  const std::string Name;
};

/// Close to a curved or flat base, cubic.
MesoScene CloseUp(const std::string& wrap, const std::string& technique)
{
  return MesoParseScene(R"({ "meso": 1,
    "camera": {"position": [0.5, -0.7, 0.6], "focal_point": [0.1, 0.05, 0], "view_up": [0, 0, 1],
               "view_angle": 35},
    "lights": [{"type": "directional", "direction": [-0.4, 0.5, -0.8]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [1, 1]},
      "mesostructure": {"technique": ")" +
      technique + R"(", "interpolation": "bicubic",
      "scale": 0.1, "tiles": [1.6, 1.6], "quality": "high", "wrap": ")" +
      wrap + R"(",
      "height_map": {"pattern": "noise", "size": [16, 16]}}}] })",
    "close.json");
}
}

TEST(ReliefSampling, CubicHeightsAreThoseOfTheReference)
{
  for (const char* technique : { "relief", "relief-quadric", "relief-quadric-exact" })
  {
    for (const char* wrap : { "repeat", "clamp", "mirror" })
    {
      const MesoScene scene = CloseUp(wrap, technique);
      const MesoAOVs truth = MesoAOVsOfImage(MesoReference(scene).Render(100, 80).AOVs);
      const MesoGeometryError error = MesoCompareGeometry(truth, DrawnAOVs(scene, 100, 80));
      std::cout << technique << " " << wrap << ": texcoord p99 " << error.Texcoord.P99
                << ", normal p95 " << error.Normal.P95 << ", cast " << error.ShadowCast << "\n";
      EXPECT_EQ(error.NanPixels, 0u);
      if (std::string(technique) == "relief-quadric-exact")
      {
        continue; // measures across the ray: another place on a plane as well
      }
      EXPECT_LT(error.Texcoord.P99, 1e-3) << technique << " " << wrap;
      EXPECT_LT(error.Normal.P95, 0.02) << technique << " " << wrap;
      EXPECT_LT(error.ShadowCast, 0.01) << technique << " " << wrap;
    }
  }
}

TEST(ReliefSampling, CubicAndBilinearHeightsDiffer)
{
  const MesoScene cubic = CloseUp("repeat", "relief");
  MesoScene bilinear = cubic;
  bilinear.Nodes[0].Mesostructure.Interpolation = MesoInterpolation::Bilinear;
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(cubic).Render(60, 48).AOVs);
  EXPECT_GT(MesoCompareGeometry(truth, DrawnAOVs(bilinear, 60, 48)).Normal.P95, 3.);
}

TEST(ReliefSampling, FromAfarTheAverageIsNearerToTheTruth)
{
  for (const char* pattern : { "noise", "smooth" })
  {
    const Picture truth = TruePicture(Field(60., "none", pattern), 40, 40, 36);
    const double averaged = Distance(truth, DrawnPicture(Field(60., "auto", pattern), 40, 40));
    const double single = Distance(truth, DrawnPicture(Field(60., "none", pattern), 40, 40));
    std::cout << pattern << ": from the truth " << averaged << ", without the filter " << single
              << "\n";
    EXPECT_LT(averaged, 0.6 * single) << pattern;
  }
}

TEST(ReliefSampling, SteepReliefKeepsItsBrightness)
{
  // What is seen of steep walls is their front: a mean that shows their backs as well is brighter.
  const auto meanOf = [](const Picture& picture)
  { return std::accumulate(picture.begin(), picture.end(), 0.) / double(picture.size()); };
  for (const char* pattern : { "brick", "stone" })
  {
    const auto scene = [&](const char* filter, MesoSearch search)
    {
      MesoScene field = Field(6., filter, pattern);
      field.Nodes[0].Map->Size = { 256, 256 };
      field.Nodes[0].Mesostructure.Scale = 0.1;
      field.Nodes[0].Mesostructure.Effects = {}; // all, as the truth has shadows
      field.Nodes[0].Mesostructure.Search = search;
      return field;
    };
    constexpr int Size = 24;
    const Picture truth = TruePicture(scene("none", MesoSearch::Certified), Size, Size, 9);
    for (MesoSearch search : { MesoSearch::LinearBinary, MesoSearch::Cone, MesoSearch::Certified })
    {
      const Picture filtered = DrawnPicture(scene("auto", search), Size, Size);
      const Picture single = DrawnPicture(scene("none", search), Size, Size);
      std::cout << pattern << ", " << MesoName(search) << ": from the truth "
                << Distance(truth, filtered) << ", without the filter " << Distance(truth, single)
                << ", brighter by " << meanOf(filtered) / meanOf(single) - 1. << "\n";
      EXPECT_NE(filtered, single) << pattern; // else nothing has been tried
      EXPECT_LT(Distance(truth, filtered), 1.03 * Distance(truth, single)) << pattern;
      EXPECT_NEAR(meanOf(filtered), meanOf(single), 0.05 * meanOf(single)) << pattern;
    }
  }
}

TEST(ReliefSampling, GentleReliefIsAsBrightAsTheTruth)
{
  // All of it is averaged away, with the shadows that it casts on itself: it shades as a rough surface.
  const auto meanOf = [](const Picture& picture)
  { return std::accumulate(picture.begin(), picture.end(), 0.) / double(picture.size()); };
  for (double down : { 0.8, 0.35 }) // the light's way; the flatter, the more is in shadow
  {
    const auto scene = [&](const char* filter, MesoSearch search)
    {
      MesoScene field = Field(12., filter, "noise");
      field.Lights[0].Direction[2] = -down;
      field.Nodes[0].Map->Size = { 256, 256 };
      field.Nodes[0].Mesostructure.Scale = 0.1;
      field.Nodes[0].Mesostructure.Effects = {};
      field.Nodes[0].Mesostructure.Search = search;
      return field;
    };
    constexpr int Size = 24;
    const Picture truth = TruePicture(scene("none", MesoSearch::Certified), Size, Size, 16);
    for (MesoSearch search : { MesoSearch::LinearBinary, MesoSearch::Certified })
    {
      const Picture filtered = DrawnPicture(scene("auto", search), Size, Size);
      const Picture single = DrawnPicture(scene("none", search), Size, Size);
      std::cout << MesoName(search) << ": from the truth " << Distance(truth, filtered)
                << ", without the filter " << Distance(truth, single) << ", brighter by "
                << meanOf(filtered) / meanOf(truth) - 1. << "\n";
      EXPECT_LT(Distance(truth, filtered), 0.5 * Distance(truth, single));
      EXPECT_NEAR(meanOf(filtered), meanOf(truth), 0.02 * meanOf(truth));
    }
    // A table has the shadows of all relief: they count but once.
    MesoScene looked = scene("auto", MesoSearch::LinearBinary);
    looked.Nodes[0].Mesostructure.Technique = MesoTechnique::VDM;
    const double ofTable = meanOf(DrawnPicture(looked, Size, Size));
    std::cout << "vdm: brighter by " << ofTable / meanOf(truth) - 1. << "\n";
    EXPECT_NEAR(ofTable, meanOf(truth), 0.02 * meanOf(truth));
  }
}

TEST(ReliefSampling, BacksAreTheBaseHoweverFar)
{
  const auto fromBelow = [](const char* filter)
  {
    MesoScene field = Field(12., filter);
    field.Camera.Position[2] = -12.;
    field.Lights[0].Direction[2] = 0.8;
    field.Nodes[0].Material.TwoSided = true;
    field.Nodes[0].Mesostructure.Effects = {};
    return DrawnPicture(field, 24, 24);
  };
  const Picture back = fromBelow("none");
  EXPECT_GT(*std::max_element(back.begin(), back.end()), 0.3);
  EXPECT_EQ(Distance(fromBelow("auto"), back), 0.);
}

TEST(ReliefSampling, GoingAwayThePictureNeverJumps)
{
  // From texels of many pixels to pixels of many texels in steps of 5 %: what changes from one frame to
  // the next never jumps, whatever level is drawn, and the far end is calm.
  double last = 0.;
  Picture before;
  std::vector<double> changes;
  for (double distance = 2.; distance < 30.; distance *= 1.05)
  {
    Picture picture = DrawnPicture(Field(distance, "auto"), 40, 40);
    if (!before.empty())
    {
      changes.push_back(Distance(before, picture));
    }
    before = std::move(picture);
  }
  for (std::size_t i = 1; i < changes.size(); ++i)
  {
    last = std::max(last, changes[i] - changes[i - 1]);
  }
  const Picture far = DrawnPicture(Field(29., "none"), 40, 40);
  const Picture farther = DrawnPicture(Field(30.45, "none"), 40, 40);
  std::cout << "largest rise from one change to the next " << last << ", last change "
            << changes.back() << ", without the filter " << Distance(far, farther) << "\n";
  EXPECT_LT(last, 0.02);
  EXPECT_LT(changes.back(), 0.2 * Distance(far, farther));
}

TEST(ReliefSampling, LevelsMeetWithoutALine)
{
  // A field to the horizon: all levels in one picture, of which no row stands out from its neighbours.
  MesoScene scene = Field(30., "auto");
  scene.Camera.Position = { 0., -45., 5. };
  constexpr int Size = 120;
  const Picture picture = DrawnPicture(scene, Size, Size);
  const auto meanOfRow = [&](int row)
  {
    double sum = 0.;
    for (int i = 0; i < 3 * Size; ++i)
    {
      sum += picture[std::size_t(row) * 3 * Size + i];
    }
    return sum / (3. * Size);
  };
  for (int row = 2; row < Size / 2 - 4; ++row)
  {
    EXPECT_LT(std::abs(meanOfRow(row) - 0.5 * (meanOfRow(row - 1) + meanOfRow(row + 1))), 0.03)
      << "row " << row;
  }
}

TEST(ReliefSampling, CertifiedFindsTheSameLevels)
{
  // By cones of the levels, where the others go in equal steps: the same pictures, near and far, straight and
  // over a quadric. A field to the horizon has all levels in one picture.
  for (const char* technique : { "relief", "relief-quadric" })
  {
    for (const MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Mirror })
    {
      MesoScene scene = Field(30., "auto");
      scene.Camera.Position = { 0., -6., 2. };
      scene.Nodes[0].Mesostructure.Technique = *MesoTechniqueFromName(technique);
      scene.Nodes[0].Mesostructure.Wrap = wrap;
      scene.Nodes[0].Mesostructure.Quality = MesoQuality::High;
      const Picture steps = DrawnPicture(scene, 80, 80);
      scene.Nodes[0].Mesostructure.Search = MesoSearch::Certified;
      const Picture certified = DrawnPicture(scene, 80, 80);
      scene.Nodes[0].Mesostructure.Filter = MesoFilter::None;
      const Picture unfiltered = DrawnPicture(scene, 80, 80);
      std::cout << technique << " " << MesoName(wrap) << ": from equal steps "
                << Distance(certified, steps) << ", from no filter "
                << Distance(certified, unfiltered) << "\n";
      EXPECT_LT(Distance(certified, steps), 0.004) << technique << " " << MesoName(wrap);
      EXPECT_GT(Distance(certified, unfiltered), 0.03) << technique << " " << MesoName(wrap);
    }
  }
}

TEST(ReliefSampling, NumbersAreOfTheMapItself)
{
  for (const MesoSearch search : { MesoSearch::LinearBinary, MesoSearch::Certified })
  {
    const auto numbers = [search](const char* filter)
    {
      MesoScene scene = Field(60., filter);
      scene.Nodes[0].Mesostructure.Search = search;
      return DrawnImage(scene, 40, 40).Data;
    };
    EXPECT_EQ(numbers("auto"), numbers("none")) << MesoName(search);
  }
}

TEST(ReliefSampling, ColoursDoNotStray)
{
  // A checkerboard far below the size of a pixel is gray: a pixel that is read at the wrong level is not.
  const CheckersFile file;
  MesoScene scene = Field(40., "none", "brick");
  scene.Nodes[0].Material.ColorMap = file.Name;
  scene.Nodes[0].Mesostructure.Effects = { false, { MesoEffect::Occlusion, MesoEffect::Depth } };
  scene.Nodes[0].Material.Ambient = 1.;
  scene.Nodes[0].Material.Diffuse = 0.;
  vtkNew<vtkRenderer> renderer;
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  EXPECT_EQ(
    builder.GetObjects().front().Actor->GetTexture()->GetMaximumAnisotropicFiltering(), 1.f);
  const Picture picture = DrawnPicture(scene, 120, 120);
  int stray = 0;
  int gray = 0;
  for (std::size_t i = 0; i < picture.size(); i += 3)
  {
    (std::abs(picture[i] - 0.5) > 0.1 ? stray : gray) += 1;
  }
  std::cout << stray << " of " << stray + gray << " pixels stray\n";
  EXPECT_GT(gray, 10000);
  EXPECT_LT(stray, 60);
}

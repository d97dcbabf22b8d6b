// Contour lines of heights: where they lie and how wide they are, against the closed form of a slope;
// their scene keys; nothing of them where they are off.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"
#include "MesoTiltedPlane.h"

#include "MesoSceneBuilder.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoTessellatedMapper.h"

#include "vtkRenderer.h"

namespace
{
constexpr int Size = 120;

/// Height u along the map, clamped: a slope from 0 to 1 between the first and the last texel centre.
vtkSmartPointer<vtkImageData> Slope(int texels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(texels, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < texels; ++i)
  {
    image->SetScalarComponentFromFloat(i, 0, 0, 0, static_cast<float>((i + 0.5) / texels));
  }
  return image;
}

/// A plane whose relief is the slope, as deep as `scale`, seen from the side.
struct SlopeScene : public MesoTiltedPlane
{
  SlopeScene(double degrees, double scale)
    : MesoTiltedPlane(degrees, scale, Slope(64), Size)
  {
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.Wrap = MesoWrap::Clamp;
    this->Mapper->SetOptions(options);
    this->Actor->GetProperty()->SetColor(1., 1., 1.);
    this->Actor->GetProperty()->SetAmbient(1.);
    this->Actor->GetProperty()->SetDiffuse(0.);
  }

  void Draw(const MesoContourLines& lines) { this->Mapper->SetContourLines(lines); }

  /// How black each column of the picture's middle row is, 0 to 1.
  std::vector<double> Black()
  {
    const auto picture = MesoGrabWindow(this->Window);
    std::vector<double> black;
    for (int column = 0; column < Size; ++column)
    {
      black.push_back(1. - picture->GetScalarComponentAsDouble(column, Size / 2, 0, 0) / 255.);
    }
    return black;
  }

  /// The height at the hit in the middle of a column: u = entry + depth tan(a) D and depth = 1 - u.
  double HeightAt(int column) const
  {
    const double travel = this->TravelU();
    return (this->EntryU(column) + travel) / (1. + travel);
  }
};

MesoContourLines EvenLines(double spacing, double width)
{
  MesoContourLines lines;
  lines.Spacing = spacing;
  lines.Width = width;
  return lines;
}
}

TEST(ContourLines, LieAtTheirHeightsAndAreAsWideAsTheySay)
{
  for (const double degrees : { 0., 40., 65. })
  {
    SlopeScene scene(degrees, 0.2);
    const double perColumn = scene.HeightAt(1) - scene.HeightAt(0);
    for (const double width : { 1., 2.5 })
    {
      MesoContourLines lines;
      lines.Heights = { 0.47, 0.6 };
      lines.Width = width;
      for (const bool even : { false, true })
      {
        if (even)
        {
          lines = EvenLines(0.1, width);
          lines.Offset = 0.03;
        }
        scene.Draw(lines);
        const auto black = scene.Black();
        double total = 0.;
        double moment = 0.;
        const double line = even ? 0.53 : 0.47;
        const int center = static_cast<int>(std::lround((line - scene.HeightAt(0)) / perColumn));
        ASSERT_GT(center, 8) << degrees;
        ASSERT_LT(center, Size - 8) << degrees;
        for (int column = center - 5; column <= center + 5; ++column)
        {
          total += black[column];
          moment += black[column] * scene.HeightAt(column);
        }
        // Colours have 255 steps, over at most 4 columns; whole pixels, each in its middle, place a
        // line that is no whole number of them wide to 1/16 of a pixel.
        EXPECT_NEAR(total, width, 0.01) << degrees << " even " << even;
        EXPECT_NEAR(moment / total, line, 0.065 * perColumn) << degrees << " even " << even;
      }
    }
  }
}

TEST(ContourLines, AreInkUnlitAndOverWhateverIsBelow)
{
  SlopeScene scene(30., 0.2);
  scene.Actor->GetProperty()->SetColor(0.2, 0.9, 0.3);
  scene.AddDirectionalLight(0.4, 0., -1.);
  scene.Actor->GetProperty()->SetDiffuse(0.7);
  scene.Actor->GetProperty()->SetAmbient(0.1);
  MesoContourLines lines;
  lines.Heights = { 0.5 };
  lines.Color = { 0.8, 0.4, 0.2 };
  lines.Width = 6.;
  const auto before = MesoGrabWindow(scene.Window);
  scene.Draw(lines);
  const auto picture = MesoGrabWindow(scene.Window);
  int ink = 0;
  int untouched = 0;
  for (int column = 0; column < Size; ++column)
  {
    std::array<double, 3> color;
    bool same = true;
    for (int k = 0; k < 3; ++k)
    {
      color[k] = picture->GetScalarComponentAsDouble(column, Size / 2, 0, k);
      same = same && color[k] == before->GetScalarComponentAsDouble(column, Size / 2, 0, k);
    }
    ink += color == std::array<double, 3>{ 204., 102., 51. } ? 1 : 0;
    untouched += same ? 1 : 0;
  }
  EXPECT_GE(ink, 4);
  EXPECT_GE(untouched, Size - 8);
}

TEST(ContourLines, AreTheSameOnTheDisplacedMesh)
{
  SlopeScene scene(40., 0.2);
  scene.Draw(EvenLines(0.125, 2.));
  const auto relief = scene.Black();
  vtkNew<vtkMesoDisplacedMesh> diced;
  diced->SetInputData(MesoTestScene::Shape("plane"));
  diced->SetHeightMapData(Slope(64));
  diced->SetScale(0.2);
  diced->SetWrap(MesoWrap::Clamp);
  diced->Update();
  vtkNew<vtkMesoTessellatedMapper> mapper;
  mapper->SetInputData(diced->GetOutput());
  scene.Actor->SetMapper(mapper);
  const auto without = scene.Black();
  mapper->SetContourLines(EvenLines(0.125, 2.));
  const auto tessellated = scene.Black();
  double lines = 0.;
  for (int column = 4; column < Size - 4; ++column)
  {
    lines += tessellated[column];
    // The search's own error, and that of a depth that a float interpolates.
    EXPECT_NEAR(relief[column], tessellated[column], 0.02) << column;
    EXPECT_EQ(without[column], 0.) << column;
  }
  EXPECT_GT(lines, 2. * 3.);
}

TEST(ContourLines, ThereAreNoneOnFlatGroundFromBehindAndWithoutRelief)
{
  MesoTestScene scene(Size, Size);
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(MesoTestScene::Shape("sphere"));
  mapper->SetHeightMap(MesoTestScene::Constant(0.5f));
  mapper->SetScale(0.1);
  scene.Actor->SetMapper(mapper);
  scene.AddHeadlight();
  scene.LookFrom(0., 0., 4.);
  const auto equalWithLines = [&]()
  {
    mapper->SetContourLines(MesoContourLines());
    const auto without = MesoGrabWindow(scene.Window);
    mapper->SetContourLines(EvenLines(0.25, 2.));
    return MesoCompareImages(MesoGrabWindow(scene.Window), without, MesoImageLimits::Exact())
      .Within;
  };
  EXPECT_TRUE(equalWithLines()) << "a plateau at a line's own height";
  mapper->SetHeightMap(MesoTestScene::Pattern("smooth"));
  EXPECT_FALSE(equalWithLines());
  mapper->SetHeightMap(nullptr);
  EXPECT_TRUE(equalWithLines()) << "no relief";
  mapper->SetHeightMap(MesoTestScene::Pattern("smooth"));
  scene.Actor->GetProperty()->BackfaceCullingOff();
  scene.Actor->GetProperty()->FrontfaceCullingOn();
  EXPECT_TRUE(equalWithLines()) << "from behind";
}

TEST(ContourLines, WrongNumbersAreRefusedAndTheOldOnesStay)
{
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetContourLines(EvenLines(0.25, 2.));
  MesoContourLines wrong = EvenLines(1e-9, 2.);
  const auto refused = [&](const char* message)
  {
    MesoExpectedMessages expected(message);
    mapper->SetContourLines(wrong);
    EXPECT_EQ(mapper->GetContourLines().Spacing, 0.25);
    return expected.GetCount();
  };
  EXPECT_EQ(refused("spacing"), 1);
  wrong = EvenLines(0.25, 0.);
  EXPECT_EQ(refused("width"), 1);
  wrong = EvenLines(0.25, 2.);
  wrong.Heights.assign(33, 0.5);
  EXPECT_EQ(refused("at most 32"), 1);
  wrong.Heights = { std::nan("") };
  EXPECT_EQ(refused("finite"), 1);
}

TEST(ContourLines, OfASceneCountHeightsOrTheMapsNumbers)
{
  const auto linesOf = [](const std::string& contours, const std::string& map)
  {
    MesoTestScene scene(Size, Size);
    scene.Renderer->RemoveAllViewProps();
    const std::string text = R"({ "meso": 1, "nodes": [{ "mesh": {"shape": "plane"},
      "material": {"contours": )" +
      contours + R"(}, "mesostructure": {"technique": "relief", "scale": 0.1, )" + map + "} }] }";
    MesoSceneBuilder builder;
    builder.Build(MesoParseScene(text, "test.json"), scene.Renderer);
    return builder.GetObjects().at(0).Mapper->GetContourLines();
  };
  const char* const heights = R"("height_map": {"pattern": "noise", "size": [16, 16]},
    "range": [-0.5, 1.5])";
  const char* const depths = R"("depth_map": {"pattern": "noise", "size": [16, 16]},
    "range": [-0.5, 1.5])";
  MesoContourLines lines = linesOf(R"({"spacing": 0.2, "width": 3, "color": [1, 0, 0]})", heights);
  EXPECT_EQ(lines.Spacing, 0.2);
  EXPECT_EQ(lines.Offset, 0.);
  EXPECT_EQ(lines.Width, 3.);
  EXPECT_EQ(lines.Color, (std::array<double, 3>{ 1., 0., 0. }));
  // Stored 0.3 is height 0.4; stored 0, a multiple of every spacing, is height 0.25.
  lines = linesOf(R"({"values": [0.3], "values_of": "map"})", heights);
  EXPECT_NEAR(lines.Heights.at(0), 0.4, 1e-12);
  lines = linesOf(R"({"spacing": 0.2, "values_of": "map"})", heights);
  EXPECT_NEAR(lines.Spacing, 0.1, 1e-12);
  EXPECT_NEAR(lines.Offset, 0.25, 1e-12);
  // As depths: stored 0.3 is height 0.6, stored 0 is 0.75.
  lines = linesOf(R"({"values": [0.3], "values_of": "map"})", depths);
  EXPECT_NEAR(lines.Heights.at(0), 0.6, 1e-12);
  lines = linesOf(R"({"spacing": 0.2, "values_of": "map"})", depths);
  EXPECT_NEAR(lines.Spacing, 0.1, 1e-12);
  EXPECT_NEAR(lines.Offset, 0.75, 1e-12);
}

// What the scene reader makes of good scene files: every served key, the defaults, file names.

#include "TemporaryFolder.h"

#include "MesoScene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
MesoScene Parse(const std::string& members)
{
  return MesoParseScene("{\"meso\": 1" + members + "}", "/scenes/one.json");
}

MesoSceneNode ParseNode(const std::string& members)
{
  return Parse(", \"nodes\": [{" + members + "}]").Nodes.at(0);
}

MesoMesostructureOptions ParseOptions(const std::string& members)
{
  return ParseNode(
    R"("mesh": "a.obj", "mesostructure": {"height_map": "h.png", "scale": 0.1, )" + members + "}")
    .Mesostructure;
}
}

TEST(SceneValues, EmptySceneHasTheDefaults)
{
  const MesoScene scene = Parse("");
  EXPECT_EQ(scene.File, "/scenes/one.json");
  ASSERT_EQ(scene.Lights.size(), 1u);
  EXPECT_EQ(scene.Lights[0].Type, MesoSceneLight::Kind::Headlight);
  EXPECT_EQ(scene.Camera.Position, (MesoVector3{ 0., 0., 5. }));
  EXPECT_EQ(scene.Camera.ViewAngle, 30.);
  EXPECT_FALSE(scene.Camera.ParallelScale);
  EXPECT_TRUE(scene.Nodes.empty());
  EXPECT_TRUE(Parse(R"(, "lights": [])").Lights.empty());
}

TEST(SceneValues, Camera)
{
  const auto camera = Parse(R"(, "background": [0.1, 0.2, 0.3], "camera": {"position": [1, 2, 3],
    "focal_point": [4, 5, 6], "view_up": [0, 0, 2], "view_angle": 45.5, "parallel_scale": 2,
    "clipping_range": [0.1, 100]})")
                        .Camera;
  EXPECT_EQ(camera.Position, (MesoVector3{ 1., 2., 3. }));
  EXPECT_EQ(camera.FocalPoint, (MesoVector3{ 4., 5., 6. }));
  EXPECT_EQ(camera.ViewUp, (MesoVector3{ 0., 0., 1. }));
  EXPECT_EQ(camera.ViewAngle, 45.5);
  EXPECT_EQ(camera.ParallelScale, 2.);
  EXPECT_EQ(camera.ClippingRange, (std::array<double, 2>{ 0.1, 100. }));
}

TEST(SceneValues, Lights)
{
  const auto lights = Parse(R"(, "lights": [
    {"type": "directional", "direction": [0, -3, 4], "color": [1, 0.5, 2], "intensity": 3,
     "shadow": false, "coordinates": "camera"},
    {"type": "point", "position": [1, 2, 3], "attenuation": [0, 0, 1]},
    {"type": "spot", "position": [0, 0, 9], "focal_point": [1, 0, 0], "cone_angle": 20,
     "exponent": 4, "coordinates": "world"}])")
                        .Lights;
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_EQ(lights[0].Type, MesoSceneLight::Kind::Directional);
  EXPECT_NEAR(lights[0].Direction[1], -0.6, 1e-15);
  EXPECT_NEAR(lights[0].Direction[2], 0.8, 1e-15);
  EXPECT_EQ(lights[0].Color, (MesoVector3{ 1., 0.5, 2. }));
  EXPECT_EQ(lights[0].Intensity, 3.);
  EXPECT_FALSE(lights[0].Shadow);
  EXPECT_TRUE(lights[0].InCameraCoordinates);
  EXPECT_EQ(lights[1].Type, MesoSceneLight::Kind::Point);
  EXPECT_EQ(lights[1].Attenuation, (MesoVector3{ 0., 0., 1. }));
  EXPECT_TRUE(lights[1].Shadow);
  EXPECT_EQ(lights[2].Type, MesoSceneLight::Kind::Spot);
  EXPECT_EQ(lights[2].ConeAngle, 20.);
  EXPECT_EQ(lights[2].Exponent, 4.);
  EXPECT_FALSE(lights[2].InCameraCoordinates);
}

TEST(SceneValues, Part)
{
  EXPECT_FALSE(ParseNode(R"("mesh": "a.obj")").Part);
  const MesoSceneNode node =
    ParseNode(R"("mesh": "a.obj", "part": {"by": "MesoCurvature[1]", "range": [-2, 0.5]})");
  EXPECT_EQ(node.Part->By, "MesoCurvature");
  EXPECT_EQ(node.Part->Component, 1);
  EXPECT_EQ(node.Part->Range, (std::array<double, 2>{ -2., 0.5 }));
  EXPECT_FALSE(ParseNode(R"("mesh": "a", "part": {"by": "v", "range": [0, 1]})").Part->Component);
}

TEST(SceneValues, MaterialAndFileNames)
{
  const MesoSceneNode node = ParseNode(R"("name": "pot", "mesh": "meshes/pot.obj",
    "feature_angle": 60, "material": {"color": [0.8, 0.7, 0.6], "color_map": "/maps/stone.png",
    "ambient": 0.1, "diffuse": 0.9, "specular": 0.2, "specular_power": 30, "opacity": 0.5,
    "two_sided": true, "edges": true})");
  EXPECT_EQ(node.Name, "pot");
  EXPECT_EQ(node.Mesh->File, "/scenes/meshes/pot.obj");
  EXPECT_EQ(node.Mesh->FeatureAngle, 60.);
  EXPECT_EQ(node.Material.ColorMap, "/maps/stone.png");
  EXPECT_EQ(node.Material.Color, (MesoVector3{ 0.8, 0.7, 0.6 }));
  EXPECT_EQ(node.Material.Ambient, 0.1);
  EXPECT_EQ(node.Material.Diffuse, 0.9);
  EXPECT_EQ(node.Material.Specular, 0.2);
  EXPECT_EQ(node.Material.SpecularPower, 30.);
  EXPECT_EQ(node.Material.Opacity, 0.5);
  EXPECT_TRUE(node.Material.TwoSided);
  EXPECT_TRUE(node.Material.Edges);
}

TEST(SceneValues, ColorBy)
{
  const auto colorBy = [](const std::string& members)
  {
    return *ParseNode(
      R"("mesh": "a.obj", "mesostructure": {"height_map": "h.png"}, "material": {)" + members + "}")
              .Material.ColorBy;
  };
  EXPECT_FALSE(ParseNode(R"("mesh": "a.obj", "material": {})").Material.ColorBy);
  const MesoSceneColorBy whole = colorBy(R"("color_by": "MesoCurvature")");
  EXPECT_EQ(whole.Array, "MesoCurvature");
  EXPECT_FALSE(whole.Component);
  EXPECT_EQ(whole.LookupTable, "");
  EXPECT_FALSE(whole.Range);
  EXPECT_FALSE(whole.IsHeight());
  const MesoSceneColorBy part = colorBy(
    R"("color_by": "a b[2][13]", "lookup_table": {"name": "coolwarm", "range": [-2, 0.5]})");
  EXPECT_EQ(part.Array, "a b[2]");
  EXPECT_EQ(part.Component, 13);
  EXPECT_EQ(part.LookupTable, "coolwarm");
  EXPECT_EQ(part.Range, (std::array<double, 2>{ -2., 0.5 }));
  EXPECT_TRUE(colorBy(R"("color_by": "height")").IsHeight());
}

TEST(SceneValues, ShapeAndPattern)
{
  const MesoSceneNode node = ParseNode(R"("mesh": {"shape": "plane", "size": [2, 3]},
    "mesostructure": {"technique": "relief", "depth_map": {"pattern": "brick", "size": [64, 32],
    "seed": 4294967295}, "range": [-1, 2], "sample_spacing": [0.5, 0.25], "scale": 0})");
  EXPECT_EQ(node.Mesh->Shape, "plane");
  EXPECT_EQ(node.Mesh->Parameters.at("size"), (std::vector<double>{ 2., 3. }));
  EXPECT_EQ(node.Mesh->Parameters.count("segments"), 0u);
  EXPECT_EQ(node.Map->Pattern, "brick");
  EXPECT_TRUE(node.Map->IsDepth);
  EXPECT_EQ(node.Map->Size, (std::array<int, 2>{ 64, 32 }));
  EXPECT_EQ(node.Map->Seed, 4294967295u);
  EXPECT_EQ(node.Map->Range, (std::array<double, 2>{ -1., 2. }));
  EXPECT_EQ(node.Map->SampleSpacing, (std::array<double, 2>{ 0.5, 0.25 }));
}

TEST(SceneValues, Mesostructure)
{
  const auto options = ParseOptions(R"("technique": "relief", "quality": "draft",
    "wrap": "mirror", "tiles": [6, 0.5], "effects": ["shading", "depth"])");
  EXPECT_EQ(options.Technique, MesoTechnique::Relief);
  EXPECT_EQ(options.Quality, MesoQuality::Draft);
  EXPECT_EQ(options.Wrap, MesoWrap::Mirror);
  EXPECT_EQ(options.Search, std::nullopt);
  EXPECT_EQ(MesoSearchOf(options), MesoSearch::LinearBinary);
  EXPECT_EQ(
    MesoSearchOf(ParseOptions(R"("search": "linear-secant", "technique": "relief-quadric")")),
    MesoSearch::LinearSecant);
  EXPECT_EQ(MesoSearchOf(ParseOptions(R"("quality": "certified", "technique": "relief")")),
    MesoSearch::Certified);
  EXPECT_EQ(MesoSearchOf(
              ParseOptions(R"("quality": "draft", "search": "certified", "technique": "relief")")),
    MesoSearch::Certified);
  EXPECT_EQ(options.Tiles, (std::array<double, 2>{ 6., 0.5 }));
  EXPECT_FALSE(options.Effects.Auto);
  EXPECT_EQ(options.Effects.Named, MesoEffects({ MesoEffect::Shading, MesoEffect::Depth }));
  EXPECT_TRUE(ParseOptions(R"("technique": "relief", "effects": "auto")").Effects.Auto);
  EXPECT_TRUE(ParseOptions(R"("technique": "relief", "effects": [])").Effects.Named.Empty());
  const auto all = ParseOptions(R"("effects": "all", "technique": "relief")").Effects;
  EXPECT_FALSE(all.Auto);
  EXPECT_EQ(all.Named, MesoEffectsOfTechnique(MesoTechnique::Relief));
}

TEST(SceneValues, Shells)
{
  const auto options = [](const std::string& members)
  { return ParseOptions(members + R"(, "wrap": "repeat")"); };
  const auto slices = options(R"("technique": "slices", "stack": "screen")");
  EXPECT_EQ(slices.Stack, MesoStack::Screen);
  EXPECT_EQ(options(R"("technique": "slices")").Stack, MesoStack::Prism);
  const auto rays = options(R"("technique": "gdm", "segments": 3, "exits": "interpolated")");
  EXPECT_EQ(rays.Segments, 3);
  EXPECT_EQ(rays.Exits, MesoExits::Interpolated);
}

TEST(SceneValues, TransformIsTranslateRotateScale)
{
  const auto matrix = ParseNode(R"("transform": {"scale": [2, 3, 4], "rotate": [90, 0, 0, 5],
    "translate": [10, 20, 30]})")
                        .Matrix;
  const std::array<double, 16> expected = { 0, -3, 0, 10, 2, 0, 0, 20, 0, 0, 4, 30, 0, 0, 0, 1 };
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(matrix[i], expected[i], 1e-15) << i;
  }
  EXPECT_EQ(ParseNode(R"("transform": {"scale": 0})").Matrix[0], 0.);
  EXPECT_EQ(ParseNode(R"("transform": {"matrix": [1,2,3,4, 5,6,7,8, 9,10,11,12, 0,0,0,1]})").Matrix,
    (std::array<double, 16>{ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1 }));
}

TEST(SceneValues, RotationOfGeneralAxisKeepsItAndIsOrthogonal)
{
  const auto m = ParseNode(R"("transform": {"rotate": [37, 1, -2, 0.5]})").Matrix;
  const double axis[3] = { 1., -2., 0.5 };
  for (int row = 0; row < 3; ++row)
  {
    double along = 0.;
    for (int column = 0; column < 3; ++column)
    {
      along += m[4 * row + column] * axis[column];
      double product = 0.;
      for (int k = 0; k < 3; ++k)
      {
        product += m[4 * row + k] * m[4 * column + k];
      }
      EXPECT_NEAR(product, row == column ? 1. : 0., 1e-15);
    }
    EXPECT_NEAR(along, axis[row], 1e-15);
  }
  EXPECT_NEAR(m[0] + m[5] + m[10], 1. + 2. * std::cos(37. * std::acos(-1.) / 180.), 1e-15);
}

TEST(SceneValues, ChildrenMakeATree)
{
  const MesoSceneNode node =
    ParseNode(R"("children": [{"name": "a"}, {"name": "b", "children": [{"name": "c"}]}])");
  ASSERT_EQ(node.Children.size(), 2u);
  EXPECT_EQ(node.Children[1].Children.at(0).Name, "c");
}

TEST(SceneValues, ReadsFromDiskAndChecksThatFilesAreThere)
{
  const TemporaryFolder folder;
  const std::string scene =
    folder.Write("scene.json", R"({"meso": 1, "nodes": [{"mesh": "a.obj"}]})");
  EXPECT_THROW(MesoReadScene(scene), MesoInputError);
  folder.Write("a.obj", "v 0 0 0\n");
  EXPECT_EQ(MesoReadScene(scene).Nodes.at(0).Mesh->File, folder.PathOf("a.obj"));
  EXPECT_THROW(MesoReadScene(folder.PathOf("none.json")), MesoInputError);
  EXPECT_THROW(MesoReadScene(folder.PathOf("")), MesoInputError);
}

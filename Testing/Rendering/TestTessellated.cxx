// The technique `tessellated` as it is drawn: VTK's own picture of the diced mesh, bit for bit, with
// every pixel's numbers as the closed form has them, and the outline of the detail.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"

#include "MesoHeightTexture.h"
#include "TemporaryFolder.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoTessellatedMapper.h"

#include "vtkCameraPass.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTexture.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
vtkSmartPointer<vtkPolyData> Dice(
  vtkPolyData* mesh, vtkImageData* map, double scale, std::array<double, 2> tiles, double facets)
{
  vtkNew<vtkMesoDisplacedMesh> filter;
  filter->SetInputData(mesh);
  filter->SetHeightMapData(map);
  filter->SetScale(scale);
  filter->SetTiles(tiles[0], tiles[1]);
  filter->SetFacetsPerTexel(facets);
  filter->Update();
  return filter->GetOutput();
}

class Tessellated : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoTessellatedMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  Tessellated()
  {
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }
  ~Tessellated() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void UseTorus()
  {
    this->Mapper->SetInputData(Dice(
      MesoTestScene::Shape("torus"), MesoTestScene::Pattern("brick", 32, 32), 0.1, { 6., 3. }, 1.));
  }

  /// The same geometry by VTK's mapper and by ours.
  void ExpectVTKsPicture(const char* what)
  {
    vtkNew<vtkPolyDataMapper> theirs;
    theirs->SetInputData(this->Mapper->GetInput());
    this->Scene.Actor->SetMapper(theirs);
    const auto expected = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->SetMapper(this->Mapper);
    const auto ours = MesoGrabWindow(this->Scene.Window);
    const auto difference = MesoCompareImages(ours, expected, MesoImageLimits::Exact());
    EXPECT_TRUE(difference.Within) << what << ": " << difference.Describe();
    this->Scene.Actor->VisibilityOff();
    EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), ours).Within) << what;
    this->Scene.Actor->VisibilityOn();
  }

  /// A parallel camera that looks down the z axis from 5, [-half, half] high.
  void LookDown(double half)
  {
    this->Scene.LookFrom(0., 0., 5.);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  double Value(const char* channel, int column, int row) const
  {
    return this->Pass->GetValue(channel, column, row);
  }

  int Covered()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }
};
}

TEST_F(Tessellated, IsVTKsPictureOfTheSameGeometry)
{
  this->UseTorus();
  this->ExpectVTKsPicture("one light");
  this->Scene.AddHeadlight();
  this->Scene.Actor->GetProperty()->SetSpecular(0.3);
  this->Scene.Actor->GetProperty()->SetSpecularPower(20.);
  this->ExpectVTKsPicture("specular");
  const auto before = MesoGrabWindow(this->Scene.Window);
  MesoCapture(this->Scene, this->Pass);
  const auto after = MesoGrabWindow(this->Scene.Window);
  EXPECT_TRUE(MesoCompareImages(after, before, MesoImageLimits::Exact()).Within);
  this->ExpectVTKsPicture("after AOVs");
  this->Scene.Actor->GetProperty()->EdgeVisibilityOn();
  this->ExpectVTKsPicture("edges");
  this->Scene.Actor->GetProperty()->EdgeVisibilityOff();
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const unsigned char colours[] = { 250, 20, 20, 20, 250, 20, 20, 20, 250, 250, 250, 20 };
  std::copy(
    std::begin(colours), std::end(colours), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  this->Scene.Actor->SetTexture(texture);
  this->ExpectVTKsPicture("textured");
}

TEST_F(Tessellated, ShadowMapsAndClippingAreVTKs)
{
  this->UseTorus();
  vtkNew<vtkLight> sun; // which is no headlight, and not behind the torus' hole
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(1., 4., 2.);
  sun->SetFocalPoint(0., 0., 0.);
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.Renderer->AddLight(sun);
  const auto unshadowed = MesoGrabWindow(this->Scene.Window);
  vtkNew<vtkShadowMapPass> shadows;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  this->Scene.Renderer->SetPass(camera);
  this->ExpectVTKsPicture("shadow maps");
  EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), unshadowed).Within);
  camera->ReleaseGraphicsResources(this->Scene.Window);
  this->Scene.Renderer->SetPass(nullptr);

  vtkNew<vtkPlane> plane;
  plane->SetNormal(1., 0.3, 0.);
  vtkNew<vtkPolyDataMapper> theirs;
  theirs->SetInputData(this->Mapper->GetInput());
  theirs->AddClippingPlane(plane);
  this->Mapper->AddClippingPlane(plane);
  this->Scene.Actor->SetMapper(theirs);
  const auto clipped = MesoGrabWindow(this->Scene.Window);
  EXPECT_FALSE(MesoCompareImages(clipped, unshadowed).Within);
  this->Scene.Actor->SetMapper(this->Mapper);
  EXPECT_TRUE(
    MesoCompareImages(MesoGrabWindow(this->Scene.Window), clipped, MesoImageLimits::Exact())
      .Within);
}

TEST_F(Tessellated, OrdinaryFramesHoldNothingMore)
{
  this->UseTorus();
  this->Scene.Window->Render();
  const std::size_t before = this->Mapper->GetGPUBytes();
  const vtkIdType points = this->Mapper->GetInput()->GetNumberOfPoints();
  const vtkIdType triangles = this->Mapper->GetInput()->GetNumberOfPolys();
  // Position and normal, 3 floats each, and VTK's texture coordinate; an index a corner.
  EXPECT_EQ(before, std::size_t(32 * points + 12 * triangles));
  MesoCapture(this->Scene, this->Pass);
  EXPECT_GE(this->Mapper->GetGPUBytes(), before + 4 * points);
  this->Scene.Window->Render();
  EXPECT_EQ(this->Mapper->GetGPUBytes(), before);
}

TEST_F(Tessellated, OrdinaryShadersKnowNothingOfIt)
{
  const TemporaryFolder folder;
  setenv("MESO_DUMP_SHADERS", folder.PathOf("").c_str(), 1);
  const auto shadersThatKnow = [&]()
  {
    int all = 0;
    int know = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder.PathOf("")))
    {
      std::ifstream stream(file.path());
      std::stringstream text;
      text << stream.rdbuf();
      ++all;
      know += text.str().find("mesoRelief") == std::string::npos ? 0 : 1;
    }
    EXPECT_GE(all, 2);
    return know;
  };
  this->UseTorus();
  this->Scene.Window->Render();
  EXPECT_EQ(shadersThatKnow(), 0);
  MesoCapture(this->Scene, this->Pass);
  EXPECT_EQ(shadersThatKnow(), 2); // vertex and fragment stage
  unsetenv("MESO_DUMP_SHADERS");
}

TEST_F(Tessellated, NumbersAreThoseOfTheClosedForm)
{
  const double scale = 0.2;
  const std::array<double, 2> tiles = { 2., 1. };
  const int size = 16;
  const auto map = MesoTestScene::Pattern("smooth", size, size);
  const auto* texels = static_cast<const float*>(map->GetScalarPointer());
  const MesoHeightTexture<double> texture(
    size, size, MesoWrap::Repeat, std::vector<float>(texels, texels + size * size));
  this->Mapper->SetInputData(Dice(MesoTestScene::Shape("plane"), map, scale, tiles, 8.));
  this->Mapper->SetTiles(tiles[0], tiles[1]);
  this->Pass->SetObjectNumber(this->Scene.Actor, 3);
  this->LookDown(0.45);
  EXPECT_EQ(this->Covered(), 150 * 150);

  double worst[3] = { 0., 0., 0. }; // relief, depth, normal
  int lit[2] = { 0, 0 };
  int wrongShadows = 0;
  for (int row = 0; row < 150; ++row)
  {
    for (int column = 0; column < 150; ++column)
    {
      const double u = ((column + 0.5) / 150. * 2. - 1.) * 0.45 + 0.5;
      const double v = (1. - (row + 0.5) / 150. * 2.) * 0.45 + 0.5;
      const double s = tiles[0] * u;
      const double t = tiles[1] * v;
      const double relief = 1. - texture.sampleHeight({ s, t });
      // Coordinates of floats, interpolated.
      EXPECT_NEAR(this->Value("texcoord.u", column, row), s, 2e-5);
      EXPECT_NEAR(this->Value("texcoord.v", column, row), t, 2e-5);
      EXPECT_EQ(this->Value("object", column, row), 3.);
      EXPECT_EQ(this->Value("fetches", column, row), 0.);
      worst[0] = std::max(worst[0], std::abs(this->Value("relief", column, row) - relief));
      worst[1] =
        std::max(worst[1], std::abs(this->Value("depth", column, row) - 5. - scale * relief));
      const double texel = 1. / size;
      const auto slope = [&](double step, double ds, double dt)
      {
        return (texture.sampleHeight({ s + step * ds, t + step * dt }) -
                 texture.sampleHeight({ s - step * ds, t - step * dt })) /
          (2. * step);
      };
      double normal[3] = { -scale * slope(texel, 1., 0.) * tiles[0],
        -scale * slope(texel, 0., 1.) * tiles[1], 1. };
      const double length = std::hypot(normal[0], normal[1], normal[2]);
      const char* const names[] = { "normal.x", "normal.y", "normal.z" };
      for (int k = 0; k < 3; ++k)
      {
        worst[2] =
          std::max(worst[2], std::abs(this->Value(names[k], column, row) - normal[k] / length));
      }
      // Which way the bilinear patch faces, where that is clear: the light comes from (1, 2, 1).
      const double facing =
        1. - scale * slope(1e-4, 1., 0.) * tiles[0] - 2. * scale * slope(1e-4, 0., 1.) * tiles[1];
      const auto offCrease = [&](double coordinate)
      {
        const double within = coordinate * size - 0.5 - std::floor(coordinate * size - 0.5);
        return within > 0.25 && within < 0.75;
      };
      if (std::abs(facing) > 0.3 && offCrease(s) && offCrease(t))
      {
        ++lit[facing > 0. ? 1 : 0];
        wrongShadows += this->Value("shadow.0", column, row) == (facing > 0. ? 0. : 1.) ? 0 : 1;
      }
    }
  }
  // The slope changes by up to 0.5 (6 pi / 16)^2 = 0.7 a texel at a crease between texels; an eighth of
  // a texel wide, a facet across it is off by a quarter of that product at most: 0.02. Its normals
  // change by no more than the same slopes, times the scale, in an eighth of a texel.
  EXPECT_LT(worst[0], 1e-2);
  EXPECT_LT(worst[1], scale * 1e-2 + 1e-5);
  EXPECT_LT(worst[2], 1e-2);
  EXPECT_GT(lit[0], 100);
  EXPECT_GT(lit[1], 1000);
  EXPECT_EQ(wrongShadows, 0);
}

TEST_F(Tessellated, PixelsLieOnTheirRays)
{
  // Seen at an angle, pixel, depth, relief and map coordinate are of one point.
  const double scale = 0.2;
  this->Mapper->SetInputData(Dice(
    MesoTestScene::Shape("plane"), MesoTestScene::Pattern("brick", 32, 32), scale, { 1., 1. }, 2.));
  this->Scene.LookFrom(0.8, 0.5, 1.2);
  EXPECT_GT(this->Covered(), 5000);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  double position[3];
  double axis[3];
  camera->GetPosition(position);
  camera->GetDirectionOfProjection(axis);
  double worst = 0.;
  for (int row = 0; row < 150; ++row)
  {
    for (int column = 0; column < 150; ++column)
    {
      if (this->Value("coverage", column, row) == 0.)
      {
        continue;
      }
      const double point[3] = { this->Value("texcoord.u", column, row) - 0.5,
        this->Value("texcoord.v", column, row) - 0.5, -scale * this->Value("relief", column, row) };
      double depth = 0.;
      for (int k = 0; k < 3; ++k)
      {
        depth += (point[k] - position[k]) * axis[k];
      }
      worst = std::max(worst, std::abs(depth - this->Value("depth", column, row)));
    }
  }
  EXPECT_LT(worst, 1e-5); // floats of about 1.5
}

TEST_F(Tessellated, OutlineIsThatOfTheDetail)
{
  const std::map<std::string, std::vector<double>> fine = { { "rings", { 64. } },
    { "sides", { 128. } } };
  const auto sphere = MesoTestScene::Shape("sphere", fine);
  this->LookDown(1.2);
  this->Mapper->SetInputData(sphere);
  const int base = this->Covered();
  const auto map = MesoTestScene::Constant(0.f);
  this->Mapper->SetInputData(Dice(sphere, map, 0.25, { 1., 1. }, 1.));
  const int displaced = this->Covered();
  std::vector<float> outline = this->Pass->GetChannel("coverage");

  auto smaller = fine;
  smaller["radius"] = { 0.75 };
  this->Mapper->SetInputData(MesoTestScene::Shape("sphere", smaller));
  EXPECT_NEAR(this->Covered(), displaced, 2);
  const std::vector<float> expected = this->Pass->GetChannel("coverage");
  int different = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    different += outline[i] == expected[i] ? 0 : 1;
  }
  EXPECT_LE(different, 2); // pixels' centres within rounding of the outline
  const double pixels = std::pow(150. / 2.4, 2.) * std::acos(-1.);
  EXPECT_NEAR(base / pixels, 1., 0.01);
  EXPECT_NEAR(displaced / pixels, 0.75 * 0.75, 0.01);
}

TEST_F(Tessellated, EveryPixelIsSound)
{
  this->UseTorus();
  const int covered = this->Covered();
  EXPECT_GT(covered, 3000);
  this->Scene.Actor->GetProperty()->EdgeVisibilityOn(); // a geometry shader
  EXPECT_NEAR(this->Covered(), covered, 0.02 * covered);
  const std::vector<float> reliefs = this->Pass->GetChannel("relief");
  EXPECT_GT(*std::max_element(reliefs.begin(), reliefs.end()), 0.5f);
  this->Scene.Actor->GetProperty()->EdgeVisibilityOff();
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  this->Covered();
  this->Scene.Actor->GetProperty()->SetInterpolationToFlat();
  this->Covered();
}

TEST_F(Tessellated, MeshesWithoutReliefHaveNone)
{
  this->UseTorus();
  this->Mapper->GetInput()->GetPointData()->RemoveArray("MesoRelief");
  EXPECT_GT(this->Covered(), 3000);
  for (float relief : this->Pass->GetChannel("relief"))
  {
    ASSERT_EQ(relief, 0.f);
  }
}

TEST_F(Tessellated, BoundsAreThoseOfTheDisplacedMesh)
{
  this->Mapper->SetInputData(
    Dice(MesoTestScene::Shape("sphere"), MesoTestScene::Constant(0.5f), 0.5, { 1., 1. }, 0.1));
  double bounds[6];
  this->Mapper->GetBounds(bounds);
  EXPECT_NEAR(bounds[2], -0.75, 1e-6);
  EXPECT_NEAR(bounds[3], 0.75, 1e-6);
}

TEST_F(Tessellated, EffectsAreSaid)
{
  this->UseTorus();
  this->Scene.Window->Render();
  EXPECT_EQ(this->Mapper->GetEffectsDrawn(),
    MesoEffects(
      { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::Depth, MesoEffect::Silhouette }));
  EXPECT_TRUE(this->Mapper->GetWhyPlain().empty());
}

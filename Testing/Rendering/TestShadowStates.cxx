// What vtkMesoShadowMapPass must not do: shade what is lit, draw or keep what it need not.

#include "MesoBaseline.h"
#include "MesoImageDifference.h"
#include "MesoTestScene.h"
#include "ShadowComparison.h"
#include "vtkMesoReliefMapper.h"

#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyDataMapper.h"
#include "vtk_glew.h"

#include <cmath>
#include <ostream>

namespace
{
/// An object with something far off that its light never meets.
struct LoneCase
{
  const char* Name;
  const char* Object;
};

void PrintTo(const LoneCase& one, std::ostream* stream)
{
  *stream << one.Name;
}

const LoneCase LoneCases[] = {
  { "ReliefPlane", R"({"transform": {"rotate": [-90, 1, 0, 0]}, "mesh": {"shape": "plane"},
    "mesostructure": {"technique": "relief", "scale": 0.08, "tiles": [2, 2],
      "height_map": {"pattern": "brick", "size": [128, 128]}}})" },
  { "ReliefCylinder", R"({"mesh": {"shape": "cylinder", "radius": 0.5, "height": 1.2},
    "mesostructure": {"technique": "relief-quadric", "scale": 0.06, "tiles": [4, 2],
      "height_map": {"pattern": "brick", "size": [128, 128]}}})" },
  { "ReliefSphere", R"({"mesh": {"shape": "sphere", "radius": 0.6},
    "mesostructure": {"technique": "relief-quadric", "scale": 0.06, "tiles": [6, 3],
      "height_map": {"pattern": "smooth", "size": [128, 128]}}})" },
  { "PlainSphere", R"({"mesh": {"shape": "sphere", "radius": 0.6}})" },
  { "PlainCoarseSphere", R"({"mesh": {"shape": "sphere", "radius": 0.6, "rings": 6,
    "sides": 12}})" },
};

class LoneObject : public testing::TestWithParam<LoneCase>
{
};

MesoScene LoneScene(const std::string& object, const std::string& light)
{
  return ShadowSceneOf(R"("camera": {"position": [0.5, 1.6, 2.2], "focal_point": [0, 0, 0],
    "view_angle": 32}, "lights": [)" +
    light + R"(], "nodes": [)" + object +
    R"(, {"transform": {"translate": [-3, -3, 3]}, "mesh": {"shape": "sphere", "radius": 0.1}}])");
}

std::string Sun(double elevation)
{
  const double angle = elevation * std::acos(-1.) / 180.;
  return R"({"type": "directional", "direction": [)" + std::to_string(-std::cos(angle)) + ", " +
    std::to_string(-std::sin(angle)) + ", -0.1]}";
}

/// Smallest unused name of a texture: it grows where textures are left over.
GLuint NextTexture(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLuint name = 0;
  glGenTextures(1, &name);
  glDeleteTextures(1, &name);
  return name;
}

/// A ball over a floor with one light, in which things are switched.
class Switched : public testing::Test
{
protected:
  MesoTestScene Scene{ 120, 120 };
  vtkNew<vtkActor> Ball;
  vtkNew<vtkPolyDataMapper> FloorMapper;
  vtkNew<vtkMesoPolyDataMapper> BallMapper;
  vtkNew<vtkMesoShadowMapPass> Shadows;
  vtkLight* Light = nullptr;

  Switched()
  {
    this->FloorMapper->SetInputData(MesoTestScene::Shape("plane", { { "size", { 4., 4. } } }));
    this->Scene.Actor->SetMapper(this->FloorMapper);
    this->BallMapper->SetInputData(MesoTestScene::Shape("sphere", { { "radius", { 0.5 } } }));
    this->Ball->SetMapper(this->BallMapper);
    this->Ball->SetPosition(0., 0., 1.);
    this->Scene.Renderer->AddActor(this->Ball);
    this->Light = this->Scene.AddDirectionalLight(0.6, 0.2, -1.);
    this->Scene.LookFrom(0., -3., 5., 40.);
    this->Shadows->SetResolution(256);
    this->Scene.Renderer->SetPass(this->Shadows);
  }

  ~Switched() override { this->Shadows->ReleaseGraphicsResources(this->Scene.Window); }

  vtkSmartPointer<vtkImageData> Grab() { return MesoGrabWindow(this->Scene.Window); }

  static int Changed(vtkImageData* a, vtkImageData* b)
  {
    return MesoCompareImages(a, b).LargePixels;
  }
};
}

TEST_P(LoneObject, IsNotShadedTwice)
{
  for (const double elevation : { 60., 20., 6. })
  {
    for (const bool spot : { false, true })
    {
      const double angle = elevation * std::acos(-1.) / 180.;
      const std::string light = spot
        ? R"({"type": "spot", "focal_point": [0, 0, 0], "cone_angle": 60, "position": [)" +
          std::to_string(3. * std::cos(angle)) + ", " + std::to_string(3. * std::sin(angle)) +
          ", 0.3]}"
        : Sun(elevation);
      const MesoScene lone = LoneScene(GetParam().Object, light);
      const std::vector<float> truth =
        ChannelOf(MesoReference(lone).Render(120, 120).AOVs, "shadow.0");
      DrawnScene scene(lone, 120, 120);
      const std::vector<float> with = scene.Channel("shadow.0");
      ASSERT_TRUE(scene.Shadows());
      EXPECT_EQ(scene.Shadows()->GetNumberOfMaps(), 1);
      scene.Renderer->SetPass(nullptr);
      const std::vector<float> without = scene.Channel("shadow.0");
      const std::vector<float> object = scene.Channel("object");
      int lit = 0;
      int darker = 0;
      int lighter = 0;
      for (std::size_t i = 0; i < with.size(); ++i)
      {
        // Pixels that are lit in truth, and by the object's own technique alone.
        const bool isLit = object[i] == 1.f && truth[i] < 0.5f && without[i] < 0.5f;
        lit += isLit ? 1 : 0;
        darker += isLit && with[i] >= 0.5f ? 1 : 0;
        lighter += with[i] < without[i] ? 1 : 0;
      }
      EXPECT_EQ(lighter, 0);
      EXPECT_LE(darker, 0.001 * lit) << elevation << " degrees, " << (spot ? "spot" : "sun") << ", "
                                     << darker << " of " << lit << " lit pixels are dark";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Objects, LoneObject, testing::ValuesIn(LoneCases),
  [](const auto& info) { return std::string(info.param.Name); });

TEST_F(Switched, LightsAndObjectsMakeTheirShadows)
{
  const auto shadowed = this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 1);
  this->Scene.Renderer->SetPass(nullptr);
  const auto bare = this->Grab();
  this->Scene.Renderer->SetPass(this->Shadows);
  ASSERT_GT(Changed(shadowed, bare), 400);

  // Each way of having no shadows gives the picture without the pass, bit for bit, and back.
  const auto expectBare = [&](const char* what)
  {
    EXPECT_TRUE(MesoCompareImages(this->Grab(), bare, MesoImageLimits::Exact()).Within) << what;
    EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 0) << what;
  };
  const auto expectShadowed = [&](const char* what)
  {
    EXPECT_TRUE(MesoCompareImages(this->Grab(), shadowed, MesoImageLimits::Exact()).Within) << what;
    EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 1) << what;
  };
  this->Light->SetShadowAttenuation(0.f);
  expectBare("a light without shadows");
  this->Light->SetShadowAttenuation(1.f);
  expectShadowed("a light with shadows again");
  MesoMesostructureOptions options = this->BallMapper->GetOptions();
  options.Effects.Auto = false;
  this->BallMapper->SetOptions(options);
  expectBare("an object without the effect");
  EXPECT_FALSE(this->BallMapper->GetEffectsDrawn().Has(MesoEffect::CastShadow));
  options.Effects.Auto = true;
  this->BallMapper->SetOptions(options);
  expectShadowed("an object with the effect again");
  EXPECT_TRUE(this->BallMapper->GetEffectsDrawn().Has(MesoEffect::CastShadow));

  // More lights and fewer.
  this->Light->SetIntensity(0.5);
  const auto half = this->Grab();
  vtkLight* other = this->Scene.AddDirectionalLight(-0.6, 0.2, -1.);
  other->SetIntensity(0.5);
  EXPECT_GT(Changed(this->Grab(), half), 400);
  EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 2);
  other->SwitchOff();
  EXPECT_TRUE(MesoCompareImages(this->Grab(), half, MesoImageLimits::Exact()).Within);
  other->SwitchOn();
  other->PositionalOn();
  other->SetPosition(-1., -1., 3.);
  other->SetConeAngle(90.);
  this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 1 + 6) << "a point light";
  this->Scene.Renderer->RemoveLight(other);
  EXPECT_TRUE(MesoCompareImages(this->Grab(), half, MesoImageLimits::Exact()).Within);
  this->Light->SetLightTypeToHeadlight();
  this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfMaps(), 0) << "a headlight";
}

TEST_F(Switched, ALightThatIsHalfBlockedIsHalfAsBright)
{
  // A pixel of the floor in the middle of the ball's shadow.
  const auto at = [](vtkImageData* image, int x, int y)
  { return image->GetScalarComponentAsDouble(x, y, 0, 1); };
  this->Scene.Renderer->SetPass(nullptr);
  const auto bare = this->Grab();
  this->Scene.Renderer->SetPass(this->Shadows);
  const auto dark = this->Grab();
  this->Light->SetShadowAttenuation(0.5f);
  const auto half = this->Grab();
  int pixels = 0;
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      if (at(bare, x, y) > 50. && at(dark, x, y) == 0.)
      {
        ++pixels;
        EXPECT_NEAR(at(half, x, y), 0.5 * at(bare, x, y), 1.) << x << " " << y;
      }
    }
  }
  EXPECT_GT(pixels, 400);
}

TEST_F(Switched, MapsAreDrawnAnewOnlyWhereSomethingHasChanged)
{
  this->Grab();
  const int first = this->Shadows->GetNumberOfBakes();
  EXPECT_EQ(first, 1);
  this->Scene.LookFrom(1., -3., 5., 40.);
  this->Scene.Window->SetSize(90, 140);
  const auto before = this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfBakes(), first) << "the camera, the window";
  this->Ball->SetPosition(0.3, 0., 1.);
  EXPECT_GT(Changed(this->Grab(), before), 20);
  EXPECT_EQ(this->Shadows->GetNumberOfBakes(), first + 1) << "an object has moved";
  this->Light->SetPosition(-1., 0., 1.);
  this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfBakes(), first + 2) << "the light has moved";
  MesoMesostructureOptions options = this->BallMapper->GetOptions();
  options.Tiles = { 2., 2. };
  this->BallMapper->SetOptions(options);
  this->Grab();
  EXPECT_EQ(this->Shadows->GetNumberOfBakes(), first + 3) << "its detail has changed";
}

TEST_F(Switched, NothingIsLeftOverByWindowsAndSizes)
{
  this->Grab();
  const std::size_t bytes = this->Shadows->GetGPUBytes();
  EXPECT_EQ(bytes, std::size_t(12) * 256 * 256);
  const auto change = [&](int step)
  {
    this->Scene.Window->SetSize(80 + 10 * step, 120 - 10 * step);
    this->Light->SetPosition(-1., 0.1 * step, 1.);
    this->Shadows->SetResolution(step % 2 == 0 ? 256 : 128);
    this->Grab();
  };
  change(0);
  change(1);
  const GLuint before = NextTexture(this->Scene.Window);
  constexpr int steps = 20;
  for (int step = 2; step < steps; ++step)
  {
    change(step % 4);
  }
  EXPECT_LT(NextTexture(this->Scene.Window), before + steps / 4) << "names are taken and not given";

  // Another window takes the renderer, shadows and all.
  this->Shadows->SetResolution(256);
  this->Scene.Window->SetSize(120, 120);
  const auto here = this->Grab();
  this->Shadows->ReleaseGraphicsResources(this->Scene.Window);
  EXPECT_EQ(this->Shadows->GetGPUBytes(), 0u);
  this->Scene.Window->RemoveRenderer(this->Scene.Renderer);
  {
    vtkNew<vtkMesoEGLRenderWindow> other;
    other->SetMultiSamples(0);
    other->SetSize(120, 120);
    other->AddRenderer(this->Scene.Renderer);
    EXPECT_TRUE(MesoCompareImages(MesoGrabWindow(other), here, MesoImageLimits::Exact()).Within);
    this->Shadows->ReleaseGraphicsResources(other);
    other->RemoveRenderer(this->Scene.Renderer);
  }
  this->Scene.Window->AddRenderer(this->Scene.Renderer);
  EXPECT_TRUE(MesoCompareImages(this->Grab(), here, MesoImageLimits::Exact()).Within);
}

TEST_F(Switched, OtherMappersAndMaterialsTakeShadows)
{
  // The floor is VTK's own mapper's already. By physical materials VTK's lighting is used as well.
  for (const bool own : { false, true })
  {
    if (own)
    {
      vtkNew<vtkMesoPolyDataMapper> mapper;
      mapper->SetInputData(this->FloorMapper->GetInput());
      this->Scene.Actor->SetMapper(mapper);
    }
    this->Scene.Actor->GetProperty()->SetInterpolationToPBR();
    const auto shadowed = this->Grab();
    this->Scene.Renderer->SetPass(nullptr);
    const auto bare = this->Grab();
    this->Scene.Renderer->SetPass(this->Shadows);
    EXPECT_GT(Changed(shadowed, bare), 300) << own;
  }
}

namespace
{
/// Techniques that draw the mesh as it is, with the shading of relief.
class ShadedMesh : public testing::TestWithParam<const char*>
{
protected:
  static MesoScene BallOverFloor(const std::string& technique)
  {
    return ShadowSceneOf(R"("camera": {"position": [0.5, 2.2, 2.6], "focal_point": [0, 0, 0],
      "view_angle": 40}, "lights": [{"type": "directional", "direction": [0.7, -1, 0.2]}],
      "nodes": [{"transform": {"translate": [0, -0.7, 0], "rotate": [-90, 1, 0, 0]},
        "mesh": {"shape": "plane", "size": [4, 4]}, "mesostructure": {"technique": ")" +
      technique + R"(", "scale": 0.01, "height_map": {"pattern": "smooth", "size": [32, 32]}}},
        {"mesh": {"shape": "sphere", "radius": 0.5}, "mesostructure": {"technique": ")" +
      technique + R"(", "scale": 0.03, "tiles": [4, 2],
          "height_map": {"pattern": "brick", "size": [64, 64]}}}])");
  }

  /// The pixels of the floor where the light is blocked by the ball.
  static std::vector<bool> ShadowOnFloor(DrawnScene& scene)
  {
    scene.Capture();
    const std::vector<float> objects = scene.Pass->GetChannel("object");
    const std::vector<float> shadows = scene.Pass->GetChannel("shadow.0");
    std::vector<bool> shadowed;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
      shadowed.push_back(objects[i] == 1.f && shadows[i] > 0.5f);
    }
    return shadowed;
  }
};
}

// Floor and ball cast and take shadows as their meshes do.
TEST_P(ShadedMesh, CastsAsItsMesh)
{
  DrawnScene plain(BallOverFloor("plain"), 120, 90);
  DrawnScene shaded(BallOverFloor(GetParam()), 120, 90);
  const std::vector<bool> ofMesh = ShadowOnFloor(plain);
  const std::vector<bool> ofShaded = ShadowOnFloor(shaded);
  const auto pixels = std::count(ofMesh.begin(), ofMesh.end(), true);
  ASSERT_GT(pixels, 300);
  int differ = 0;
  for (std::size_t i = 0; i < ofMesh.size(); ++i)
  {
    differ += ofMesh[i] != ofShaded[i] ? 1 : 0;
  }
  EXPECT_LT(differ, pixels / 50);
}

INSTANTIATE_TEST_SUITE_P(
  Technique, ShadedMesh, testing::Values("bump", "normal", "normal-object", "parallax", "horizon"));

// vtkMesoPicker against closed forms: a tilted plane, a sphere's own radius, assemblies, viewports.

#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"
#include "MesoReliefTechniques.h"
#include "MesoTiltedPlane.h"

#include "vtkMesoPicker.h"

#include "vtkAssembly.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

namespace
{
constexpr int Size = 90;

int PickAt(vtkMesoPicker* picker, MesoTestScene& scene, int column, int rowFromTop)
{
  return picker->Pick(column, Size - 1 - rowFromTop, 0., scene.Renderer);
}
}

TEST(Picker, GivesThePointOnTheReliefAndItsNumbers)
{
  // At height 1/4 everywhere the ray goes on to depth 3/4.
  MesoTiltedPlane scene(50., 0.1, MesoTestScene::Constant(0.25f), Size);
  scene.Mapper->SetMapNumbers(-10., 30.);
  vtkNew<vtkMesoPicker> picker;
  for (const auto& pixel : { std::array<int, 2>{ 45, 40 }, { 20, 70 }, { 60, 9 } })
  {
    ASSERT_EQ(PickAt(picker, scene, pixel[0], pixel[1]), 1);
    const double u = scene.EntryU(pixel[0]) + 0.75 * scene.TravelU();
    const double v = scene.EntryV(pixel[1]);
    EXPECT_NEAR(picker->GetMapCoordinate()[0], u, 1e-5);
    EXPECT_NEAR(picker->GetMapCoordinate()[1], v, 1e-5);
    EXPECT_NEAR(picker->GetHeight(), 0.25, 1e-6);
    EXPECT_NEAR(picker->GetMapNumber(), 0., 1e-4);
    // The depth is a float, 5 away.
    EXPECT_NEAR(picker->GetPickPosition()[0], u - 0.5, 2e-6);
    EXPECT_NEAR(picker->GetPickPosition()[1], v - 0.5, 2e-6);
    EXPECT_NEAR(picker->GetPickPosition()[2], -0.075, 2e-6);
    EXPECT_NEAR(picker->GetPickNormal()[2], 1., 1e-6);
    EXPECT_TRUE(picker->GetHasMap());
    EXPECT_EQ(picker->GetActor(), scene.Actor.Get());
    EXPECT_EQ(picker->GetRenderer(), scene.Renderer.Get());
  }
  picker->ReleaseGraphicsResources(scene.Window);
}

TEST(Picker, InPerspectiveThePointLiesOnThePixelsRay)
{
  MesoTestScene scene(Size, Size);
  vtkNew<vtkMesoReliefMapper> mapper;
  MesoUse(mapper, MesoTechnique::ReliefQuadric,
    MesoTestScene::Shape("sphere", { { "rings", { 96 } }, { "sides", { 192 } } }));
  mapper->SetHeightMap(MesoTestScene::Constant(0.f));
  mapper->SetScale(0.2);
  scene.Actor->SetMapper(mapper);
  scene.LookFrom(0.3, 0.5, 4., 40.);
  vtkNew<vtkMesoPicker> picker;
  for (const auto& pixel : { std::array<int, 2>{ 45, 40 }, { 30, 50 }, { 60, 44 } })
  {
    ASSERT_EQ(PickAt(picker, scene, pixel[0], pixel[1]), 1);
    const double* point = picker->GetPickPosition();
    // The deepest sphere has radius 0.8; the quadric and 192 sides are off by some 1e-3 of it.
    EXPECT_NEAR(std::hypot(point[0], point[1], point[2]), 0.8, 2e-3);
    scene.Renderer->SetWorldPoint(point[0], point[1], point[2], 1.);
    scene.Renderer->WorldToDisplay();
    EXPECT_NEAR(scene.Renderer->GetDisplayPoint()[0], pixel[0] + 0.5, 1e-3);
    EXPECT_NEAR(scene.Renderer->GetDisplayPoint()[1], Size - 1 - pixel[1] + 0.5, 1e-3);
  }
  picker->ReleaseGraphicsResources(scene.Window);
}

TEST(Picker, MissesAndWhatIsNotPickable)
{
  MesoTiltedPlane scene(20., 0.1, MesoTestScene::Pattern("brick"), Size);
  scene.Renderer->GetActiveCamera()->SetParallelScale(2.);
  vtkNew<vtkMesoPicker> picker;
  EXPECT_EQ(PickAt(picker, scene, 2, 2), 0);
  EXPECT_EQ(picker->GetActor(), nullptr);
  EXPECT_FALSE(picker->GetHasMap());
  EXPECT_EQ(picker->Pick(-5., 400., 0., scene.Renderer), 0) << "outside of the window";
  EXPECT_EQ(PickAt(picker, scene, Size / 2, Size / 2), 1);
  scene.Actor->PickableOff();
  EXPECT_EQ(PickAt(picker, scene, Size / 2, Size / 2), 0);
  EXPECT_EQ(picker->GetHeight(), 0.);
  {
    MesoExpectedMessages expected("needs a renderer in a window");
    EXPECT_EQ(picker->Pick(0., 0., 0., nullptr), 0);
    EXPECT_EQ(expected.GetCount(), 1);
  }
  picker->ReleaseGraphicsResources(scene.Window);
}

TEST(Picker, LeavesThePictureAndTheScene)
{
  MesoTiltedPlane scene(35., 0.1, MesoTestScene::Pattern("brick"), Size);
  scene.AddHeadlight();
  scene.Actor->GetProperty()->SetOpacity(0.5);
  const auto before = MesoGrabWindow(scene.Window);
  vtkNew<vtkMesoPicker> picker;
  EXPECT_EQ(PickAt(picker, scene, Size / 2, Size / 2), 1) << "translucent";
  EXPECT_TRUE(picker->GetHasMap());
  EXPECT_FALSE(scene.Actor->GetForceOpaque());
  EXPECT_EQ(scene.Renderer->GetPass(), nullptr);
  vtkNew<vtkUnsignedCharArray> pixels; // of the window as it is
  scene.Window->vtkRenderWindow::GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
  const auto* shown = static_cast<unsigned char*>(before->GetScalarPointer());
  const int components = before->GetNumberOfScalarComponents();
  int different = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    different += pixels->GetValue(3 * i) == shown[components * i] ? 0 : 1;
  }
  EXPECT_EQ(different, 0);
  EXPECT_TRUE(
    MesoCompareImages(MesoGrabWindow(scene.Window), before, MesoImageLimits::Exact()).Within);
  picker->ReleaseGraphicsResources(scene.Window);
}

TEST(Picker, KnowsPartsOfAssembliesAndOrdinaryActors)
{
  MesoTestScene scene(Size, Size);
  scene.Renderer->RemoveActor(scene.Actor);
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(MesoTestScene::Shape("plane"));
  mapper->SetHeightMap(MesoTestScene::Constant(0.5f));
  mapper->SetScale(0.1);
  vtkNew<vtkActor> left;
  left->SetMapper(mapper);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(left);
  assembly->SetScale(2., 1., 4.);
  assembly->SetPosition(-1.2, 0., 0.);
  scene.Renderer->AddActor(assembly);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.5);
  ball->SetCenter(1., 0., 0.);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> right;
  right->SetMapper(ballMapper);
  scene.Renderer->AddActor(right);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.);
  scene.LookFrom(0., 0., 5.);
  vtkNew<vtkMesoPicker> picker;
  // World -1.2 is 27 pixels of 4/90 left of the middle; the depth 0.5 x 0.1 is stretched by 4.
  ASSERT_EQ(PickAt(picker, scene, 18, 45), 1);
  EXPECT_EQ(picker->GetAssembly(), assembly.Get());
  EXPECT_TRUE(picker->GetHasMap());
  EXPECT_NEAR(picker->GetPickPosition()[2], -0.2, 1e-5);
  ASSERT_EQ(PickAt(picker, scene, 67, 45), 1);
  EXPECT_EQ(picker->GetActor(), right.Get());
  EXPECT_FALSE(picker->GetHasMap());
  const double* point = picker->GetPickPosition();
  // A facet of 64 lies up to 0.5 (1 - cos(pi / 64)) below the sphere.
  EXPECT_NEAR(std::hypot(point[0] - 1., point[1], point[2]), 0.5, 1.3e-3);
  picker->ReleaseGraphicsResources(scene.Window);
}

TEST(Picker, WorksInAViewportOfTheWindow)
{
  MesoTiltedPlane scene(50., 0.1, MesoTestScene::Constant(0.25f), Size);
  scene.Window->SetSize(2 * Size, 2 * Size);
  scene.Renderer->SetViewport(0.5, 0.5, 1., 1.);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0., 0., 0.5, 0.5);
  scene.Window->AddRenderer(other);
  vtkNew<vtkMesoPicker> picker;
  ASSERT_EQ(picker->Pick(Size + 45, Size + 49, 0., scene.Renderer), 1);
  const double across = ((45.5) / Size * 2. - 1.) * MesoTiltedPlane::HalfHeight;
  const double up = ((49.5) / Size * 2. - 1.) * MesoTiltedPlane::HalfHeight;
  EXPECT_NEAR(
    picker->GetPickPosition()[0], across / std::cos(scene.Angle) + 0.75 * scene.TravelU(), 2e-6);
  EXPECT_NEAR(picker->GetPickPosition()[1], up, 2e-6);
  EXPECT_EQ(picker->Pick(45, 49, 0., scene.Renderer), 0) << "in the other's viewport";
  picker->ReleaseGraphicsResources(scene.Window);
}

// Volumes in shells over broken meshes, shells that turn over, hard volumes and hard views: every pixel sound, no
// error of OpenGL, no hang.

#include "BrokenMeshes.h"
#include "ErrorRecorder.h"
#include "MesoAOVChecks.h"
#include "MesoTestVolume.h"

#include "vtkMesoPrismShell.h"
#include "vtkMesoShellMapper.h"

namespace
{
/// A scene, and a shell in it whose messages are kept.
class Looker
{
public:
  MesoTestScene Scene{ 100, 100 };
  ErrorRecorder Messages;
  vtkNew<vtkMesoPrismShell> Shell;
  vtkNew<vtkMesoShellMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  Looker()
  {
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.AddHeadlight();
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Messages.Watch(this->Shell);
    this->Messages.Watch(this->Mapper);
  }
  ~Looker() { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Makes the shell, and sees whether there is one.
  bool Make(vtkPolyData* mesh, double thickness, double reference = 0.)
  {
    this->Shell->SetInputData(mesh);
    this->Shell->SetThickness(thickness);
    this->Shell->SetReference(reference);
    this->Shell->Update();
    this->Mapper->SetInputData(this->Shell->GetOutput());
    return this->Shell->GetOutput()->GetNumberOfPolys() > 0;
  }

  /// Number of covered pixels, each of which is sound.
  int Look(vtkImageData* volume, MesoExits exits = MesoExits::Exact)
  {
    MesoMesostructureOptions options;
    options.Technique = MesoTechnique::ShellSDF;
    options.Scale = this->Shell->GetThickness();
    options.Exits = exits;
    this->Mapper->SetOptions(options);
    this->Mapper->SetVolume(volume);
    return this->LookAgain();
  }

  int LookAgain()
  {
    this->Scene.Renderer->ResetCameraClippingRange();
    MesoCapture(this->Scene, this->Pass);
    this->Scene.Window->Render();
    return MesoCheckEveryPixel(this->Pass);
  }
};

class HardShells : public testing::TestWithParam<BrokenMesh>
{
};
}

TEST_P(HardShells, AreDrawnSoundly)
{
  Looker looker;
  const auto mesh = GetParam().Make();
  // Thin, and so thick that prisms turn over; outward and inward; walked and each by itself.
  for (const double thickness : { 0.02, 0.7 })
  {
    for (const double reference : { 0., 1. })
    {
      for (const MesoExits exits : { MesoExits::Exact, MesoExits::Interpolated })
      {
        looker.Shell->SetInnerFins(exits == MesoExits::Interpolated);
        if (looker.Make(mesh, thickness, reference))
        {
          looker.Scene.Renderer->ResetCamera();
          looker.Look(MesoTestBars(), exits);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardShells, testing::ValuesIn(BrokenMeshes()),
  [](const testing::TestParamInfo<BrokenMesh>& info) { return info.param.Name; });

TEST(HardVolumes, AreDrawnSoundly)
{
  Looker looker;
  looker.Scene.LookFrom(1., 2., 3.5);
  ASSERT_TRUE(
    looker.Make(MesoTestScene::Shape("torus", { { "rings", { 12. } }, { "sides", { 8. } } }), 0.2));
  const auto of = [](const std::array<int, 3>& size, double depth, double distance)
  { return MesoTestVolume(size, depth, [=](double, double, double) { return distance; }); };
  const int solid = looker.Look(of({ 4, 4, 4 }, 0.5, -1.));
  EXPECT_GT(solid, 2000);
  EXPECT_EQ(looker.Look(of({ 4, 4, 4 }, 0.5, 1.)), 0);
  // One voxel; nothing but surface; a shell far thicker, and far thinner, than its tile is wide.
  EXPECT_EQ(looker.Look(of({ 1, 1, 1 }, 0.5, -0.1)), solid);
  EXPECT_EQ(looker.Look(of({ 1, 1, 1 }, 0.5, 0.1)), 0);
  EXPECT_EQ(looker.Look(of({ 2, 2, 2 }, 0.5, 0.)), solid);
  EXPECT_EQ(looker.Look(of({ 3, 2, 1 }, 1e4, -1.)), solid);
  EXPECT_EQ(looker.Look(of({ 3, 2, 5 }, 1e-4, -1.)), solid);
  // Distances that say too much, and some that are none.
  looker.Look(MesoTestVolume({ 8, 8, 8 }, 0.5,
    [](double x, double, double z)
    { return 1e6 * (std::abs(x - 0.5) + std::abs(z - 0.25) - 0.1); }));
  looker.Look(MesoTestVolume({ 8, 8, 8 }, 0.5,
    [](double x, double y, double) { return (x < 0.5) != (y < 0.5) ? -1e-30 : 1e-30; }));
  EXPECT_TRUE(looker.Messages.Errors.empty());
}

TEST(HardShellViews, AreSound)
{
  // Along a plane through rows of prisms, down a fin, from within, very near and very far, huge and tiny.
  Looker looker;
  for (const double size : { 1e-4, 1., 1e5 })
  {
    ASSERT_TRUE(
      looker.Make(MesoTestScene::Shape("plane",
                    { { "segments", { 40., 40. } }, { "size", { 4. * size, 4. * size } } }),
        0.2 * size));
    vtkCamera* camera = looker.Scene.Renderer->GetActiveCamera();
    const double eyes[][3] = { { -6., 0., 0.1 }, { -6., 0., 0. }, { 0., 0., 3. }, { 0.1, 0., 0.1 },
      { 0., 0., 0.2 }, { 0.003, 0.001, 0.21 }, { 50., 60., 90. } };
    for (const auto& eye : eyes)
    {
      camera->SetPosition(size * eye[0], size * eye[1], size * eye[2]);
      camera->SetFocalPoint(
        size * (eye[0] == 0. ? 0. : 0.3), 0., size * (eye[2] < 1. ? eye[2] : 0.));
      camera->SetViewUp(eye[0] == 0. ? 0. : 0.1, 1., eye[0] == 0. ? 0. : 1.);
      for (const auto& volume : { MesoTestBars(), MesoTestSlab(0.6) })
      {
        looker.Look(volume);
      }
    }
    // Straight along the shell its cut fills the row of pixels that it covers: no ray is lost on its way.
    camera->SetPosition(-6. * size, 0., 0.05 * size);
    camera->SetFocalPoint(0., 0., 0.05 * size);
    camera->SetViewUp(0., 0., 1.);
    EXPECT_GT(looker.Look(MesoTestSlab(0.6)), 100) << size;
  }
  EXPECT_TRUE(looker.Messages.Errors.empty());
}

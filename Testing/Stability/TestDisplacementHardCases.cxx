// Displacement and geometry images of broken meshes, hard maps and hard views: every pixel sound, no error of
// OpenGL, no hang; what cannot be drawn is said.

#include "BrokenMeshes.h"
#include "ErrorRecorder.h"
#include "MesoAOVChecks.h"

#include "vtkMesoDisplacementMapper.h"
#include "vtkMesoGeometryImage.h"
#include "vtkMesoGeometryImageMapper.h"
#include "vtkMesoLoopSubdivision.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkMatrix4x4.h"

namespace
{
/// A scene whose mappers' messages are kept.
class Looker
{
public:
  MesoTestScene Scene;
  ErrorRecorder Messages;
  vtkNew<vtkMesoAOVPass> Pass;

  Looker()
  {
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.AddHeadlight();
  }
  ~Looker() { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Number of covered pixels, each of which is sound.
  int Look(vtkMesoPolyDataMapper* mapper)
  {
    this->Messages.Watch(mapper);
    this->Scene.Actor->SetMapper(mapper);
    this->Scene.Renderer->ResetCamera();
    MesoCapture(this->Scene, this->Pass);
    const int covered = MesoCheckEveryPixel(this->Pass);
    this->Scene.Window->Render();
    return covered;
  }
};

void Use(
  vtkMesoDisplacementMapper* mapper, vtkPolyData* mesh, vtkImageData* map, double facetPixels)
{
  mapper->SetInputData(mesh);
  mapper->SetHeightMap(map);
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Displacement;
  options.Scale = 0.1;
  options.Reference = 0.5;
  options.Tiles = { 2., 3. };
  options.FacetPixels = facetPixels;
  mapper->SetOptions(options);
}

class HardMeshes : public testing::TestWithParam<BrokenMesh>
{
};
}

TEST_P(HardMeshes, AreDrawnSoundly)
{
  ErrorRecorder messages;
  vtkNew<vtkMesoSurfaceFrames> frames;
  messages.Watch(frames);
  frames->SetInputData(GetParam().Make());
  frames->Update();
  vtkPolyData* mesh = frames->GetOutput();
  if (mesh->GetNumberOfPolys() == 0)
  {
    return; // refused, or nothing to be drawn
  }
  Looker looker;
  const auto map = MesoTestScene::Pattern("noise", 16, 16);
  for (const double pixels : { 0., 3. })
  {
    vtkNew<vtkMesoDisplacementMapper> displacement;
    Use(displacement, mesh, map, pixels);
    looker.Look(displacement);
  }
  vtkNew<vtkMesoLoopSubdivision> smooth;
  messages.Watch(smooth);
  smooth->SetInputData(mesh);
  smooth->Update();
  EXPECT_EQ(smooth->GetOutput()->GetNumberOfPolys() == 0, !smooth->GetErrorMessage().empty());

  vtkNew<vtkMesoGeometryImage> image;
  messages.Watch(image);
  image->SetInputData(mesh);
  image->SetSize(32);
  image->Update();
  if (image->GetErrorMessage().empty())
  {
    vtkNew<vtkMesoGeometryImageMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetGeometryImage(image->GetOutput());
    looker.Look(mapper);
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardMeshes, testing::ValuesIn(BrokenMeshes()),
  [](const testing::TestParamInfo<BrokenMesh>& info) { return info.param.Name; });

TEST(HardMaps, AreDrawnSoundly)
{
  Looker looker;
  looker.Scene.LookFrom(1., 3., 5.);
  const auto torus = MesoTestScene::Shape("torus", { { "rings", { 12. } }, { "sides", { 8. } } });
  for (const auto& map : { MesoTestScene::Constant(0.f), MesoTestScene::Constant(1.f),
         MesoTestScene::Pattern("noise", 1, 1), MesoTestScene::Pattern("noise", 1, 64),
         MesoTestScene::Pattern("noise", 7, 3),
         MesoTestScene::Pattern("checkerboard", 64, 64, { { "squares", 64. } }) })
  {
    for (const MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror })
    {
      vtkNew<vtkMesoDisplacementMapper> mapper;
      Use(mapper, torus, map, 0.);
      MesoMesostructureOptions options = mapper->GetOptions();
      options.Wrap = wrap;
      mapper->SetOptions(options);
      EXPECT_GT(looker.Look(mapper), 2000);
    }
  }
  EXPECT_TRUE(looker.Messages.Errors.empty());
}

TEST(HardViews, AreDrawnSoundly)
{
  Looker looker;
  const auto torus = MesoTestScene::Shape("torus");
  vtkNew<vtkMesoDisplacementMapper> mapper;
  Use(mapper, torus, MesoTestScene::Pattern("stone", 64, 64), 2.);
  vtkActor* actor = looker.Scene.Actor;
  actor->SetMapper(mapper);
  looker.Messages.Watch(mapper);
  vtkCamera* camera = looker.Scene.Renderer->GetActiveCamera();
  const auto look = [&]()
  {
    MesoCapture(looker.Scene, looker.Pass);
    return MesoCheckEveryPixel(looker.Pass);
  };
  looker.Scene.LookFrom(1., 3., 5.);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.6);
  looker.Scene.Renderer->ResetCameraClippingRange();
  EXPECT_GT(look(), 3000);
  camera->ParallelProjectionOff();
  looker.Scene.LookFrom(1e3, 3e3, 5e3); // below a pixel
  EXPECT_LE(look(), 4);
  looker.Scene.LookFrom(0., 0.02, 1.45, 150.); // within the relief, wide
  camera->SetClippingRange(1e-3, 100.);
  EXPECT_GT(look(), 100);
  looker.Scene.LookFrom(
    0.001, 5., 0.); // from above, then a mirrored, sheared and a singular matrix
  EXPECT_GT(look(), 3000);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, -1.);
  matrix->SetElement(0, 1, 0.7);
  actor->SetUserMatrix(matrix);
  look();
  matrix->SetElement(1, 1, 0.);
  matrix->SetElement(0, 1, 0.);
  actor->SetUserMatrix(matrix);
  look();
  EXPECT_TRUE(looker.Messages.Errors.empty());
}

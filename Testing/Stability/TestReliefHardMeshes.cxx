// Relief on broken meshes: every pixel sound, no error of OpenGL, nothing drawn beside the mesh, no hang.

#include "BrokenMeshes.h"
#include "ErrorRecorder.h"
#include "MesoAOVChecks.h"

#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoSurfaceFrames.h"

namespace
{
class ReliefHardMeshes : public testing::TestWithParam<BrokenMesh>
{
};
}

TEST_P(ReliefHardMeshes, AreDrawnSoundlyByEveryTechnique)
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
  MesoTestScene scene(64, 64);
  scene.AddDirectionalLight(-1., -2., -1.);
  scene.LookFrom(0.5, -1., 4.);
  vtkNew<vtkMesoAOVPass> pass;
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(mesh);
  scene.Actor->SetMapper(plain);
  scene.Renderer->ResetCamera();
  MesoCapture(scene, pass);
  const auto base = pass->GetChannel("coverage");
  for (const MesoReliefArm& arm : MesoReliefArms)
  {
    vtkNew<vtkMesoReliefMapper> mapper;
    messages.Watch(mapper);
    mapper->SetScale(0.1);
    mapper->SetHeightMap(MesoTestScene::Pattern("brick", 32, 32));
    mapper->SetTiles(2., 3.);
    if (arm.Curved == MesoCurvedKind::Bent || arm.Curved == MesoCurvedKind::Surface)
    {
      vtkNew<vtkMesoBaseImage> image;
      messages.Watch(image);
      image->SetSizeFor(mesh);
      image->SetInputData(mesh);
      image->Update();
      if (image->GetOutput()->GetNumberOfPoints() == 0)
      {
        continue; // a chart without area is refused
      }
    }
    MesoUse(mapper, arm, mesh);
    scene.Actor->SetMapper(mapper);
    MesoCapture(scene, pass);
    MesoCheckEveryPixel(pass);
    const auto relief = pass->GetChannel("coverage");
    int beside = 0;
    for (std::size_t i = 0; i < relief.size(); ++i)
    {
      beside += relief[i] > base[i] ? 1 : 0;
    }
    EXPECT_EQ(beside, 0) << arm.TestName();
  }
  pass->ReleaseGraphicsResources(scene.Window);
}

INSTANTIATE_TEST_SUITE_P(All, ReliefHardMeshes, testing::ValuesIn(BrokenMeshes()),
  [](const testing::TestParamInfo<BrokenMesh>& info) { return info.param.Name; });

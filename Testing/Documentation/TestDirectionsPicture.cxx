// The picture of principal directions in Documentation/Surfaces.md: lines over the mesh, drawn by VTK.

#include "MesoBaseline.h"
#include "MesoTestScene.h"

#include "vtkMesoDirectionLines.h"
#include "vtkMesoMeshReader.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoPrincipalCurvatures.h"

#include <gtest/gtest.h>

TEST(DirectionsPicture, LinesOverTheBlob)
{
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(MESO_MESHES "/blob.obj");
  vtkNew<vtkMesoPrincipalCurvatures> curvatures;
  curvatures->SetInputConnection(reader->GetOutputPort());

  MesoTestScene scene(400, 300);
  scene.Window->SetMultiSamples(4);
  scene.Renderer->SetBackground(1., 1., 1.);
  vtkNew<vtkMesoPolyDataMapper> mapper;
  mapper->SetInputConnection(curvatures->GetOutputPort());
  mapper->ScalarVisibilityOff();
  scene.Actor->SetMapper(mapper);
  scene.Actor->GetProperty()->SetColor(0.87, 0.87, 0.87);
  scene.Actor->GetProperty()->SetAmbient(0.25);
  scene.Actor->GetProperty()->SetDiffuse(0.75);

  // The ends of `coolwarm`: red along c_max, blue along c_min.
  const double colors[2][3] = { { 0.706, 0.016, 0.150 }, { 0.230, 0.299, 0.754 } };
  for (int which = 0; which < 2; ++which)
  {
    vtkNew<vtkMesoDirectionLines> lines;
    lines->SetInputConnection(curvatures->GetOutputPort());
    lines->SetMaximum(which == 0);
    lines->SetMinimum(which == 1);
    lines->SetLength(0.08);
    lines->Update();
    // Points of a closed, smooth mesh have directions, all but the few that are umbilics.
    EXPECT_GT(lines->GetOutput()->GetNumberOfLines(),
      0.9 * static_cast<double>(curvatures->GetOutput()->GetNumberOfPoints()));
    vtkNew<vtkPolyDataMapper> lineMapper;
    lineMapper->SetInputConnection(lines->GetOutputPort());
    lineMapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(lineMapper);
    actor->GetProperty()->SetColor(colors[which][0], colors[which][1], colors[which][2]);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(2.f);
    scene.Renderer->AddActor(actor);
  }
  scene.AddHeadlight();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(1.9, 1.8, 4.6); // as in Data/Scenes/Documentation/SurfaceBlob*.json
  camera->SetFocalPoint(0.35, 0.1, 0.);
  camera->SetViewAngle(16.);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(MesoCompareWithBaseline(MesoGrabWindow(scene.Window), "SurfaceBlobDirections",
    MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));
}

#ifndef ChartPicture_h
#define ChartPicture_h

// Charts of the documentation, drawn and compared with its pictures.

#include "MesoBaseline.h"
#include "MesoTestScene.h"

#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkNew.h"

/// A chart, 480 x 320, is the picture of this name.
inline void ExpectChart(vtkChartXY* chart, const char* name)
{
  MesoTestScene scene(480, 320);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.Window->SetMultiSamples(4);
  scene.Renderer->SetBackground(1., 1., 1.);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  scene.Renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(scene.Renderer);
  EXPECT_TRUE(MesoCompareWithBaseline(
    MesoGrabWindow(scene.Window), name, MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));
}

#endif

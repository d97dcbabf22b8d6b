// Figure 7 of Oliveira2005: the quadrics that stand for a surface at its vertices, and their signs.

#include "MesoBaseline.h"
#include "MesoTestScene.h"

#include "vtkMesoSurfaceFrames.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"

#include <gtest/gtest.h>

namespace
{
/// One of the figure's four: z = a x^2 + b y^2 below the middle of a patch.
struct Form
{
  const char* Name;
  double A;
  double B;
};

const Form Forms[] = { { "paraboloid", 0.5, 0.35 }, { "hyperbolic paraboloid", 0.5, -0.4 },
  { "parabolic cylinder", 0.5, 0. }, { "plane", 0., 0. } };

/// The patch, of size 2, in cells a side; it bends more towards its border than the quadric does, so that
/// the two can be told apart.
vtkSmartPointer<vtkPolyData> Patch(const Form& form, int cells, double fourth, double moved)
{
  const auto mesh = MesoTestScene::Shape(
    "plane", { { "size", { 2., 2. } }, { "segments", { double(cells), double(cells) } } });
  auto bent = vtkSmartPointer<vtkPolyData>::New();
  bent->DeepCopy(mesh);
  for (vtkIdType i = 0; i < bent->GetNumberOfPoints(); ++i)
  {
    double p[3];
    bent->GetPoint(i, p);
    const double square = p[0] * p[0] + p[1] * p[1];
    const double below = form.A * p[0] * p[0] + form.B * p[1] * p[1];
    bent->GetPoints()->SetPoint(i, p[0], p[1], moved - below * (1. + fourth * square));
  }
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(bent->GetPoints());
  bare->SetPolys(bent->GetPolys());
  bare->GetPointData()->SetTCoords(bent->GetPointData()->GetTCoords());
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(bare);
  frames->Update();
  bent->ShallowCopy(frames->GetOutput());
  return bent;
}

/// Adds an actor at a place of the picture.
vtkProperty* Show(vtkRenderer* renderer, vtkPolyData* mesh, int place)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(2.7 * (place - 1.5), 0., 0.);
  renderer->AddActor(actor);
  return actor->GetProperty();
}
}

TEST(PaperQuadrics, Figure7SignsOfTheFourForms)
{
  MesoTestScene scene(480, 150);
  scene.Window->SetMultiSamples(4);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.Renderer->SetBackground(1., 1., 1.);
  int place = 0;
  for (const Form& form : Forms)
  {
    constexpr int Cells = 12;
    const auto patch = Patch(form, Cells, 0.25, 0.);
    vtkNew<vtkMesoQuadricFit> fit;
    fit->SetInputData(patch);
    fit->Update();
    const vtkIdType middle = (Cells + 1) * (Cells / 2) + Cells / 2;
    double at[3];
    fit->GetOutput()->GetPoint(middle, at);
    ASSERT_NEAR(at[0], 0., 1e-6);
    ASSERT_NEAR(at[1], 0., 1e-6);
    double q[3];
    fit->GetOutput()->GetPointData()->GetArray("MesoQuadric")->GetTuple(middle, q);
    std::cout << form.Name << ": a " << q[0] << ", b " << q[1] << ", c " << q[2] << "\n";
    // Signs, and sizes: two rings reach a third of the way to the border, more on one diagonal than on
    // the other.
    EXPECT_NEAR(q[0], form.A, 0.05 * form.A) << form.Name;
    EXPECT_NEAR(q[1], form.B, 0.05 * std::abs(form.B) + 0.002 * form.A) << form.Name;
    EXPECT_NEAR(q[2], 0., 0.04 * form.A) << form.Name;

    vtkProperty* surface = Show(scene.Renderer, patch, place);
    surface->SetColor(0.85, 0.72, 0.6);
    surface->SetAmbient(0.2);
    surface->SetInterpolationToPhong();
    const auto quadric = Patch({ "", q[0], q[1] }, 8, 0., 0.02);
    vtkProperty* lines = Show(scene.Renderer, quadric, place);
    lines->SetRepresentationToWireframe();
    lines->LightingOff();
    lines->SetColor(0.1, 0.2, 0.5);
    ++place;
  }
  scene.AddDirectionalLight(0.5, 0.6, -1.);
  scene.LookFrom(0., -8., 7.5, 18.);
  scene.Renderer->GetActiveCamera()->SetViewUp(0., 0., 1.);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(MesoCompareWithBaseline(MesoGrabWindow(scene.Window), "FigureQuadrics",
    MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));
}

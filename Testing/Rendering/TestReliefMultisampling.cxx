// Outlines of relief in a window with several samples a pixel: each sample has a ray of its own, so that the
// outline is as smooth as that of triangles.

#include "vtk_glew.h" // must come first

#include "MesoAOVChecks.h"
#include "MesoRadicalInverse.h"

#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
constexpr int Size = 120;
using Picture = std::vector<double>;

class ReliefMultisampling : public testing::Test
{
protected:
  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoReliefMapper> Mapper;

  void SetUp() override
  {
    this->Mapper->SetHeightMap(MesoTestScene::Constant(0.5f));
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.Actor->GetProperty()->LightingOff();
    MesoUse(this->Mapper, MesoTechnique::ReliefQuadric,
      MesoTestScene::Shape("sphere", { { "radius", { 1. } } }));
    this->Mapper->SetScale(0.3);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.1);
    camera->SetPosition(0., 0., 5.);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  Picture Draw(int samples)
  {
    this->Scene.Window->SetMultiSamples(samples);
    this->Scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    vtkRenderWindow* window = this->Scene.Window;
    window->GetPixelData(0, 0, Size - 1, Size - 1, 0, bytes);
    Picture picture;
    for (vtkIdType i = 0; i < bytes->GetNumberOfValues(); ++i)
    {
      picture.push_back(bytes->GetValue(i) / 255.);
    }
    return picture;
  }

  /// The mean of many pictures moved by parts of a pixel.
  Picture Truth()
  {
    constexpr int Places = 64;
    Picture mean(3 * Size * Size, 0.);
    for (int i = 1; i <= Places; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->SetWindowCenter(
        2. * (MesoRadicalInverse(i, 2) - 0.5) / Size, 2. * (MesoRadicalInverse(i, 3) - 0.5) / Size);
      const Picture picture = this->Draw(0);
      for (std::size_t k = 0; k < mean.size(); ++k)
      {
        mean[k] += picture[k] / Places;
      }
    }
    this->Scene.Renderer->GetActiveCamera()->SetWindowCenter(0., 0.);
    return mean;
  }

  static double Distance(const Picture& a, const Picture& b)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(sum / double(a.size()));
  }
};
}

TEST_F(ReliefMultisampling, TheOutlineIsSmooth)
{
  const Picture truth = this->Truth();
  const double one = Distance(this->Draw(0), truth);
  const Picture four = this->Draw(4);
  const double several = Distance(four, truth);
  std::cout << "outline from the truth: " << one << " with 1 sample, " << several << " with "
            << this->Scene.Window->GetMultiSamples() << "\n";
  ASSERT_GT(this->Scene.Window->GetMultiSamples(), 1);
  EXPECT_LT(several, 0.5 * one);
  // Between the relief's colour and the background: pixels that some samples miss.
  int between = 0;
  for (std::size_t i = 0; i < four.size(); i += 3)
  {
    between += four[i] > 0.15 && four[i] < 0.75 ? 1 : 0;
  }
  EXPECT_GT(between, 150);
}

TEST_F(ReliefMultisampling, OtherActorsAreLeftAlone)
{
  // The mapper leaves the window's state as it was: a plain actor drawn after it is the same.
  vtkNew<vtkPolyDataMapper> plain;
  plain->SetInputData(MesoTestScene::Shape("sphere", { { "radius", { 0.3 } } }));
  vtkNew<vtkActor> after;
  after->SetMapper(plain);
  after->SetPosition(0., 0., 1.5);
  after->GetProperty()->LightingOff();
  this->Scene.Renderer->AddActor(after);
  this->Draw(4);
  EXPECT_EQ(this->Scene.Window->GetNumberOfGLErrors(), 0);
  EXPECT_FALSE(glIsEnabled(GL_SAMPLE_SHADING_ARB));
}

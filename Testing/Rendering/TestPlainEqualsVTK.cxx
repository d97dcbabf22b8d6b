// The technique `plain` is VTK's own picture, bit for bit: every kind of light, alone and mixed, with
// texture, specular, edges, flat shading, scalar colours and translucency.

#include "MesoBaseline.h"
#include "MesoTestScene.h"

#include "vtkMesoPolyDataMapper.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkLight> MakeLight(const std::string& kind)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetColor(1.0, 0.9, 0.8);
  light->SetPosition(2., 3., 4.);
  light->SetFocalPoint(0., 0., 0.);
  if (kind == "headlight")
  {
    light->SetLightTypeToHeadlight();
  }
  else if (kind != "directional")
  {
    light->PositionalOn();
    light->SetAttenuationValues(0.5, 0.1, 0.02);
    light->SetConeAngle(kind == "spot" ? 12. : 90.);
    light->SetExponent(kind == "spot" ? 3. : 1.);
  }
  return light;
}

class PlainEqualsVTK : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkPolyDataMapper> Theirs;
  vtkNew<vtkMesoPolyDataMapper> Ours;

  void SetUp() override
  {
    const auto torus = MesoTestScene::Shape("torus");
    this->Theirs->SetInputData(torus);
    this->Ours->SetInputData(torus);
    this->Scene.LookFrom(1., 3., 5.);
  }

  void Light(const std::vector<std::string>& kinds)
  {
    for (const std::string& kind : kinds)
    {
      this->Scene.Renderer->AddLight(MakeLight(kind));
    }
  }

  /// Compare the two pictures; they must not be empty.
  void Check(const MesoImageLimits& limits = MesoImageLimits::Exact())
  {
    this->Scene.Actor->SetMapper(this->Theirs);
    const auto theirs = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->SetMapper(this->Ours);
    const auto ours = MesoGrabWindow(this->Scene.Window);
    const MesoImageDifference difference = MesoCompareImages(ours, theirs, limits);
    EXPECT_TRUE(difference.Within) << difference.Describe();
    this->Scene.Actor->VisibilityOff();
    const auto empty = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->VisibilityOn();
    EXPECT_FALSE(MesoCompareImages(ours, empty).Within) << "nothing was drawn";
  }
};
}

TEST_F(PlainEqualsVTK, Headlight)
{
  this->Light({ "headlight" });
  this->Check();
}

TEST_F(PlainEqualsVTK, HeadlightSpecular)
{
  this->Light({ "headlight" });
  this->Scene.Actor->GetProperty()->SetSpecular(0.5);
  this->Scene.Actor->GetProperty()->SetSpecularPower(20.);
  this->Check();
}

TEST_F(PlainEqualsVTK, Directional)
{
  this->Light({ "directional" });
  this->Check();
}

TEST_F(PlainEqualsVTK, Point)
{
  this->Light({ "point" });
  this->Check();
}

TEST_F(PlainEqualsVTK, Spot)
{
  this->Light({ "spot" });
  this->Check();
}

TEST_F(PlainEqualsVTK, MixedLightsSpecular)
{
  this->Light({ "headlight", "directional", "point", "spot" });
  this->Scene.Actor->GetProperty()->SetSpecular(0.3);
  this->Scene.Actor->GetProperty()->SetSpecularPower(10.);
  this->Check();
}

TEST_F(PlainEqualsVTK, SeveralDirectionalSpecular)
{
  this->Light({ "headlight", "directional" });
  this->Scene.Actor->GetProperty()->SetSpecular(0.3);
  this->Scene.Actor->GetProperty()->SetSpecularPower(10.);
  this->Check();
}

TEST_F(PlainEqualsVTK, NoLight)
{
  this->Check();
}

TEST_F(PlainEqualsVTK, LightingOff)
{
  this->Light({ "directional" });
  this->Scene.Actor->GetProperty()->LightingOff();
  this->Check();
}

TEST_F(PlainEqualsVTK, Textured)
{
  this->Light({ "directional" });
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 32 * 32 * 3; ++i)
  {
    value[i] = static_cast<unsigned char>((i * 37) % 256);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  this->Scene.Actor->SetTexture(texture);
  this->Check();
}

TEST_F(PlainEqualsVTK, Edges)
{
  this->Light({ "directional" });
  this->Scene.Actor->GetProperty()->EdgeVisibilityOn();
  this->Check();
}

TEST_F(PlainEqualsVTK, Flat)
{
  this->Light({ "directional" });
  this->Scene.Actor->GetProperty()->SetInterpolationToFlat();
  this->Check();
}

TEST_F(PlainEqualsVTK, Wireframe)
{
  this->Light({ "directional" });
  this->Scene.Actor->GetProperty()->SetRepresentationToWireframe();
  this->Check();
}

TEST_F(PlainEqualsVTK, ScalarColours)
{
  this->Light({ "directional", "headlight" });
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("number");
  for (vtkIdType i = 0; i < this->Ours->GetInput()->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 20));
  }
  this->Ours->GetInput()->GetPointData()->SetScalars(scalars);
  for (vtkPolyDataMapper* mapper :
    { this->Theirs.Get(), static_cast<vtkPolyDataMapper*>(this->Ours) })
  {
    mapper->SetScalarRange(0., 20.);
  }
  this->Check();
}

TEST_F(PlainEqualsVTK, PhysicallyBased)
{
  this->Light({ "directional", "point" });
  this->Scene.Actor->GetProperty()->SetInterpolationToPBR();
  this->Scene.Actor->GetProperty()->SetRoughness(0.4);
  this->Check();
}

TEST_F(PlainEqualsVTK, TranslucentByDepthPeeling)
{
  this->Light({ "directional" });
  this->Scene.Actor->GetProperty()->SetOpacity(0.5);
  this->Scene.Renderer->UseDepthPeelingOn();
  this->Check();
}

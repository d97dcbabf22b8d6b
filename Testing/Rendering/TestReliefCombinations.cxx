// Each way that VTK draws an actor builds another shader. Every one of them must compile, leave no
// GL error, and show the relief: the picture differs from that of the base mesh. Each runs in a
// process of its own, since a shader that does not compile ends VTK 9.1's.

#include "MesoBaseline.h"
#include "MesoReliefTechniques.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <functional>
#include <gtest/gtest.h>

namespace
{
struct Combination
{
  const char* Name;
  std::function<void(MesoTestScene&, vtkMesoPolyDataMapper*)> Apply;
};

std::ostream& operator<<(std::ostream& os, const Combination& combination)
{
  return os << combination.Name; // what ctest shows
}

vtkSmartPointer<vtkTexture> CheckerTexture(bool mipmap)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16 * 16; ++i)
  {
    std::fill_n(value + 3 * i, 3, static_cast<unsigned char>((i + i / 16) % 2 ? 255 : 90));
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetMipmap(mipmap);
  return texture;
}

vtkProperty* Material(MesoTestScene& scene)
{
  return scene.Actor->GetProperty();
}

void SetEffects(vtkMesoPolyDataMapper* mapper, const MesoEffects& effects)
{
  MesoMesostructureOptions options = mapper->GetOptions();
  options.Effects.Auto = false;
  options.Effects.Named = effects;
  if (dynamic_cast<vtkMesoReliefMapper*>(mapper))
  {
    mapper->SetOptions(options);
  }
}

void SetWrap(vtkMesoPolyDataMapper* mapper, MesoWrap wrap)
{
  MesoMesostructureOptions options = mapper->GetOptions();
  options.Wrap = wrap;
  mapper->SetOptions(options);
}

vtkLight* AddPointLight(MesoTestScene& scene, double coneAngle)
{
  vtkLight* light = scene.AddDirectionalLight(-2., -3., -4.);
  light->PositionalOn();
  light->SetConeAngle(coneAngle);
  return light;
}

using S = MesoTestScene;
using M = vtkMesoPolyDataMapper;

const Combination Combinations[] = {
  { "Plain", [](S&, M*) {} },
  { "NoLight",
    [](S& s, M*)
    {
      s.Renderer->RemoveAllLights();
      s.Actor->SetTexture(CheckerTexture(false));
    } },
  { "LightingOff",
    [](S& s, M*)
    {
      Material(s)->LightingOff();
      s.Actor->SetTexture(CheckerTexture(false));
    } },
  { "Headlight",
    [](S& s, M*)
    {
      s.Renderer->RemoveAllLights();
      s.AddHeadlight();
    } },
  { "HeadlightSpecular",
    [](S& s, M*)
    {
      s.Renderer->RemoveAllLights();
      s.AddHeadlight();
      Material(s)->SetSpecular(0.5);
    } },
  { "DirectionalSpecular", [](S& s, M*) { Material(s)->SetSpecular(0.5); } },
  { "PointLight", [](S& s, M*) { AddPointLight(s, 90.); } },
  { "SpotLight", [](S& s, M*) { AddPointLight(s, 20.); } },
  { "ManyLights",
    [](S& s, M*)
    {
      s.AddHeadlight();
      AddPointLight(s, 90.);
      AddPointLight(s, 20.);
      for (int i = 0; i < 4; ++i)
      {
        s.AddDirectionalLight(i, -1., -1.)->SetIntensity(0.1);
      }
    } },
  { "Textured", [](S& s, M*) { s.Actor->SetTexture(CheckerTexture(false)); } },
  { "TexturedMipmap", [](S& s, M*) { s.Actor->SetTexture(CheckerTexture(true)); } },
  { "Edges", [](S& s, M*) { Material(s)->EdgeVisibilityOn(); } },
  { "EdgesTextured",
    [](S& s, M*)
    {
      Material(s)->EdgeVisibilityOn();
      s.Actor->SetTexture(CheckerTexture(false));
    } },
  { "Wireframe", [](S& s, M*) { Material(s)->SetRepresentationToWireframe(); } },
  { "WideWireframe",
    [](S& s, M*)
    {
      Material(s)->SetRepresentationToWireframe();
      Material(s)->SetLineWidth(4.f);
    } },
  { "Flat", [](S& s, M*) { Material(s)->SetInterpolationToFlat(); } },
  { "Gouraud", [](S& s, M*) { Material(s)->SetInterpolationToGouraud(); } },
  { "PhysicallyBased", [](S& s, M*) { Material(s)->SetInterpolationToPBR(); } },
  { "TwoSided", [](S& s, M*) { Material(s)->BackfaceCullingOff(); } },
  { "Translucent", [](S& s, M*) { Material(s)->SetOpacity(0.5); } },
  { "TranslucentPeeled",
    [](S& s, M*)
    {
      Material(s)->SetOpacity(0.5);
      s.Renderer->UseDepthPeelingOn();
    } },
  { "ParallelProjection",
    [](S& s, M*)
    {
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
      s.Renderer->GetActiveCamera()->SetParallelScale(1.5);
    } },
  { "NonUniformScale", [](S& s, M*) { s.Actor->SetScale(1., 0.5, 1.3); } },
  { "Mirrored", [](S& s, M*) { s.Actor->SetScale(-1., 1., 1.); } },
  { "FarFromOrigin",
    [](S& s, M*)
    {
      s.Actor->SetPosition(1e5, 0., 0.);
      s.Renderer->GetActiveCamera()->SetPosition(1e5 + 1., 3., 5.);
      s.Renderer->GetActiveCamera()->SetFocalPoint(1e5, 0., 0.);
      s.Renderer->ResetCameraClippingRange();
    } },
  { "CoincidentOffset",
    [](S&, M* m)
    {
      m->SetRelativeCoincidentTopologyPolygonOffsetParameters(0., 2.);
      m->SetResolveCoincidentTopologyToPolygonOffset();
    } },
  { "MultiSampled", [](S& s, M*) { s.Window->SetMultiSamples(4); } },
  { "ShadingOnly", [](S&, M* m) { SetEffects(m, { MesoEffect::Shading }); } },
  { "OcclusionOnly",
    [](S& s, M* m)
    {
      SetEffects(m, { MesoEffect::Occlusion });
      s.Actor->SetTexture(CheckerTexture(false));
    } },
  { "SelfShadowOnly", [](S&, M* m) { SetEffects(m, { MesoEffect::SelfShadow }); } },
  { "NoDepth",
    [](S&, M* m) {
      SetEffects(m, { MesoEffect::Shading, MesoEffect::Occlusion, MesoEffect::SelfShadow });
    } },
  { "WrapClamp", [](S&, M* m) { SetWrap(m, MesoWrap::Clamp); } },
  { "WrapMirror", [](S&, M* m) { SetWrap(m, MesoWrap::Mirror); } },
  { "ScalarColours",
    [](S&, M* m)
    {
      vtkNew<vtkFloatArray> scalars;
      for (vtkIdType i = 0; i < m->GetInput()->GetNumberOfPoints(); ++i)
      {
        scalars->InsertNextValue(static_cast<float>(i % 7));
      }
      m->GetInput()->GetPointData()->SetScalars(scalars);
      m->SetScalarRange(0., 7.);
    } },
};

class ReliefCombinations : public testing::TestWithParam<std::tuple<MesoTechnique, Combination>>
{
protected:
  static vtkSmartPointer<vtkImageData> Draw(const Combination& combination, MesoTechnique technique)
  {
    MesoTestScene scene;
    const auto torus = MesoTestScene::Shape("torus");
    vtkSmartPointer<vtkMesoPolyDataMapper> mapper;
    if (technique != MesoTechnique::Plain)
    {
      vtkNew<vtkMesoReliefMapper> withMap;
      MesoUse(withMap, technique, torus);
      withMap->SetHeightMap(MesoTestScene::Pattern("brick"));
      mapper = withMap;
    }
    else
    {
      mapper = vtkSmartPointer<vtkMesoPolyDataMapper>::New();
      mapper->SetInputData(torus);
    }
    mapper->SetScale(0.1);
    mapper->SetTiles(6., 3.);
    scene.Actor->SetMapper(mapper);
    scene.AddDirectionalLight(-1., -2., -1.);
    scene.LookFrom(1., 3., 5.);
    combination.Apply(scene, mapper);
    return MesoGrabWindow(scene.Window);
  }
};
}

TEST_P(ReliefCombinations, CompilesAndShowsRelief)
{
  const Combination& combination = std::get<1>(this->GetParam());
  const auto relief = Draw(combination, std::get<0>(this->GetParam()));
  const auto plain = Draw(combination, MesoTechnique::Plain);
  EXPECT_FALSE(MesoCompareImages(relief, plain).Within) << "the relief is not seen";
}

INSTANTIATE_TEST_SUITE_P(All, ReliefCombinations,
  testing::Combine(testing::Values(MesoTechnique::Relief, MesoTechnique::ReliefQuadric),
    testing::ValuesIn(Combinations)),
  [](const testing::TestParamInfo<ReliefCombinations::ParamType>& info)
  {
    return MesoTechniqueTestName(std::get<0>(info.param)) +
      std::string(std::get<1>(info.param).Name);
  });

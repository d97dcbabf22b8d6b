// What `relief` costs at each quality, beside `plain` and VTK's own mapper on the same mesh: a torus
// of 4608 triangles at 512 x 512, one directional light; the materials change from table to table.
// All are measured in one process, interleaved, as ratios to VTK's mapper.

#include "MesoFrameCost.h"
#include "MesoTestScene.h"

#include "vtkMesoReliefMapper.h"

#include "vtkTexture.h"

#include <cstdio>
#include <functional>

namespace
{
struct Arm
{
  std::string Name;
  vtkSmartPointer<vtkActor> Actor;
};

vtkSmartPointer<vtkTexture> MakeTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(256, 256, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 256 * 256 * 3; ++i)
  {
    value[i] = static_cast<unsigned char>(60 + (i * 7919) % 190);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

void Measure(const char* title, const std::function<void(vtkActor*)>& setMaterial)
{
  MesoTestScene scene(512, 512);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.AddDirectionalLight(-1., -1.2, -1.);
  scene.LookFrom(0., 3.2, 4.8);
  const auto torus = MesoTestScene::Shape("torus", { { "rings", { 64. } }, { "sides", { 36. } } });

  std::vector<Arm> arms;
  const auto add = [&](const std::string& name, vtkPolyDataMapper* mapper)
  {
    mapper->SetInputData(torus);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetProperty(vtkNew<vtkProperty>());
    actor->GetProperty()->DeepCopy(scene.Actor->GetProperty());
    actor->SetMapper(mapper);
    setMaterial(actor);
    scene.Renderer->AddActor(actor);
    arms.push_back({ name, actor });
  };
  add("vtkPolyDataMapper", vtkNew<vtkPolyDataMapper>());
  add("plain", vtkNew<vtkMesoPolyDataMapper>());
  const auto map = MesoTestScene::Pattern("brick", 256, 256);
  for (MesoQuality quality :
    { MesoQuality::Draft, MesoQuality::Low, MesoQuality::Medium, MesoQuality::High })
  {
    vtkNew<vtkMesoReliefMapper> relief;
    MesoMesostructureOptions options = relief->GetOptions();
    options.Quality = quality;
    options.Scale = 0.06;
    options.Tiles = { 8., 3. };
    relief->SetOptions(options);
    relief->SetHeightMap(map);
    add(std::string("relief ") + MesoName(quality), relief);
  }
  std::vector<std::vector<vtkProp*>> groups;
  for (const Arm& arm : arms)
  {
    groups.push_back({ arm.Actor });
  }
  const auto costs = MesoMeasureFrames(scene.Window, groups);
  std::printf(
    "%s\n%s; %s\n", title, scene.Window->GetGLRenderer().c_str(), costs.front().Clock.c_str());
  std::printf("%-20s %10s %10s %10s %8s\n", "", "median ms", "min", "max", "ratio");
  for (std::size_t i = 0; i < arms.size(); ++i)
  {
    std::printf("%-20s %10.3f %10.3f %10.3f %8.2f\n", arms[i].Name.c_str(), costs[i].Gpu.Median,
      costs[i].Gpu.Minimum, costs[i].Gpu.Maximum, costs[i].Gpu.Median / costs[0].Gpu.Median);
  }
  std::printf("\n");
}
}

int main()
{
  Measure("colour alone", [](vtkActor*) {});
  Measure("specular",
    [](vtkActor* actor)
    {
      actor->GetProperty()->SetSpecular(0.3);
      actor->GetProperty()->SetSpecularPower(20.);
    });
  const auto texture = MakeTexture();
  Measure("textured", [&](vtkActor* actor) { actor->SetTexture(texture); });
  return 0;
}

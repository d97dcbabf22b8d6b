// vtkRenderWindow::New() gives the EGL window while the override is installed, with an interactor
// that needs no display; what was there before comes back when it is removed.

#include "EGLTestScene.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

namespace
{
std::string ClassOfWindow()
{
  return vtkSmartPointer<vtkRenderWindow>::New()->GetClassName();
}

std::string ClassOfInteractor()
{
  return vtkSmartPointer<vtkRenderWindowInteractor>::New()->GetClassName();
}

/// Stands for a class that someone else, vtkTesting for one, puts in the interactor's place.
class OthersInteractor : public vtkRenderWindowInteractor
{
public:
  static OthersInteractor* New();
  vtkTypeMacro(OthersInteractor, vtkRenderWindowInteractor);
};
vtkStandardNewMacro(OthersInteractor);

class OthersFactory : public vtkObjectFactory
{
public:
  static OthersFactory* New();
  vtkTypeMacro(OthersFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Someone else's"; }
  void Override(const char* name)
  {
    this->RegisterOverride("vtkRenderWindowInteractor", name, "", 1,
      []() -> vtkObject* { return OthersInteractor::New(); });
  }
};
vtkStandardNewMacro(OthersFactory);

class EGLOverride : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkMesoEGLRenderWindow::RemoveOverride(); // main() installed it
    unsetenv("DISPLAY");
  }
};
}

TEST_F(EGLOverride, GivesTheEGLWindow)
{
  EXPECT_TRUE(vtkMesoEGLRenderWindow::InstallOverride());
  EXPECT_EQ(ClassOfWindow(), "vtkMesoEGLRenderWindow");
  EXPECT_EQ(ClassOfInteractor(), "vtkGenericRenderWindowInteractor");
}

TEST_F(EGLOverride, LeavesADisplayAlone)
{
  setenv("DISPLAY", ":99", 1);
  EXPECT_FALSE(vtkMesoEGLRenderWindow::InstallOverride());
  EXPECT_EQ(ClassOfWindow(), "vtkXOpenGLRenderWindow");
  EXPECT_TRUE(vtkMesoEGLRenderWindow::InstallOverride(false));
  EXPECT_EQ(ClassOfWindow(), "vtkMesoEGLRenderWindow");
  EXPECT_TRUE(vtkMesoEGLRenderWindow::InstallOverride()) << "it is installed, whoever asked";
}

TEST_F(EGLOverride, DrawsWithAnInteractor)
{
  vtkMesoEGLRenderWindow::InstallOverride();
  EGLTestScene scene;
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  scene.ShowIn(window, 40, 40);
  auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  interactor->SetRenderWindow(window);
  window->Render();
  interactor->Start();
  EXPECT_EQ(CentrePixel(window), BallColor);
}

TEST_F(EGLOverride, IsRemoved)
{
  const std::string window = ClassOfWindow();
  const std::string interactor = ClassOfInteractor();
  EXPECT_NE(window, "vtkMesoEGLRenderWindow");
  const int factories = vtkObjectFactory::GetRegisteredFactories()->GetNumberOfItems();
  for (int i = 0; i < 2; ++i)
  {
    vtkMesoEGLRenderWindow::InstallOverride();
    vtkMesoEGLRenderWindow::InstallOverride(); // twice is once
    EXPECT_EQ(ClassOfWindow(), "vtkMesoEGLRenderWindow");
    vtkMesoEGLRenderWindow::RemoveOverride();
    vtkMesoEGLRenderWindow::RemoveOverride();
    EXPECT_EQ(ClassOfWindow(), window);
    EXPECT_EQ(ClassOfInteractor(), interactor);
    EXPECT_EQ(vtkObjectFactory::GetRegisteredFactories()->GetNumberOfItems(), factories);
  }
}

TEST_F(EGLOverride, KeepsTheInteractorOfVTKsTests)
{
  vtkNew<OthersFactory> factory;
  factory->Override("vtkTestingInteractor");
  vtkObjectFactory::RegisterFactory(factory);
  vtkMesoEGLRenderWindow::InstallOverride();
  EXPECT_EQ(ClassOfInteractor(), "OthersInteractor");
  EXPECT_EQ(ClassOfWindow(), "vtkMesoEGLRenderWindow");
  vtkMesoEGLRenderWindow::RemoveOverride();
  vtkObjectFactory::UnRegisterFactory(factory);
}

TEST_F(EGLOverride, LeavesOffWhatWasOffBefore)
{
  vtkNew<OthersFactory> factory;
  factory->Override("OthersInteractor");
  vtkObjectFactory::RegisterFactory(factory);
  factory->Disable("vtkRenderWindowInteractor");
  vtkMesoEGLRenderWindow::InstallOverride();
  vtkMesoEGLRenderWindow::RemoveOverride();
  EXPECT_EQ(factory->GetEnableFlag(0), 0);
  vtkObjectFactory::UnRegisterFactory(factory);
}

TEST_F(EGLOverride, SurvivesThatAllFactoriesAreDropped)
{
  vtkMesoEGLRenderWindow::InstallOverride();
  vtkObjectFactory::UnRegisterAllFactories();
  vtkMesoEGLRenderWindow::RemoveOverride();
  EXPECT_TRUE(vtkMesoEGLRenderWindow::InstallOverride());
  EXPECT_EQ(ClassOfWindow(), "vtkMesoEGLRenderWindow");
}

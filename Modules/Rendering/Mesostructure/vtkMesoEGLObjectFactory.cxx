#include "vtkMesoEGLObjectFactory.h"

#include "vtkCollection.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"

#include <string>  // for class names
#include <utility> // for std::pair
#include <vector>  // for what was switched off

namespace
{
using Override = std::pair<std::string, std::string>; // class, and the subclass it becomes

/// An override that Install switched off. Factory is only compared: it may be gone.
struct SwitchedOff
{
  vtkObjectFactory* Factory;
  Override What;
};

std::vector<SwitchedOff>& OffList()
{
  static std::vector<SwitchedOff> list;
  return list;
}

bool StandsInTheWay(const Override& what)
{
  return what.first == "vtkRenderWindow" ||
    (what.first == "vtkRenderWindowInteractor" && what.second != "vtkTestingInteractor");
}

template <typename Visit>
void ForEachFactory(Visit visit)
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  factories->InitTraversal(iterator);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(iterator))
  {
    visit(factory);
  }
}

/// Ours, if the registry holds it: vtkObjectFactory::UnRegisterAllFactories() may have dropped it.
vtkMesoEGLObjectFactory* FindInstalled()
{
  vtkMesoEGLObjectFactory* found = nullptr;
  ForEachFactory(
    [&found](vtkObjectFactory* factory)
    {
      auto* ours = vtkMesoEGLObjectFactory::SafeDownCast(factory);
      found = ours ? ours : found;
    });
  return found;
}

void SwitchOff(vtkObjectFactory* factory)
{
  for (int i = 0; i < factory->GetNumberOfOverrides(); ++i)
  {
    const Override what(factory->GetClassOverrideName(i), factory->GetClassOverrideWithName(i));
    if (StandsInTheWay(what) && factory->GetEnableFlag(i))
    {
      factory->SetEnableFlag(0, what.first.c_str(), what.second.c_str());
      OffList().push_back({ factory, what });
    }
  }
}

void SwitchOnAgain(vtkObjectFactory* factory)
{
  for (const SwitchedOff& off : OffList())
  {
    if (off.Factory == factory)
    {
      factory->SetEnableFlag(1, off.What.first.c_str(), off.What.second.c_str());
    }
  }
}

vtkObject* CreateWindow()
{
  return vtkMesoEGLRenderWindow::New();
}

vtkObject* CreateInteractor()
{
  return vtkGenericRenderWindowInteractor::New();
}
}

vtkStandardNewMacro(vtkMesoEGLObjectFactory);

vtkMesoEGLObjectFactory::vtkMesoEGLObjectFactory()
{
  this->RegisterOverride("vtkRenderWindow", "vtkMesoEGLRenderWindow",
    "Window of an EGL device, without a display", 1, CreateWindow);
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
    "Interactor without events of its own", 1, CreateInteractor);
}

const char* vtkMesoEGLObjectFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

const char* vtkMesoEGLObjectFactory::GetDescription()
{
  return "Meso: off-screen windows through EGL";
}

void vtkMesoEGLObjectFactory::Install()
{
  // Every time: a factory may have been registered since the last.
  ForEachFactory(
    [](vtkObjectFactory* factory)
    {
      if (!vtkMesoEGLObjectFactory::SafeDownCast(factory))
      {
        SwitchOff(factory);
      }
    });
  if (!FindInstalled())
  {
    vtkNew<vtkMesoEGLObjectFactory> factory;
    vtkObjectFactory::RegisterFactory(factory); // the registry holds it from here on
  }
}

void vtkMesoEGLObjectFactory::Remove()
{
  if (vtkMesoEGLObjectFactory* factory = FindInstalled())
  {
    vtkObjectFactory::UnRegisterFactory(factory);
    ForEachFactory(SwitchOnAgain);
    OffList().clear();
  }
}

bool vtkMesoEGLObjectFactory::IsInstalled()
{
  return FindInstalled() != nullptr;
}

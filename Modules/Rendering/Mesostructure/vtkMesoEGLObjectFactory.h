#ifndef vtkMesoEGLObjectFactory_h
#define vtkMesoEGLObjectFactory_h

/**
 * @class vtkMesoEGLObjectFactory
 * @brief Makes vtkRenderWindow::New() give a vtkMesoEGLRenderWindow while it is installed.
 *
 * vtkObjectFactory takes the first enabled override in order of registration, and VTK's own come
 * first: so they are switched off while this one is installed, and those that were on are switched
 * on again when it is removed. Interactors become vtkGenericRenderWindowInteractor, since VTK's for
 * X ends the process where there is no display; the one of vtkTesting is left alone.
 */

#include "vtkObjectFactory.h"

class vtkMesoEGLObjectFactory : public vtkObjectFactory
{
public:
  static vtkMesoEGLObjectFactory* New();
  vtkTypeMacro(vtkMesoEGLObjectFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

  ///@{
  /// Both may be called any number of times.
  static void Install();
  static void Remove();
  static bool IsInstalled();
  ///@}

protected:
  vtkMesoEGLObjectFactory();
  ~vtkMesoEGLObjectFactory() override = default;

private:
  vtkMesoEGLObjectFactory(const vtkMesoEGLObjectFactory&) = delete;
  void operator=(const vtkMesoEGLObjectFactory&) = delete;
};

#endif

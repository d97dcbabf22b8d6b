#include "vtk_glew.h" // must come first

#include "vtkMesoEGLRenderWindow.h"

#include "MesoEGLChoice.h"
#include "MesoGLDebugLog.h"
#include "vtkMesoEGLObjectFactory.h"

#include "vtkCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <cstdlib> // for std::getenv

namespace
{
bool DebugContextWanted()
{
  const char* value = std::getenv("MESO_GL_DEBUG");
  if (value && *value)
  {
    return std::string(value) != "0";
  }
#ifdef NDEBUG
  return false;
#else
  return true;
#endif
}
}

struct vtkMesoEGLRenderWindow::vtkInternals
{
  MesoEGLContext Context;
  MesoGLDebugLog Log;
  std::string Device;
  bool Debug = false;  ///< a debug context was asked for
  bool Failed = false; ///< said once that there is no context; until Finalize
};

vtkStandardNewMacro(vtkMesoEGLRenderWindow);

vtkMesoEGLRenderWindow::vtkMesoEGLRenderWindow()
  : Internals(std::make_unique<vtkInternals>())
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->FrameBlitMode = NoBlit; // there is no framebuffer 0 to blit to
  this->ScreenSize[0] = this->ScreenSize[1] = 4096;
}

vtkMesoEGLRenderWindow::~vtkMesoEGLRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr); // it may live on, and would point here
  }
}

void vtkMesoEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->Internals->Device << "\n";
  os << indent << "GL debug: " << (this->IsGLDebugActive() ? "on" : "off") << "\n";
  os << indent << "GL errors: " << this->GetNumberOfGLErrors() << "\n";
}

bool vtkMesoEGLRenderWindow::InstallOverride(bool onlyIfHeadless)
{
  const char* display = std::getenv("DISPLAY");
  if (!onlyIfHeadless || !display || !*display)
  {
    vtkMesoEGLObjectFactory::Install();
  }
  return vtkMesoEGLObjectFactory::IsInstalled();
}

void vtkMesoEGLRenderWindow::RemoveOverride()
{
  vtkMesoEGLObjectFactory::Remove();
}

std::vector<std::string> vtkMesoEGLRenderWindow::GetDeviceCandidates()
{
  std::vector<std::string> names;
  for (const MesoEGLCandidate& candidate : MesoEGLCandidates())
  {
    names.push_back(candidate.Name);
  }
  return names;
}

int vtkMesoEGLRenderWindow::GetNumberOfDevices()
{
  return static_cast<int>(MesoEGLCandidates().size());
}

std::string vtkMesoEGLRenderWindow::GetDeviceDescription() const
{
  return this->Internals->Device;
}

std::string vtkMesoEGLRenderWindow::GetGLRenderer()
{
  this->Initialize();
  if (!this->Internals->Context.Exists())
  {
    return {};
  }
  this->MakeCurrent();
  return this->Internals->Context.GetRenderer();
}

bool vtkMesoEGLRenderWindow::IsGLDebugActive() const
{
  return this->Internals->Log.IsAttached();
}

int vtkMesoEGLRenderWindow::GetNumberOfGLErrors() const
{
  return this->Internals->Log.GetCount();
}

const std::vector<std::string>& vtkMesoEGLRenderWindow::GetGLErrorMessages() const
{
  return this->Internals->Log.GetMessages();
}

void vtkMesoEGLRenderWindow::ClearGLErrors()
{
  this->Internals->Log.Clear();
}

void vtkMesoEGLRenderWindow::CreateAWindow()
{
  vtkInternals& self = *this->Internals;
  if (self.Context.Exists() || self.Failed)
  {
    return;
  }
  self.Debug = DebugContextWanted();
  std::string text;
  if (!MesoChooseEGLContext(
        self.Context, MesoEGLCandidates(), std::getenv("MESO_EGL_DEVICE"), self.Debug, text))
  {
    self.Failed = true;
    vtkErrorMacro(<< text);
    return;
  }
  self.Device = text;
  if (this->Size[0] <= 0 || this->Size[1] <= 0)
  {
    this->Size[0] = this->Size[1] = 300;
  }
  this->OwnContext = 1;
  this->Mapped = 0;
}

void vtkMesoEGLRenderWindow::Initialize()
{
  this->CreateAWindow();
  if (!this->Internals->Context.Exists() || this->Initialized)
  {
    return;
  }
  this->MakeCurrent();
  this->OpenGLInit(); // also where ReleaseGraphicsResources was called on a living context
}

void vtkMesoEGLRenderWindow::OpenGLInitContext()
{
  vtkInternals& self = *this->Internals;
  this->ContextCreationTime.Modified();
  if (this->Initialized || !self.Context.Exists())
  {
    return;
  }
  // glewInit loads every entry point of OpenGL before it looks for GLX, which has no display here;
  // its pointers are those of libglvnd and serve any current context.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("GLEW: " << reinterpret_cast<const char*>(glewGetErrorString(result)));
    return;
  }
  this->Initialized = true;
  if (self.Debug)
  {
    self.Log.Attach([this](const std::string& message) { vtkErrorMacro("OpenGL: " << message); });
  }
  GLfloat range[2] = { 1.f, 1.f };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

void vtkMesoEGLRenderWindow::Finalize()
{
  this->DestroyWindow();
  this->Internals->Failed = false;
}

void vtkMesoEGLRenderWindow::DestroyWindow()
{
  vtkInternals& self = *this->Internals;
  if (self.Context.Exists())
  {
    this->MakeCurrent();
    this->ReleaseGraphicsResources(this);
    self.Log.Detach();
    self.Context.Destroy();
  }
}

void vtkMesoEGLRenderWindow::WindowRemap()
{
  this->Finalize();
  this->Initialize();
}

void vtkMesoEGLRenderWindow::MakeCurrent()
{
  MesoEGLContext& context = this->Internals->Context;
  if (context.Exists() && !context.MakeCurrent())
  {
    vtkErrorMacro("The OpenGL context cannot be made current: " << MesoEGLErrorName());
  }
}

void vtkMesoEGLRenderWindow::ReleaseCurrent()
{
  this->Internals->Context.ReleaseCurrent();
}

bool vtkMesoEGLRenderWindow::IsCurrent()
{
  return this->Internals->Context.IsCurrent();
}

int vtkMesoEGLRenderWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Initialized ? 1 : 0;
}

void vtkMesoEGLRenderWindow::Render()
{
  this->Initialize();
  if (this->Initialized) // else VTK would call OpenGL through null pointers
  {
    this->Superclass::Render();
  }
}

int vtkMesoEGLRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  return this->Initialized
    ? this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right)
    : VTK_ERROR;
}

int vtkMesoEGLRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->Initialized ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}

int vtkMesoEGLRenderWindow::GetColorBufferSizes(int* rgba)
{
  if (!rgba)
  {
    return 0;
  }
  rgba[0] = rgba[1] = rgba[2] = rgba[3] = 8;
  return 32;
}

int vtkMesoEGLRenderWindow::GetDepthBufferSize()
{
  return 32;
}

void* vtkMesoEGLRenderWindow::GetGenericDisplayId()
{
  return this->Internals->Context.GetDisplay();
}

void* vtkMesoEGLRenderWindow::GetGenericContext()
{
  return this->Internals->Context.GetContext();
}

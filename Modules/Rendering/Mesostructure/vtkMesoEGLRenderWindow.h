#ifndef vtkMesoEGLRenderWindow_h
#define vtkMesoEGLRenderWindow_h

/**
 * @class vtkMesoEGLRenderWindow
 * @brief Render off screen through EGL, with no display server.
 *
 * An off-screen vtkOpenGLRenderWindow on an OpenGL context (core profile, 3.2 or newer) of its own.
 * It draws into VTK's framebuffer objects (RGBA8, 32 bits of depth); there is no framebuffer 0 and
 * nothing is ever shown. Size, MSAA (VTK lowers MultiSamples to what the driver has), several
 * windows side by side, Finalize and a later Render work as with any VTK window.
 *
 * The device is the first that gives a context of: hardware devices, software devices, Mesa's
 * surfaceless platform. Hardware that was tried in vain is named in GetDeviceDescription. Where no
 * device works there is one error with the list of them and why each fails; then Render does
 * nothing and reading pixels gives VTK_ERROR.
 *
 * Environment, read when a context is made (first Initialize or Render, or after Finalize):
 * - MESO_EGL_DEVICE: index of the one device to use, in the order of GetDeviceCandidates. Unset or
 *   empty: the rule above. If that device does not work nothing else is tried.
 * - MESO_GL_DEBUG: 1 asks for a debug context, whose errors are collected (GetNumberOfGLErrors) and
 *   each reported once by vtkErrorMacro; 0 does not. Unset: on in builds without NDEBUG. Slower.
 *
 * One process must not mix GLX windows and these in one thread: Mesa then ends the process.
 */

#include "mesoRenderingMesostructureModule.h" // for export macro

#include "vtkOpenGLRenderWindow.h"

#include <memory> // for internals
#include <string> // for descriptions
#include <vector> // for lists

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoEGLRenderWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkMesoEGLRenderWindow* New();
  vtkTypeMacro(vtkMesoEGLRenderWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Make vtkRenderWindow::New() give this class, and vtkRenderWindowInteractor::New() one that
   * needs no display. With `onlyIfHeadless` do so only where DISPLAY is unset or empty. Returns
   * whether it is installed. RemoveOverride puts back what was there before. Call before windows
   * are made, from one thread.
   */
  static bool InstallOverride(bool onlyIfHeadless = true);
  static void RemoveOverride();
  ///@}

  /// Every device that EGL lists, in the order in which they are tried; the place in this list is
  /// the index that MESO_EGL_DEVICE takes. Says nothing about whether a device works.
  static std::vector<std::string> GetDeviceCandidates();

  /// The number of candidates.
  int GetNumberOfDevices() override;

  /// Index and name of the device in use, and the hardware that was passed over with the reason.
  /// Empty before the first context.
  std::string GetDeviceDescription() const;

  /// GL_RENDERER of the context ("llvmpipe (LLVM 15.0.6, 256 bits)"), made if there is none yet.
  /// Empty where none can be made.
  std::string GetGLRenderer();

  ///@{
  /**
   * What KHR_debug reported since the window was made or ClearGLErrors was called: errors and
   * undefined behaviour, in all of its contexts. Messages holds each different text once (64 at
   * most). IsGLDebugActive is false where the context is no debug one: nothing is counted then.
   */
  bool IsGLDebugActive() const;
  int GetNumberOfGLErrors() const;
  const std::vector<std::string>& GetGLErrorMessages() const;
  void ClearGLErrors();
  ///@}

  ///@{
  /// The context, made current and released. Finalize frees everything of OpenGL; Initialize or
  /// Render makes it anew.
  void Initialize() override;
  void Finalize() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override;
  void OpenGLInitContext() override;
  void WindowRemap() override;
  ///@}

  void Render() override;
  using Superclass::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;

  ///@{
  /// What VTK's framebuffer objects have. VTK would ask framebuffer 0, which raises a GL error.
  int GetColorBufferSizes(int* rgba) override;
  int GetDepthBufferSize() override;
  ///@}

  ///@{
  /// There is no window: these do nothing, or say so.
  void SetShowWindow(bool) override {}
  void SetUseOffScreenBuffers(bool) override {}
  void SetFullScreen(vtkTypeBool) override {}
  void HideCursor() override {}
  void ShowCursor() override {}
  void SetDisplayId(void*) override {}
  void SetWindowId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  int* GetScreenSize() VTK_SIZEHINT(2) override { return this->ScreenSize; }
  vtkTypeBool IsDirect() override { return 1; }
  vtkTypeBool GetEventPending() override { return 0; }
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }
  ///@}

  void* GetGenericDisplayId() override; ///< the EGLDisplay
  void* GetGenericContext() override;   ///< the EGLContext

protected:
  vtkMesoEGLRenderWindow();
  ~vtkMesoEGLRenderWindow() override;

  void CreateAWindow() override;
  void DestroyWindow() override;
  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;

private:
  vtkMesoEGLRenderWindow(const vtkMesoEGLRenderWindow&) = delete;
  void operator=(const vtkMesoEGLRenderWindow&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

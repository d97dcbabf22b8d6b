#ifndef MesoEGLContext_h
#define MesoEGLContext_h

/**
 * @file MesoEGLContext.h
 * @brief An OpenGL core context on an EGL display, without a window.
 *
 * The newest of 4.6 to 3.2 core that the display gives. Where the display knows contexts without a
 * surface there is none, and no framebuffer 0 to draw into; else a pbuffer of one pixel stands in.
 */

#include "MesoEGLDisplay.h"

#include <string> // for reasons

class MesoEGLContext
{
public:
  MesoEGLContext() = default;
  ~MesoEGLContext() { this->Destroy(); }
  MesoEGLContext(const MesoEGLContext&) = delete;
  MesoEGLContext& operator=(const MesoEGLContext&) = delete;

  /// Makes a context on the candidate's display, and makes it current. False, with `reason` set
  /// and nothing held, where any step fails.
  bool Create(const MesoEGLCandidate& candidate, bool debug, std::string& reason);
  void Destroy();

  bool Exists() const { return this->Context != EGL_NO_CONTEXT; }
  EGLDisplay GetDisplay() const { return this->Display.Get(); }
  EGLContext GetContext() const { return this->Context; }

  ///@{
  /// For the calling thread. MakeCurrent is false where EGL refuses (see MesoEGLErrorName).
  bool MakeCurrent();
  void ReleaseCurrent();
  bool IsCurrent() const;
  ///@}

  /// GL_RENDERER of the context, which must be current.
  std::string GetRenderer() const;

private:
  bool Build(bool debug, std::string& reason);

  MesoEGLDisplay Display;
  EGLContext Context = EGL_NO_CONTEXT;
  EGLSurface Surface = EGL_NO_SURFACE;
};

/// True where a GL_RENDERER names one of Mesa's or Google's rasterisers on the CPU.
bool MesoIsSoftwareRenderer(const std::string& renderer);

#endif

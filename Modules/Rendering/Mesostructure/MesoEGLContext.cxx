#include "MesoEGLContext.h"

namespace
{
// From <GL/gl.h>, which this file does without: everything comes through eglGetProcAddress.
constexpr unsigned int GLRendererName = 0x1F01;
using GetStringFunction = const unsigned char*(EGLAPIENTRYP)(unsigned int);

EGLContext NewestContext(EGLDisplay display, EGLConfig config, bool debug)
{
  static const EGLint versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 },
    { 4, 0 }, { 3, 3 }, { 3, 2 } };
  for (const auto& version : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
      debug ? EGL_CONTEXT_OPENGL_DEBUG : EGL_NONE, EGL_TRUE, EGL_NONE };
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  return EGL_NO_CONTEXT;
}
}

bool MesoEGLContext::Create(const MesoEGLCandidate& candidate, bool debug, std::string& reason)
{
  this->Destroy();
  if (!this->Display.Acquire(candidate.Display, reason))
  {
    return false;
  }
  if (!this->Build(debug, reason))
  {
    this->Destroy();
    return false;
  }
  return true;
}

bool MesoEGLContext::Build(bool debug, std::string& reason)
{
  const EGLDisplay display = this->Display.Get();
  if (!eglBindAPI(EGL_OPENGL_API))
  {
    reason = "no desktop OpenGL: " + MesoEGLErrorName();
    return false;
  }
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  const bool surfaceless = MesoEGLHasExtension(extensions, "EGL_KHR_surfaceless_context");
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!surfaceless || !MesoEGLHasExtension(extensions, "EGL_KHR_no_config_context"))
  {
    const EGLint attributes[] = { EGL_SURFACE_TYPE, surfaceless ? EGL_DONT_CARE : EGL_PBUFFER_BIT,
      EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
    EGLint count = 0;
    if (!eglChooseConfig(display, attributes, &config, 1, &count) || count < 1)
    {
      reason = "no configuration for OpenGL: " + MesoEGLErrorName();
      return false;
    }
  }
  this->Context = NewestContext(display, config, debug);
  if (this->Context == EGL_NO_CONTEXT && debug)
  {
    this->Context = NewestContext(display, config, false); // before EGL 1.5 there are no debug ones
  }
  if (this->Context == EGL_NO_CONTEXT)
  {
    reason = "no OpenGL 3.2 core context: " + MesoEGLErrorName();
    return false;
  }
  if (!surfaceless)
  {
    const EGLint attributes[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    this->Surface = eglCreatePbufferSurface(display, config, attributes);
    if (this->Surface == EGL_NO_SURFACE)
    {
      reason = "eglCreatePbufferSurface: " + MesoEGLErrorName();
      return false;
    }
  }
  if (!this->MakeCurrent())
  {
    reason = "eglMakeCurrent: " + MesoEGLErrorName();
    return false;
  }
  return true;
}

void MesoEGLContext::Destroy()
{
  const EGLDisplay display = this->Display.Get();
  if (this->Exists())
  {
    this->ReleaseCurrent();
    eglDestroyContext(display, this->Context);
    this->Context = EGL_NO_CONTEXT;
  }
  if (this->Surface != EGL_NO_SURFACE)
  {
    eglDestroySurface(display, this->Surface);
    this->Surface = EGL_NO_SURFACE;
  }
  this->Display.Release();
}

bool MesoEGLContext::MakeCurrent()
{
  return this->IsCurrent() ||
    eglMakeCurrent(this->Display.Get(), this->Surface, this->Surface, this->Context) == EGL_TRUE;
}

void MesoEGLContext::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    eglMakeCurrent(this->Display.Get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

bool MesoEGLContext::IsCurrent() const
{
  return this->Exists() && eglGetCurrentContext() == this->Context;
}

std::string MesoEGLContext::GetRenderer() const
{
  const auto getString = reinterpret_cast<GetStringFunction>(eglGetProcAddress("glGetString"));
  const unsigned char* text = getString ? getString(GLRendererName) : nullptr;
  return text ? reinterpret_cast<const char*>(text) : "";
}

bool MesoIsSoftwareRenderer(const std::string& renderer)
{
  for (const char* name :
    { "llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader" })
  {
    if (renderer.find(name) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

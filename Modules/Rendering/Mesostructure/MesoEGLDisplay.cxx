#include "MesoEGLDisplay.h"

#include <algorithm> // for std::stable_sort
#include <cstring>   // for std::strstr
#include <map>       // for the counts
#include <mutex>     // for the counts

// Names that headers older than EGL_EXT_device_query_name and _drm_render_node lack.
#ifndef EGL_RENDERER_EXT
#define EGL_RENDERER_EXT 0x335F
#endif
#ifndef EGL_DRM_RENDER_NODE_FILE_EXT
#define EGL_DRM_RENDER_NODE_FILE_EXT 0x3377
#endif

namespace
{
std::mutex HoldMutex;

std::map<EGLDisplay, int>& Holds()
{
  static std::map<EGLDisplay, int> holds;
  return holds;
}

template <typename Function>
Function Load(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// The extension functions, all null where the client library lacks them.
struct Entries
{
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay =
    Load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = Load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString =
    Load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
};

std::string DescribeDevice(const Entries& egl, EGLDeviceEXT device, const char* extensions)
{
  // A string is asked for only where its own extension is listed: else EGL raises an error.
  const std::pair<const char*, EGLint> queries[] = {
    { "EGL_EXT_device_query_name", EGL_RENDERER_EXT },
    { "EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT },
    { "EGL_EXT_device_drm_render_node", EGL_DRM_RENDER_NODE_FILE_EXT },
  };
  std::string text;
  for (const auto& [extension, name] : queries)
  {
    const char* value =
      MesoEGLHasExtension(extensions, extension) ? egl.QueryDeviceString(device, name) : nullptr;
    if (value && *value)
    {
      text += std::string(text.empty() ? " " : ", ") + value;
    }
  }
  return text;
}

void AddDevices(const Entries& egl, std::vector<MesoEGLCandidate>& candidates)
{
  EGLint count = 0;
  if (!egl.QueryDevices(0, nullptr, &count) || count <= 0)
  {
    return;
  }
  std::vector<EGLDeviceEXT> devices(count);
  if (!egl.QueryDevices(count, devices.data(), &count))
  {
    return;
  }
  for (EGLint i = 0; i < count; ++i)
  {
    const char* extensions = egl.QueryDeviceString(devices[i], EGL_EXTENSIONS);
    MesoEGLCandidate candidate;
    candidate.Hardware = !MesoEGLHasExtension(extensions, "EGL_MESA_device_software");
    candidate.Name = "EGL device " + std::to_string(i) +
      (candidate.Hardware ? DescribeDevice(egl, devices[i], extensions) + " (hardware)"
                          : " (software)");
    candidate.Display = egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    candidates.push_back(candidate);
  }
}
}

std::vector<MesoEGLCandidate> MesoEGLCandidates()
{
  std::vector<MesoEGLCandidate> candidates;
  const Entries egl;
  // Null where the client library is too old for client extensions.
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!egl.GetPlatformDisplay)
  {
    return candidates;
  }
  if (egl.QueryDevices && egl.QueryDeviceString &&
    MesoEGLHasExtension(extensions, "EGL_EXT_platform_device"))
  {
    AddDevices(egl, candidates);
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const MesoEGLCandidate& a, const MesoEGLCandidate& b) { return a.Hardware > b.Hardware; });
  }
  if (MesoEGLHasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    MesoEGLCandidate candidate;
    candidate.Name = "Mesa's surfaceless platform";
    candidate.Display =
      egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    candidates.push_back(candidate);
  }
  return candidates;
}

bool MesoEGLHasExtension(const char* list, const char* name)
{
  // Whole words: "EGL_EXT_device_drm" also begins "EGL_EXT_device_drm_render_node".
  const std::size_t length = std::strlen(name);
  for (const char* at = list ? std::strstr(list, name) : nullptr; at;
       at = std::strstr(at + length, name))
  {
    if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

std::string MesoEGLErrorName()
{
  static const char* const names[] = { "EGL_SUCCESS", "EGL_NOT_INITIALIZED", "EGL_BAD_ACCESS",
    "EGL_BAD_ALLOC", "EGL_BAD_ATTRIBUTE", "EGL_BAD_CONFIG", "EGL_BAD_CONTEXT",
    "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY", "EGL_BAD_MATCH", "EGL_BAD_NATIVE_PIXMAP",
    "EGL_BAD_NATIVE_WINDOW", "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE", "EGL_CONTEXT_LOST" };
  const EGLint error = eglGetError(); // consecutive numbers from EGL_SUCCESS on
  const EGLint index = error - EGL_SUCCESS;
  const bool known = index >= 0 && index < EGLint(sizeof(names) / sizeof(names[0]));
  return known ? names[index] : "EGL error " + std::to_string(error);
}

bool MesoEGLDisplay::Acquire(EGLDisplay display, std::string& reason)
{
  this->Release();
  if (display == EGL_NO_DISPLAY)
  {
    reason = "EGL gives no display for it";
    return false;
  }
  const std::lock_guard<std::mutex> lock(HoldMutex);
  if (!eglInitialize(display, nullptr, nullptr))
  {
    reason = "eglInitialize: " + MesoEGLErrorName();
    return false;
  }
  ++Holds()[display];
  this->Display = display;
  return true;
}

void MesoEGLDisplay::Release()
{
  if (this->Display == EGL_NO_DISPLAY)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(HoldMutex);
  if (--Holds()[this->Display] == 0)
  {
    Holds().erase(this->Display);
    eglTerminate(this->Display);
  }
  this->Display = EGL_NO_DISPLAY;
}

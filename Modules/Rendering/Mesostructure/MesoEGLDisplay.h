#ifndef MesoEGLDisplay_h
#define MesoEGLDisplay_h

/**
 * @file MesoEGLDisplay.h
 * @brief What EGL offers to draw with, and a counted hold on one of these displays.
 *
 * EGL numbers its devices as its vendors' libraries please; here they are ordered: hardware
 * devices, then software devices, then Mesa's surfaceless platform. An index means a place in that
 * order.
 */

#define EGL_NO_X11 // Xlib's macros (None, Bool, Status) would meet VTK's names
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string> // for names
#include <vector> // for the list

/// Something that may give an EGLDisplay. Display is EGL_NO_DISPLAY where EGL gave none.
struct MesoEGLCandidate
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  std::string Name;      ///< for people: device number of EGL, its file or renderer, its kind
  bool Hardware = false; ///< a device that does not say that it is a software one
};

/// All candidates in the order in which they are tried. Empty where EGL knows no such platform.
std::vector<MesoEGLCandidate> MesoEGLCandidates();

/// True where the blank-separated `list` (may be null) has `name` as a whole word.
bool MesoEGLHasExtension(const char* list, const char* name);

/// Name of the last EGL error of this thread, "EGL_BAD_ALLOC" for example.
std::string MesoEGLErrorName();

/**
 * A hold on an initialised EGLDisplay. eglTerminate ends a display for everyone in the process,
 * however often eglInitialize was called, so holds are counted and the last one terminates.
 */
class MesoEGLDisplay
{
public:
  MesoEGLDisplay() = default;
  ~MesoEGLDisplay() { this->Release(); }
  MesoEGLDisplay(const MesoEGLDisplay&) = delete;
  MesoEGLDisplay& operator=(const MesoEGLDisplay&) = delete;

  /// Initialises the display and holds it. False, with `reason` set, where that fails.
  bool Acquire(EGLDisplay display, std::string& reason);
  void Release();
  EGLDisplay Get() const { return this->Display; }

private:
  EGLDisplay Display = EGL_NO_DISPLAY;
};

#endif

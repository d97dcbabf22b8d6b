#ifndef MesoGLDebugLog_h
#define MesoGLDebugLog_h

/**
 * @file MesoGLDebugLog.h
 * @brief Collects what OpenGL says against us in a debug context (KHR_debug).
 *
 * Errors and undefined behaviour are kept; notes on speed, portability and memory are not. All are
 * counted; the texts of the first 64 that differ are kept.
 */

#include <functional> // for the report
#include <string>     // for messages
#include <vector>     // for messages

class MesoGLDebugLog
{
public:
  /// Called with each text that is new, from inside the GL call that raised it.
  using Report = std::function<void(const std::string&)>;

  /// Starts to listen to the current context, which must be a debug one with its entry points
  /// loaded. False where it has no KHR_debug. This object must outlive the context, or stay where
  /// it is until Detach.
  bool Attach(Report report);
  /// Stops listening to the current context.
  void Detach();

  bool IsAttached() const { return this->Attached; }
  int GetCount() const { return this->Count; }
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  void Clear();
  void Add(const std::string& message);

private:
  Report Tell;
  std::vector<std::string> Messages;
  int Count = 0;
  bool Attached = false;
};

#endif

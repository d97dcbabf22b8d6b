#ifndef MesoExpectedMessages_h
#define MesoExpectedMessages_h

/**
 * @file MesoExpectedMessages.h
 * @brief Turn VTK's errors and warnings into test failures, except those that a test expects.
 *
 *   {
 *     MesoExpectedMessages expected("no tangents");
 *     filter->Update();
 *   } // fails here if nothing that contains "no tangents" was said
 *
 * Anything that is said outside such a scope, or does not contain its text, fails the running test.
 */

#include <string> // for messages
#include <vector> // for messages

/// While one lives, messages that contain its text are taken by it. Scopes may nest.
class MesoExpectedMessages
{
public:
  explicit MesoExpectedMessages(const std::string& text);
  ~MesoExpectedMessages();
  MesoExpectedMessages(const MesoExpectedMessages&) = delete;
  MesoExpectedMessages& operator=(const MesoExpectedMessages&) = delete;

  /// What was taken so far.
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  int GetCount() const { return static_cast<int>(this->Messages.size()); }

private:
  friend class vtkMesoTestOutputWindow;
  std::string Text;
  std::vector<std::string> Messages;
};

/// Makes VTK's messages come here, for the rest of the process.
void MesoFailOnMessages();

#endif

#include "MesoExpectedMessages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm> // for std::find
#include <gtest/gtest.h>
#include <mutex> // for filters that speak from several threads

namespace
{
std::mutex Mutex;
std::vector<MesoExpectedMessages*> Scopes;
}

class vtkMesoTestOutputWindow : public vtkOutputWindow
{
public:
  static vtkMesoTestOutputWindow* New();
  vtkTypeMacro(vtkMesoTestOutputWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { Judge("error", text); }
  void DisplayWarningText(const char* text) override { Judge("warning", text); }
  void DisplayGenericWarningText(const char* text) override { Judge("warning", text); }
  void DisplayText(const char* text) override { std::cerr << text; }

protected:
  vtkMesoTestOutputWindow() = default;
  ~vtkMesoTestOutputWindow() override = default;

private:
  static void Judge(const char* kind, const char* text)
  {
    {
      const std::lock_guard<std::mutex> lock(Mutex);
      for (auto scope = Scopes.rbegin(); scope != Scopes.rend(); ++scope) // innermost first
      {
        if (std::string(text).find((*scope)->Text) != std::string::npos)
        {
          (*scope)->Messages.emplace_back(text);
          return;
        }
      }
    }
    ADD_FAILURE() << "unexpected " << kind << ": " << text;
  }
};

vtkStandardNewMacro(vtkMesoTestOutputWindow);

MesoExpectedMessages::MesoExpectedMessages(const std::string& text)
  : Text(text)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  Scopes.push_back(this);
}

MesoExpectedMessages::~MesoExpectedMessages()
{
  {
    const std::lock_guard<std::mutex> lock(Mutex);
    Scopes.erase(std::find(Scopes.begin(), Scopes.end(), this));
  }
  EXPECT_FALSE(this->Messages.empty()) << "expected a message with \"" << this->Text << "\"";
}

void MesoFailOnMessages()
{
  vtkNew<vtkMesoTestOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  // VTK sends each message to its log as well, which would print those that are expected.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

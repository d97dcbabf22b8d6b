#include "MesoVtkXml.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"
#include "vtkXMLReader.h"

namespace
{
/// The message of VTK's text, without the place in the source before it and the lines after it.
std::string MessageOf(const char* text)
{
  std::string message = text ? text : "unknown error";
  const std::size_t name = message.find("): ");
  message = name == std::string::npos ? message : message.substr(name + 3);
  message = message.substr(0, message.find('\n'));
  message.erase(message.find_last_not_of(" \r\t") + 1);
  return MesoPrintable(message);
}

/// Takes what parts of VTK's reader that cannot be observed would write to standard error.
class ErrorWindow : public vtkOutputWindow
{
public:
  static ErrorWindow* New();
  vtkTypeMacro(ErrorWindow, vtkOutputWindow);

  std::string First;

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    this->First = this->First.empty() ? MessageOf(text) : this->First;
  }
};
vtkStandardNewMacro(ErrorWindow);

/// Keeps the first error that any part of VTK's reader gives, and keeps it off the screen.
class FirstError
{
public:
  explicit FirstError(vtkXMLReader* reader)
    : Before(vtkOutputWindow::GetInstance())
  {
    vtkOutputWindow::SetInstance(this->Window);
    this->Command->SetClientData(this->Window);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* window, void* text)
      { static_cast<ErrorWindow*>(window)->DisplayErrorText(static_cast<const char*>(text)); });
    reader->AddObserver(vtkCommand::ErrorEvent, this->Command);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
    reader->SetReaderErrorObserver(this->Command);
    reader->SetParserErrorObserver(this->Command);
  }
  ~FirstError() { vtkOutputWindow::SetInstance(this->Before); }
  FirstError(const FirstError&) = delete;
  FirstError& operator=(const FirstError&) = delete;

  const std::string& Get() const { return this->Window->First; }

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkNew<ErrorWindow> Window;
  vtkNew<vtkCallbackCommand> Command;
};
}

void MesoReadVtkXml(vtkXMLReader* reader, const std::string& bytes, const std::string& fileName)
{
  if (bytes.find("<VTKFile") == std::string::npos)
  {
    throw MesoInputError(fileName + ": is no VTK XML file: it has no element VTKFile");
  }
  FirstError error(reader);
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  if (!error.Get().empty())
  {
    throw MesoInputError(fileName + ": " + error.Get());
  }
}

#include "MesoAlgorithmRun.h"

#include "MesoScene.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

namespace
{
/// Collects what an algorithm says by its error and warning events.
class Listener
{
public:
  explicit Listener(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* listener = static_cast<Listener*>(self);
        (event == vtkCommand::ErrorEvent ? listener->Errors : listener->Warnings)
          .push_back(Listener::Message(static_cast<const char*>(text)));
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }
  ~Listener() { this->Object->RemoveObserver(this->Command); }
  Listener(const Listener&) = delete;
  void operator=(const Listener&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  /// VTK's text without the place in the source before it and the blank lines after it.
  static std::string Message(const char* text)
  {
    std::string message = text ? text : "unknown error";
    const std::size_t name = message.find("): ");
    if (name != std::string::npos)
    {
      message = message.substr(name + 3);
    }
    message.erase(message.find_last_not_of(" \n\r\t") + 1);
    return message;
  }

  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};
}

void MesoRunAlgorithm(
  vtkAlgorithm* algorithm, const std::string& place, std::vector<std::string>& warnings)
{
  Listener listener(algorithm);
  algorithm->Update();
  if (!listener.Errors.empty())
  {
    throw MesoInputError(place + ": " + listener.Errors.front());
  }
  for (const std::string& warning : listener.Warnings)
  {
    warnings.push_back(place + ": " + warning);
  }
}

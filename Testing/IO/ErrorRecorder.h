#ifndef ErrorRecorder_h
#define ErrorRecorder_h

#include "vtkCommand.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// Keeps the errors and warnings of the objects that it watches, and keeps them off the screen.
class ErrorRecorder
{
public:
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this, &ErrorRecorder::KeepError);
    object->AddObserver(vtkCommand::WarningEvent, this, &ErrorRecorder::KeepWarning);
  }

  void Clear()
  {
    this->Errors.clear();
    this->Warnings.clear();
  }

private:
  void KeepError(vtkObject*, unsigned long, void* text)
  {
    this->Errors.emplace_back(static_cast<const char*>(text));
  }
  void KeepWarning(vtkObject*, unsigned long, void* text)
  {
    this->Warnings.emplace_back(static_cast<const char*>(text));
  }
};

#endif

#include "vtkMesoMovedMesh.h"

#include "MesoFitInput.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

vtkStandardNewMacro(vtkMesoMovedMesh);

namespace
{
/// The input's points, each moved along its normal.
vtkSmartPointer<vtkPoints> MovedPoints(vtkPolyData* input, double distance)
{
  vtkDataArray* array = MesoFindNormals(input);
  if (!array)
  {
    throw std::invalid_argument(
      "the mesh has no normals to move along: vtkMesoSurfaceFrames makes them");
  }
  const auto normals = MesoTuples<3>(array, "the normal");
  const auto positions = MesoTuples<3>(input->GetPoints()->GetData(), "the position");
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(input->GetNumberOfPoints());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const double length = MesoLength(normals[i]);
    if (!(length > 0.))
    {
      throw std::invalid_argument("the normal of point " + std::to_string(i) + " has length 0");
    }
    const MesoVector place = MesoSum(positions[i], MesoScaled(normals[i], distance / length));
    points->SetPoint(static_cast<vtkIdType>(i), place.data());
  }
  return points;
}
}

int vtkMesoMovedMesh::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorMessage =
    MesoFitFailure("points", [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoMovedMesh::Execute(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!std::isfinite(this->Distance))
  {
    throw std::invalid_argument("Distance must be finite");
  }
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(input);
  moved->SetPoints(MovedPoints(input, this->Distance));
  this->UpdateProgress(0.2);
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(moved);
  // What is wrong is said once, by this filter.
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  frames->AddObserver(vtkCommand::ErrorEvent, silence);
  frames->Update();
  if (!frames->GetErrorMessage().empty())
  {
    throw std::invalid_argument(frames->GetErrorMessage());
  }
  output->ShallowCopy(frames->GetOutput());
}

void vtkMesoMovedMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

#include "vtkMesoImageError.h"

#include "MesoPictureError.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoImageError);

vtkMesoImageError::vtkMesoImageError()
{
  this->SetNumberOfInputPorts(2);
  const MesoPictureError none;
  this->FlipMean = none.FlipMean;
  this->Ssim = none.Ssim;
  this->Rmse = none.Rmse;
}

void vtkMesoImageError::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FlipMean: " << this->FlipMean << "\n";
  os << indent << "Ssim: " << this->Ssim << "\n";
  os << indent << "Rmse: " << this->Rmse << "\n";
}

int vtkMesoImageError::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMesoImageError::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputVector->GetInformationObject(0), VTK_FLOAT, 1);
  return 1;
}

int vtkMesoImageError::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Each pixel's surroundings count, and the two may differ in size, which is told in RequestData.
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
  return 1;
}

int vtkMesoImageError::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* truth = vtkImageData::GetData(inputVector[0]);
  vtkImageData* test = vtkImageData::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  MesoPictureError error;
  try
  {
    error = MesoComparePictures(MesoPictureOfImage(truth), MesoPictureOfImage(test));
    output->CopyStructure(truth);
    output->AllocateScalars(VTK_FLOAT, 1);
    output->GetPointData()->GetScalars()->SetName("FLIP");
    const int* size = output->GetDimensions();
    auto* out = static_cast<float*>(output->GetScalarPointer());
    for (int row = size[1] - 1; row >= 0; --row)
    {
      const auto first = error.FlipMap.begin() + std::ptrdiff_t(row) * size[0];
      out = std::copy(first, first + size[0], out);
    }
  }
  catch (const MesoInputError& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  this->FlipMean = error.FlipMean;
  this->Ssim = error.Ssim;
  this->Rmse = error.Rmse;
  return 1;
}

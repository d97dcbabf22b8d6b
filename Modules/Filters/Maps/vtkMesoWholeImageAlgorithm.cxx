#include "vtkMesoWholeImageAlgorithm.h"

#include "MesoWholeImage.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

int vtkMesoWholeImageAlgorithm::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMesoWholeImageAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int extent[6];
  MesoGetWholeExtent(inputVector[0]->GetInformationObject(0), extent);
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkMesoWholeImageAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  MesoAskForWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

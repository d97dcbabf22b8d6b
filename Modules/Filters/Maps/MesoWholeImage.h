#ifndef MesoWholeImage_h
#define MesoWholeImage_h

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

/// The whole extent of the image that a filter's input has.
inline void MesoGetWholeExtent(vtkInformation* input, int extent[6])
{
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
}

/// Asks a filter's input for all of its image, whatever part of the output is wanted.
inline void MesoAskForWholeImage(vtkInformation* input)
{
  int extent[6];
  MesoGetWholeExtent(input, extent);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
}

#endif

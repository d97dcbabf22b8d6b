#ifndef MesoTestVDM_h
#define MesoTestVDM_h

#include "vtkMesoVDM.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

/// A small table of view-dependent displacements of a map. rank 0: the table itself.
inline vtkSmartPointer<vtkImageData> MesoSmallVDM(
  vtkImageData* heights, double depth, int rank = 0, int size = 24, int azimuths = 12)
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = size;
  layout.Azimuths = azimuths;
  layout.Curvatures = 4; // -1.5, 0, 1.5, 3
  layout.FirstCurvature = -1.5;
  layout.Depth = depth;
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(heights);
  filter->SetLayout(layout);
  filter->SetRanks(rank, rank);
  filter->Update();
  return filter->GetOutput();
}

#endif

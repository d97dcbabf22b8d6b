#include "vtkMesoHorizonMap.h"

#include "MesoHorizonSweep.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMesoHorizonMap);

void vtkMesoHorizonMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuths: " << this->Azimuths << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
}

void vtkMesoHorizonMap::Compute(const Map& map, vtkImageData* output)
{
  const MesoHorizonSweep sweep(
    map.Width, map.Height, this->GetWrap(), map.Heights, this->Reach, this->Scale);
  const vtkIdType texels = output->GetNumberOfPoints();
  vtkNew<vtkFloatArray> horizon;
  horizon->SetName("Horizon");
  horizon->SetNumberOfComponents(this->Azimuths);
  horizon->SetNumberOfTuples(texels);
  // A few directions at a time, between which progress is told.
  constexpr int AtOnce = 8;
  for (int done = 0; done < this->Azimuths && !this->GetAbortExecute(); done += AtOnce)
  {
    vtkSMPTools::For(done, std::min(done + AtOnce, this->Azimuths), 1,
      [&](vtkIdType first, vtkIdType end)
      {
        for (vtkIdType k = first; k < end; ++k)
        {
          const std::vector<float> angles =
            sweep.Sweep(2. * vtkMath::Pi() * static_cast<double>(k) / this->Azimuths);
          float* target = horizon->GetPointer(k);
          for (const float angle : angles)
          {
            *target = angle;
            target += this->Azimuths;
          }
        }
      });
    this->UpdateProgress(std::min(1., double(done + AtOnce) / this->Azimuths));
  }
  if (this->GetAbortExecute())
  {
    return;
  }
  vtkNew<vtkFloatArray> ambient;
  ambient->SetName("AmbientOcclusion");
  ambient->SetNumberOfTuples(texels);
  for (vtkIdType i = 0; i < texels; ++i)
  {
    const float* angles = horizon->GetPointer(i * this->Azimuths);
    double open = 0.;
    for (int k = 0; k < this->Azimuths; ++k)
    {
      const double cosine = std::cos(static_cast<double>(angles[k]));
      open += cosine * cosine;
    }
    ambient->SetValue(i, static_cast<float>(open / this->Azimuths));
  }
  output->GetPointData()->SetScalars(horizon);
  output->GetPointData()->AddArray(ambient);
}

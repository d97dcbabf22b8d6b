#include "vtkMesoBumpMapper.h"

#include "MesoBumpShader.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMesoBumpMapper);

vtkMesoBumpMapper::vtkMesoBumpMapper()
  : Bump(std::make_unique<MesoBumpShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Bump;
  this->SetOptions(options);
}

vtkMesoBumpMapper::~vtkMesoBumpMapper() = default;

void vtkMesoBumpMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->Bump->GetHeightMap() << "\n";
  os << indent << "HorizonMap: " << this->Bump->GetHorizon().GetHorizonMap() << "\n";
}

void vtkMesoBumpMapper::SetHeightMap(vtkImageData* heights)
{
  if (heights != this->Bump->GetHeightMap())
  {
    this->Bump->SetHeightMap(heights);
    this->Modified();
  }
}

vtkImageData* vtkMesoBumpMapper::GetHeightMap()
{
  return this->Bump->GetHeightMap();
}

void vtkMesoBumpMapper::SetHorizonMap(vtkImageData* horizons, double scale)
{
  if (horizons && !(scale > 0.))
  {
    vtkErrorMacro("The scale of a horizon map must be above 0; got " << scale);
    return;
  }
  this->Bump->GetHorizon().SetHorizonMap(horizons, scale);
  this->Modified();
}

vtkImageData* vtkMesoBumpMapper::GetHorizonMap()
{
  return this->Bump->GetHorizon().GetHorizonMap();
}

MesoTechniqueShader* vtkMesoBumpMapper::GetTechnique()
{
  return this->Bump.get();
}

MesoTechnique vtkMesoBumpMapper::TechniqueOf(const MesoMesostructureOptions& options) const
{
  switch (options.Technique)
  {
    case MesoTechnique::Normal:
    case MesoTechnique::NormalObject:
    case MesoTechnique::Parallax:
    case MesoTechnique::Horizon:
      return options.Technique;
    default:
      return MesoTechnique::Bump;
  }
}

void vtkMesoBumpMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = this->TechniqueOf(options); // whose effects "auto" means
  this->Bump->SetOptions(options);
}

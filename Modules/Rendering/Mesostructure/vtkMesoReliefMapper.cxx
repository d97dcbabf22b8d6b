#include "vtkMesoReliefMapper.h"

#include "MesoReliefShader.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMesoReliefMapper);

vtkMesoReliefMapper::vtkMesoReliefMapper()
  : Relief(std::make_unique<MesoReliefShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Relief;
  this->SetOptions(options);
}

vtkMesoReliefMapper::~vtkMesoReliefMapper() = default;

void vtkMesoReliefMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->Relief->GetHeightMap() << "\n";
}

void vtkMesoReliefMapper::SetHeightMap(vtkImageData* heights)
{
  if (heights != this->Relief->GetHeightMap())
  {
    this->Relief->SetHeightMap(heights);
    this->Modified();
  }
}

vtkImageData* vtkMesoReliefMapper::GetHeightMap()
{
  return this->Relief->GetHeightMap();
}

void vtkMesoReliefMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkMesoReliefMapper::SafeDownCast(mapper))
  {
    this->SetHeightMap(other->GetHeightMap());
  }
  this->Superclass::ShallowCopy(mapper);
}

MesoTechniqueShader* vtkMesoReliefMapper::GetTechnique()
{
  return this->Relief.get();
}

MesoTechnique vtkMesoReliefMapper::TechniqueOf(const MesoMesostructureOptions& options) const
{
  return options.Technique == MesoTechnique::ReliefQuadric ? MesoTechnique::ReliefQuadric
                                                           : MesoTechnique::Relief;
}

void vtkMesoReliefMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = this->TechniqueOf(options); // whose effects "auto" means
  this->Relief->SetOptions(options);
}

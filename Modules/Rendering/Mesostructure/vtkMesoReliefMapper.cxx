#include "vtkMesoReliefMapper.h"

#include "MesoReliefShader.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>

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
  os << indent << "SearchSteps: " << this->SearchSteps[0] << " " << this->SearchSteps[1] << "\n";
  os << indent << "BaseImage: " << this->Relief->GetBaseImage() << "\n";
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
    this->SetSearchSteps(other->SearchSteps[0], other->SearchSteps[1]);
    this->SetBaseImage(other->GetBaseImage());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkMesoReliefMapper::SetSearchSteps(int linear, int halvings)
{
  const int steps[] = { std::max(linear, 0), std::max(halvings, 0) };
  if (steps[0] != this->SearchSteps[0] || steps[1] != this->SearchSteps[1])
  {
    std::copy(steps, steps + 2, this->SearchSteps);
    this->Relief->SetSteps(
      steps[0] > 0 ? std::optional<MesoSearchSteps>({ steps[0], steps[1] }) : std::nullopt);
    this->Modified();
  }
}

void vtkMesoReliefMapper::SetBaseImage(vtkImageData* image)
{
  if (image != this->Relief->GetBaseImage())
  {
    this->Relief->SetBaseImage(image);
    this->Modified();
  }
}

vtkImageData* vtkMesoReliefMapper::GetBaseImage()
{
  return this->Relief->GetBaseImage();
}

std::string vtkMesoReliefMapper::Prepare()
{
  return this->Relief->Prepare();
}

vtkMTimeType vtkMesoReliefMapper::GetDetailMTime()
{
  vtkImageData* heights = this->GetHeightMap();
  return std::max(this->Superclass::GetDetailMTime(), heights ? heights->GetMTime() : 0);
}

MesoTechniqueShader* vtkMesoReliefMapper::GetTechnique()
{
  return this->Relief.get();
}

MesoTechnique vtkMesoReliefMapper::TechniqueOf(const MesoMesostructureOptions& options) const
{
  return MesoBendsRelief(options.Technique) ? options.Technique : MesoTechnique::Relief;
}

void vtkMesoReliefMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = this->TechniqueOf(options); // whose effects "auto" means
  this->Relief->SetOptions(options);
}

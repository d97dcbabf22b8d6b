#include "vtkMesoVDMMapper.h"

#include "MesoVDMShader.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoVDMMapper);

vtkMesoVDMMapper::vtkMesoVDMMapper()
  : VDM(std::make_unique<MesoVDMShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::VDM;
  this->SetOptions(options);
}

vtkMesoVDMMapper::~vtkMesoVDMMapper() = default;

void vtkMesoVDMMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->VDM->GetHeightMap() << "\n";
  os << indent << "Table: " << this->VDM->GetTable() << "\n";
  os << indent << "FlatShadows: " << this->FlatShadows << "\n";
  os << indent << "NearestOutlines: " << this->NearestOutlines << "\n";
}

void vtkMesoVDMMapper::SetHeightMap(vtkImageData* heights)
{
  if (heights != this->VDM->GetHeightMap())
  {
    this->VDM->SetHeightMap(heights);
    this->Modified();
  }
}

vtkImageData* vtkMesoVDMMapper::GetHeightMap()
{
  return this->VDM->GetHeightMap();
}

void vtkMesoVDMMapper::SetTable(vtkImageData* table)
{
  if (table != this->VDM->GetTable())
  {
    const std::string problem = this->VDM->SetTable(table);
    if (!problem.empty())
    {
      vtkErrorMacro("This image is no table of view-dependent displacements: " << problem);
    }
    this->Modified();
  }
}

vtkImageData* vtkMesoVDMMapper::GetTable()
{
  return this->VDM->GetTable();
}

void vtkMesoVDMMapper::SetFlatShadows(bool flat)
{
  if (flat != this->FlatShadows)
  {
    this->FlatShadows = flat;
    this->VDM->SetFlatShadows(flat);
    this->Modified();
  }
}

void vtkMesoVDMMapper::SetNearestOutlines(bool nearest)
{
  if (nearest != this->NearestOutlines)
  {
    this->NearestOutlines = nearest;
    this->VDM->SetNearestOutlines(nearest);
    this->Modified();
  }
}

void vtkMesoVDMMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkMesoVDMMapper::SafeDownCast(mapper))
  {
    this->SetHeightMap(other->GetHeightMap());
    this->SetTable(other->GetTable());
    this->SetFlatShadows(other->FlatShadows);
    this->SetNearestOutlines(other->NearestOutlines);
  }
  this->Superclass::ShallowCopy(mapper);
}

vtkMTimeType vtkMesoVDMMapper::GetDetailMTime()
{
  vtkMTimeType time = this->Superclass::GetDetailMTime();
  for (vtkImageData* image : { this->GetHeightMap(), this->GetTable() })
  {
    time = std::max(time, image ? image->GetMTime() : 0);
  }
  return time;
}

std::array<int, 2> vtkMesoVDMMapper::GetRanks(const MesoMesostructureOptions& options)
{
  return MesoVDMShader::RanksOf(options);
}

MesoTechniqueShader* vtkMesoVDMMapper::GetTechnique()
{
  return this->VDM.get();
}

MesoTechnique vtkMesoVDMMapper::TechniqueOf(const MesoMesostructureOptions&) const
{
  return MesoTechnique::VDM;
}

void vtkMesoVDMMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = MesoTechnique::VDM; // whose effects "auto" means
  this->VDM->SetOptions(options);
}

#include "vtkMesoTessellatedMapper.h"

#include "MesoTechniqueShader.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMesoTessellatedMapper);

namespace
{
class TessellatedShader : public MesoTechniqueShader
{
public:
  MesoShaderShape GetShape() const override
  {
    MesoShaderShape shape;
    shape.Chunks = { "Techniques/Tessellated.glsl", "Common/HorizonLight.glsl" };
    shape.Attributes = { { "mesoRelief", "MesoRelief" } };
    shape.Displaced = true;
    return shape;
  }
};
}

vtkMesoTessellatedMapper::vtkMesoTessellatedMapper()
  : Tessellated(std::make_unique<TessellatedShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Tessellated;
  this->SetOptions(options);
}

vtkMesoTessellatedMapper::~vtkMesoTessellatedMapper() = default;

MesoTechniqueShader* vtkMesoTessellatedMapper::GetTechnique()
{
  return this->Tessellated.get();
}

MesoTechnique vtkMesoTessellatedMapper::TechniqueOf(const MesoMesostructureOptions&) const
{
  return MesoTechnique::Tessellated;
}

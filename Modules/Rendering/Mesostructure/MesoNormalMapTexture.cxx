#include "MesoNormalMapTexture.h"

#include "MesoMapUpload.h"
#include "MesoTechniqueShader.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
void AddOnce(std::vector<std::string>& names, const std::string& name)
{
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    names.push_back(name);
  }
}
}

MesoNormalMapTexture::MesoNormalMapTexture()
  : MesoMapTexture(1)
{
}

void MesoNormalMapTexture::SetNormalMap(vtkImageData* map, const MesoNormalMapMeaning& meaning)
{
  this->SetImage(map);
  this->Meaning = meaning;
}

void MesoNormalMapTexture::AddTo(MesoShaderShape& shape) const
{
  // The technique's own normals would be worked out in vain.
  const auto shading = std::find_if(shape.Defines.begin(), shape.Defines.end(),
    [](const auto& define) { return define.first == "MESO_SHADING"; });
  if (shading != shape.Defines.end())
  {
    shape.Defines.erase(shading);
  }
  shape.NormalMapped = true;
  shape.Defines.emplace_back("MESO_NORMAL_MAP", "");
  const char* const spaces[] = { "MESO_NORMAL_TANGENT", "MESO_NORMAL_OBJECT",
    "MESO_NORMAL_RELIEF" };
  shape.Defines.emplace_back(spaces[static_cast<int>(this->Meaning.Space)], "");
  if (this->Meaning.Space != MesoNormalSpace::Object)
  {
    shape.UseFrame();
    AddOnce(shape.Chunks, "Kernels/Frame.glsl");
    AddOnce(shape.Chunks, "Common/ReliefFrame.glsl");
  }
  shape.Chunks.emplace_back("Common/NormalMap.glsl");
}

std::string MesoNormalMapTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  vtkDataArray* normals = this->GetImage()->GetPointData()->GetScalars();
  const int type = normals ? normals->GetDataType() : VTK_VOID;
  if ((type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT) ||
    normals->GetNumberOfComponents() != 3)
  {
    return "the normal map must have three components of unsigned char, unsigned short or float";
  }
  this->Bytes = std::size_t(normals->GetNumberOfValues()) * normals->GetDataTypeSize() * 4 / 3;
  return MesoUploadMap(this->Texture(), window, this->GetImage(), wrap, true, "normal map");
}

void MesoNormalMapTexture::SetUniforms(vtkShaderProgram* program)
{
  if (!this->SetSampler(program, "mesoNormalMap"))
  {
    return;
  }
  // Stored [0,1] stands for [-1,1]; floats are the direction itself.
  const bool direct = this->GetImage()->GetScalarType() == VTK_FLOAT;
  const float factor = direct ? 1.f : 2.f;
  const float shift = direct ? 0.f : -1.f;
  const float up = this->Meaning.Down ? -1.f : 1.f;
  const float factors[3] = { factor, up * factor, factor };
  const float shifts[3] = { shift, up * shift, shift };
  program->SetUniform3f("mesoNormalFactor", factors);
  program->SetUniform3f("mesoNormalShift", shifts);
  if (program->IsUniformUsed("mesoNormalScale"))
  {
    program->SetUniformf("mesoNormalScale", static_cast<float>(this->Meaning.Depth));
  }
}

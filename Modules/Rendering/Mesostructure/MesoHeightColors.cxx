#include "MesoHeightColors.h"

#include "vtkLookupTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

MesoHeightColors::MesoHeightColors() = default;

MesoHeightColors::~MesoHeightColors() = default;

void MesoHeightColors::SetTable(vtkLookupTable* table)
{
  this->Table = table;
  this->UploadedTime = 0;
}

std::string MesoHeightColors::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Table)
  {
    return {};
  }
  this->Table->Build();
  if (this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
    this->UploadedTime != this->Table->GetMTime())
  {
    const vtkIdType size = this->Table->GetNumberOfTableValues();
    const int limit = vtkTextureObject::GetMaximumTextureSize(window);
    if (size < 1 || size > limit)
    {
      return "the table of colours has " + std::to_string(size) + " of 1 to " +
        std::to_string(limit) + " entries: heights are not coloured";
    }
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture->SetContext(window);
    if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(size), 1, 4, VTK_UNSIGNED_CHAR,
          this->Table->GetTable()->GetPointer(0)))
    {
      return "the table of colours could not be made a texture: heights are not coloured";
    }
    this->UploadedTime = this->Table->GetMTime();
  }
  this->Texture->Activate();
  return {};
}

void MesoHeightColors::SetUniforms(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("mesoHeightColors"))
  {
    program->SetUniformi("mesoHeightColors", this->Texture->GetTextureUnit());
    const double* range = this->Table->GetRange();
    float ends[2] = { static_cast<float>(range[0]), static_cast<float>(range[1]) };
    // Ends that a float does not tell apart would divide by 0.
    ends[1] = std::max(ends[1], std::nextafter(ends[0], std::numeric_limits<float>::max()));
    program->SetUniform2f("mesoHeightColorRange", ends);
  }
}

void MesoHeightColors::Deactivate()
{
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Deactivate();
  }
}

void MesoHeightColors::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

std::size_t MesoHeightColors::GetGPUBytes() const
{
  return this->Texture->GetHandle() == 0 ? 0 : std::size_t(this->Texture->GetWidth()) * 4;
}

#include "MesoBaseTexture.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <type_traits>

namespace
{
vtkDataArray* FourFloats(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  return array && array->GetDataType() == VTK_FLOAT && array->GetNumberOfComponents() == 4
    ? array
    : nullptr;
}

vtkDataArray* FieldOf(vtkImageData* image, const char* name, int components)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == 1
    ? array
    : nullptr;
}

bool Fill(
  vtkTextureObject* texture, vtkOpenGLRenderWindow* window, const int* size, vtkDataArray* values)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), 4, VTK_FLOAT, values->GetVoidPointer(0));
}
}

MesoBaseTexture::MesoBaseTexture() = default;

MesoBaseTexture::~MesoBaseTexture() = default;

void MesoBaseTexture::SetImage(vtkImageData* image)
{
  this->Image = image;
  this->UploadedTime = 0;
  this->Centre = { 0., 0., 0. };
  vtkDataArray* centre = image ? FieldOf(image, "MesoBaseCentre", 3) : nullptr;
  if (centre)
  {
    centre->GetTuple(0, this->Centre.data());
  }
}

vtkImageData* MesoBaseTexture::GetImage() const
{
  return this->Image;
}

std::string MesoBaseTexture::Upload(vtkOpenGLRenderWindow* window)
{
  vtkDataArray* positions = FourFloats(this->Image, "MesoBasePosition");
  vtkDataArray* normals = FourFloats(this->Image, "MesoBaseNormal");
  if (!positions || !normals || !FieldOf(this->Image, "MesoBaseCentre", 3) ||
    !FieldOf(this->Image, "MesoBaseScale", 2) || !FieldOf(this->Image, "MesoBaseOffset", 2) ||
    !FieldOf(this->Image, "MesoBaseWraps", 2))
  {
    return "the image of the base lacks arrays that vtkMesoBaseImage makes";
  }
  int size[3];
  this->Image->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[0] > limit || size[1] > limit)
  {
    return "the image of the base, " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      ", is larger than the " + std::to_string(limit) + " that this device takes";
  }
  if (!Fill(this->Positions, window, size, positions) ||
    !Fill(this->Normals, window, size, normals))
  {
    return "the image of the base could not be made a texture";
  }
  FieldOf(this->Image, "MesoBaseCentre", 3)->GetTuple(0, this->Centre.data());
  this->UploadedTime = this->Image->GetMTime();
  return {};
}

std::string MesoBaseTexture::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Image)
  {
    return "there is no image of the base, which vtkMesoBaseImage makes";
  }
  if (this->Positions->GetHandle() == 0 || this->Positions->GetContext() != window ||
    this->UploadedTime != this->Image->GetMTime())
  {
    const std::string failure = this->Upload(window);
    if (!failure.empty())
    {
      return failure;
    }
  }
  this->Positions->Activate();
  this->Normals->Activate();
  return {};
}

void MesoBaseTexture::SetUniforms(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("mesoBasePosition"))
  {
    return;
  }
  program->SetUniformi("mesoBasePosition", this->Positions->GetTextureUnit());
  program->SetUniformi("mesoBaseNormal", this->Normals->GetTextureUnit());
  const auto two = [this](const char* name, auto* values)
  {
    double tuple[2];
    FieldOf(this->Image, name, 2)->GetTuple(0, tuple);
    values[0] = static_cast<std::remove_pointer_t<decltype(values)>>(tuple[0]);
    values[1] = static_cast<std::remove_pointer_t<decltype(values)>>(tuple[1]);
  };
  float scale[2];
  float offset[2];
  int wraps[2];
  two("MesoBaseScale", scale);
  two("MesoBaseOffset", offset);
  two("MesoBaseWraps", wraps);
  program->SetUniform2f("mesoBaseScale", scale);
  program->SetUniform2f("mesoBaseOffset", offset);
  program->SetUniform2i("mesoBaseWraps", wraps);
}

void MesoBaseTexture::Deactivate()
{
  for (vtkTextureObject* texture : { this->Positions.Get(), this->Normals.Get() })
  {
    if (texture->GetHandle() != 0)
    {
      texture->Deactivate();
    }
  }
}

void MesoBaseTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Positions->ReleaseGraphicsResources(window);
  this->Normals->ReleaseGraphicsResources(window);
}

std::size_t MesoBaseTexture::GetGPUBytes() const
{
  if (this->Positions->GetHandle() == 0)
  {
    return 0;
  }
  return std::size_t(2) * this->Positions->GetWidth() * this->Positions->GetHeight() * 4 *
    sizeof(float);
}

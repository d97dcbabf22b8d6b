#include "MesoBaseTexture.h"

#include "MesoMapUpload.h"
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
}

MesoBaseTexture::MesoBaseTexture()
  : MesoMapTexture(2)
{
}

void MesoBaseTexture::SetBaseImage(vtkImageData* image)
{
  this->SetImage(image);
  this->Centre = { 0., 0., 0. };
  vtkDataArray* centre = image ? FieldOf(image, "MesoBaseCentre", 3) : nullptr;
  if (centre)
  {
    centre->GetTuple(0, this->Centre.data());
  }
}

std::string MesoBaseTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  vtkDataArray* positions = FourFloats(this->GetImage(), "MesoBasePosition");
  vtkDataArray* normals = FourFloats(this->GetImage(), "MesoBaseNormal");
  if (!positions || !normals || !FieldOf(this->GetImage(), "MesoBaseCentre", 3) ||
    !FieldOf(this->GetImage(), "MesoBaseScale", 2) ||
    !FieldOf(this->GetImage(), "MesoBaseOffset", 2) ||
    !FieldOf(this->GetImage(), "MesoBaseWraps", 2))
  {
    return "the image of the base lacks arrays that vtkMesoBaseImage makes";
  }
  int size[3];
  this->GetImage()->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[0] > limit || size[1] > limit)
  {
    return "the image of the base, " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      ", is larger than the " + std::to_string(limit) + " that this device takes";
  }
  const auto upload = [&](std::size_t index, vtkDataArray* numbers)
  {
    return MesoUploadTexels(this->Texture(index), window, std::size_t(size[0]),
      std::size_t(size[1]), 4, VTK_FLOAT, numbers->GetVoidPointer(0));
  };
  if (!upload(0, positions) || !upload(1, normals))
  {
    return "the image of the base could not be made a texture";
  }
  FieldOf(this->GetImage(), "MesoBaseCentre", 3)->GetTuple(0, this->Centre.data());
  this->Bytes = std::size_t(2) * 4 * sizeof(float) * size[0] * size[1];
  return {};
}

void MesoBaseTexture::SetUniforms(vtkShaderProgram* program)
{
  if (!this->SetSampler(program, "mesoBasePosition", 0))
  {
    return;
  }
  this->SetSampler(program, "mesoBaseNormal", 1);
  const auto two = [this](const char* name, auto* values)
  {
    double tuple[2];
    FieldOf(this->GetImage(), name, 2)->GetTuple(0, tuple);
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

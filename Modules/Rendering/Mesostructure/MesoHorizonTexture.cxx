#include "MesoHorizonTexture.h"

#include "MesoMapUpload.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

MesoHorizonTexture::MesoHorizonTexture() = default;

MesoHorizonTexture::~MesoHorizonTexture() = default;

void MesoHorizonTexture::SetHorizonMap(vtkImageData* map, double scale)
{
  this->HorizonMap = map;
  this->Scale = scale;
  this->UploadedTime = 0;
}

vtkImageData* MesoHorizonTexture::GetHorizonMap() const
{
  return this->HorizonMap;
}

std::string MesoHorizonTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  auto* angles = vtkFloatArray::SafeDownCast(this->HorizonMap->GetPointData()->GetScalars());
  if (!angles)
  {
    return "the horizon map must have a component of float for each azimuth";
  }
  int size[3];
  this->HorizonMap->GetDimensions(size);
  const int azimuths = angles->GetNumberOfComponents();
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (std::max({ size[0], size[1], azimuths }) > limit)
  {
    return "the horizon map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " texels and " + std::to_string(azimuths) + " azimuths is larger than the " +
      std::to_string(limit) + " that this device takes";
  }
  const std::size_t texels = std::size_t(size[0]) * size[1];
  std::vector<float> slices(texels * azimuths);
  for (std::size_t i = 0; i < texels; ++i)
  {
    for (int k = 0; k < azimuths; ++k)
    {
      slices[k * texels + i] = angles->GetValue(static_cast<vtkIdType>(i) * azimuths + k);
    }
  }
  vtkTextureObject* texture = this->Texture;
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(MesoTextureWrap(wrap));
  texture->SetWrapT(MesoTextureWrap(wrap));
  texture->SetWrapR(vtkTextureObject::Repeat);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (!texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), static_cast<unsigned int>(azimuths), 1, VTK_FLOAT,
        slices.data()))
  {
    return "the horizon map could not be made a texture";
  }
  this->UploadedTime = this->HorizonMap->GetMTime();
  this->UploadedWrap = wrap;
  return {};
}

std::string MesoHorizonTexture::Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  if (!this->HorizonMap)
  {
    return {};
  }
  if (this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
    this->UploadedTime != this->HorizonMap->GetMTime() || this->UploadedWrap != wrap)
  {
    const std::string failure = this->Upload(window, wrap);
    if (!failure.empty())
    {
      return failure;
    }
  }
  this->Texture->Activate();
  return {};
}

void MesoHorizonTexture::SetUniforms(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("mesoHorizonMap"))
  {
    program->SetUniformi("mesoHorizonMap", this->Texture->GetTextureUnit());
    program->SetUniformf("mesoHorizonScale", static_cast<float>(this->Scale));
  }
}

void MesoHorizonTexture::Deactivate()
{
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Deactivate();
  }
}

void MesoHorizonTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

std::size_t MesoHorizonTexture::GetGPUBytes() const
{
  if (this->Texture->GetHandle() == 0)
  {
    return 0;
  }
  return std::size_t(this->Texture->GetWidth()) * this->Texture->GetHeight() *
    this->Texture->GetDepth() * sizeof(float);
}

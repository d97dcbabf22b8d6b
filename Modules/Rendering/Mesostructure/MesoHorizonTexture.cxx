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

MesoHorizonTexture::MesoHorizonTexture()
  : MesoMapTexture(1)
{
}

void MesoHorizonTexture::SetHorizonMap(vtkImageData* map, double scale)
{
  this->SetImage(map);
  this->Scale = scale;
}

std::string MesoHorizonTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap)
{
  auto* angles = vtkFloatArray::SafeDownCast(this->GetImage()->GetPointData()->GetScalars());
  if (!angles)
  {
    return "the horizon map must have a component of float for each azimuth";
  }
  int size[3];
  this->GetImage()->GetDimensions(size);
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
  vtkTextureObject* texture = this->Texture();
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
  this->Bytes = slices.size() * sizeof(float);
  return {};
}

void MesoHorizonTexture::SetUniforms(vtkShaderProgram* program)
{
  if (this->SetSampler(program, "mesoHorizonMap"))
  {
    program->SetUniformf("mesoHorizonScale", static_cast<float>(this->Scale));
  }
}

#include "MesoVolumeMap.h"

#include "MesoVolume.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

std::string MesoVolumeMap::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  const std::string problem = MesoVolumeProblem(this->GetImage());
  if (!problem.empty())
  {
    return problem;
  }
  return this->UploadArray(
    window, this->GetImage()->GetPointData()->GetArray("MesoSignedDistance"));
}

std::string MesoVolumeTexture::UploadArray(vtkOpenGLRenderWindow* window, vtkDataArray* values)
{
  int size[3];
  this->GetImage()->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] > limit)
    {
      return "the volume has " + std::to_string(size[axis]) +
        " voxels in a row, and this device takes " + std::to_string(limit);
    }
  }
  vtkTextureObject* texture = this->Texture();
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (!texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]),
        values->GetNumberOfComponents(), VTK_FLOAT, values->GetVoidPointer(0)))
  {
    return "the volume could not be made a texture";
  }
  this->Bytes = std::size_t(values->GetNumberOfValues()) * sizeof(float);
  return {};
}

void MesoVolumeMap::SetUniforms(vtkShaderProgram* program)
{
  if (this->SetSampler(program, "mesoVolume") && program->IsUniformUsed("mesoVolumeDepth"))
  {
    program->SetUniformf("mesoVolumeDepth", static_cast<float>(MesoVolumeDepth(this->GetImage())));
  }
}

void MesoVolumeColorMap::SetVolume(vtkImageData* volume)
{
  this->SetImage(volume && MesoVolumeColors(volume) ? volume : nullptr);
}

std::string MesoVolumeColorMap::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  vtkFloatArray* colors = MesoVolumeColors(this->GetImage());
  return colors ? this->UploadArray(window, colors) : "the volume's colors are gone";
}

void MesoVolumeColorMap::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoVolumeColors");
}

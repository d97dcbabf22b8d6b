#include "vtk_glew.h" // must come first

#include "MesoMapUpload.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

namespace
{
constexpr int AllLevels = 1000; // VTK's default is the first alone
}

int MesoTextureWrap(MesoWrap wrap)
{
  return wrap == MesoWrap::Clamp ? vtkTextureObject::ClampToEdge
    : wrap == MesoWrap::Mirror   ? vtkTextureObject::MirroredRepeat
                                 : vtkTextureObject::Repeat;
}

std::string MesoUploadMap(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  vtkImageData* map, MesoWrap wrap, bool mipmaps, const std::string& name)
{
  int size[3];
  map->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[0] > limit || size[1] > limit)
  {
    return "the " + name + " of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit) + " that this device takes";
  }
  vtkDataArray* values = map->GetPointData()->GetScalars();
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(MesoTextureWrap(wrap));
  texture->SetWrapT(MesoTextureWrap(wrap));
  texture->SetMaxLevel(mipmaps ? AllLevels : 0);
  texture->SetMinificationFilter(
    mipmaps ? vtkTextureObject::LinearMipmapLinear : vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), values->GetNumberOfComponents(), values->GetDataType(),
        values->GetVoidPointer(0)))
  {
    return "the " + name + " could not be made a texture";
  }
  if (mipmaps)
  {
    texture->Activate();
    glGenerateMipmap(GL_TEXTURE_2D);
    texture->Deactivate();
  }
  return {};
}

bool MesoUploadTexels(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, std::size_t width,
  std::size_t height, int channels, int type, void* numbers)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture->Create2DFromRaw(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), channels, type, numbers);
}

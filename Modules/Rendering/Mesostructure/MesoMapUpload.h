#ifndef MesoMapUpload_h
#define MesoMapUpload_h

#include "MesoOptions.h" // for MesoWrap

#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

/// A wrap mode as vtkTextureObject names it.
int MesoTextureWrap(MesoWrap wrap);

/**
 * Make a texture of an image's scalars as they are, linear between texels.
 *
 * @param name of the map, for messages
 * @param mipmaps whether the levels of its pyramid are made as well
 * @return why that failed; empty where it did not
 */
std::string MesoUploadMap(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  vtkImageData* map, MesoWrap wrap, bool mipmaps, const std::string& name);

#endif

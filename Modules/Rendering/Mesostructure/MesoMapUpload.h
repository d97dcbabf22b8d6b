#ifndef MesoMapUpload_h
#define MesoMapUpload_h

#include "MesoOptions.h" // for MesoWrap

#include <cstddef>
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

/**
 * Make a texture that is read texel by texel, row by row from the bottom.
 *
 * @param type of the numbers, as VTK names it
 * @param numbers width x height x channels
 * @return whether the device took it
 */
bool MesoUploadTexels(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, std::size_t width,
  std::size_t height, int channels, int type, void* numbers);

#endif

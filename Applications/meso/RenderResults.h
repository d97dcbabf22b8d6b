#ifndef RenderResults_h
#define RenderResults_h

#include "MesoExr.h"

#include <functional>
#include <string>
#include <vector>

class MesoSceneBuilder;
class vtkImageData;
class vtkMesoEGLRenderWindow;
class vtkMesoAOVPass;
class vtkRenderer;

/**
 * @file RenderResults.h
 * @brief What a rendered scene leaves behind: the picture, its AOVs and its figures of cost.
 *
 * Failures throw MesoInputError.
 */

/// Render `samples` times, each with the pixels' centres moved a little. Returns the mean as the
/// bytes of a PNG file. `progress` is called with the part that is done.
std::string RenderPicture(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer, int samples,
  const std::function<void(double)>& progress);

/// Render once with one sample a pixel and keep every pixel's numbers in `pass`.
void CaptureAOVs(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer,
  const MesoSceneBuilder& builder, vtkMesoAOVPass* pass);

/// Write an EXR file, beside its place first.
void WriteAOVs(const vtkMesoAOVPass* pass, const std::vector<std::string>& channels,
  const MesoExrAttributes& attributes, const std::string& fileName);

/// Measure the figures of cost. Returns one JSON object.
std::string MeasureStats(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer,
  const MesoSceneBuilder& builder, const vtkMesoAOVPass* pass, double prepareSeconds);

#endif

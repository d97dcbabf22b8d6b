#ifndef RenderResults_h
#define RenderResults_h

#include "MesoExr.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

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

/// Render `samples` times, each with the pixels' centres moved a little. Returns the mean, RGB of 8
/// bit, row 0 at the bottom. `progress` is called with the part that is done.
vtkSmartPointer<vtkImageData> RenderPicture(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer,
  int samples, const std::function<void(double)>& progress);

/// Render once with one sample a pixel and keep every pixel's numbers in `pass`.
void CaptureAOVs(vtkRenderer* renderer, const MesoSceneBuilder& builder, vtkMesoAOVPass* pass);

/// How often a channel of `pass` counts, a covered pixel.
struct PixelCounts
{
  double Covered = 0.; ///< pixels
  double Mean = 0.;    ///< over the covered pixels; 0 where there are none
  double Maximum = 0.;
};
PixelCounts CountsOfChannel(const vtkMesoAOVPass* pass, const std::string& channel);

/// What is rasterised and what the GPU holds of the builder's objects since the last frame.
struct SceneSize
{
  std::size_t GpuBytes = 0;
  vtkIdType Triangles = 0;
};
SceneSize SizeOfScene(const MesoSceneBuilder& builder);

/// Write an EXR file, beside its place first.
void WriteAOVs(const vtkMesoAOVPass* pass, const std::vector<std::string>& channels,
  const MesoExrAttributes& attributes, const std::string& fileName);

/// Measure the figures of cost. Returns one JSON object.
std::string MeasureStats(vtkMesoEGLRenderWindow* window, const MesoSceneBuilder& builder,
  const vtkMesoAOVPass* pass, double prepareSeconds);

#endif

#ifndef MesoFrameCost_h
#define MesoFrameCost_h

#include "mesoRenderingMesostructureModule.h" // for export macro

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProp;

/// Median, least and greatest of some runs, in milliseconds.
struct MesoMilliseconds
{
  double Median = 0.;
  double Minimum = 0.;
  double Maximum = 0.;
};

/// What a frame costs; see MesoMeasureFrame().
struct MesoFrameCost
{
  MesoMilliseconds Gpu;   ///< frame with the props minus frame without, by Clock
  MesoMilliseconds Frame; ///< wall clock around render and finish, with the props
  std::string Clock;      ///< which clock Gpu was read from
  int Runs = 0;
};

///@{
/**
 * Measure what drawing some props costs: after `warmUp` rounds, `runs` rounds of one frame with and
 * one without them, interleaved, so that a slow moment of a shared machine falls on both.
 *
 * On hardware the clock is GL_TIME_ELAPSED. Mesa's software rasterisers report a small part of the
 * true time by it (5 ms for 82 ms), so there it is the wall clock, each frame closed by glFinish.
 *
 * The props must be visible; they are visible again afterwards.
 */
MESORENDERINGMESOSTRUCTURE_EXPORT MesoFrameCost MesoMeasureFrame(vtkOpenGLRenderWindow* window,
  const std::vector<vtkProp*>& props, int warmUp = 5, int runs = 20);
///@}

/// Median, least and greatest.
MESORENDERINGMESOSTRUCTURE_EXPORT MesoMilliseconds MesoSummarise(std::vector<double> milliseconds);

#endif

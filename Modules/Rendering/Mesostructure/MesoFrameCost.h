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

/// What a frame costs; see MesoMeasureFrames().
struct MesoFrameCost
{
  MesoMilliseconds Gpu;          ///< frame with the group minus frame without, by Clock
  std::vector<double> GpuRounds; ///< what Gpu is the median of, in the order of the rounds
  MesoMilliseconds Frame;        ///< wall clock around render and finish, with the group
  std::string Clock;             ///< which clock Gpu was read from
  int Runs = 0;
};

/**
 * Measure what drawing each of some groups of props costs: after `warmUp` rounds, `runs` rounds of
 * one frame without any of them and one with each group alone, interleaved, so that a slow moment
 * of a shared machine falls on all.
 *
 * On hardware the clock is GL_TIME_ELAPSED. Mesa's software rasterisers report a small part of the
 * true time by it (5 ms for 82 ms), so there it is the wall clock, each frame closed by glFinish.
 *
 * Afterwards all props are visible.
 */
MESORENDERINGMESOSTRUCTURE_EXPORT std::vector<MesoFrameCost> MesoMeasureFrames(
  vtkOpenGLRenderWindow* window, const std::vector<std::vector<vtkProp*>>& groups, int warmUp = 5,
  int runs = 20);

/// Median, least and greatest.
MESORENDERINGMESOSTRUCTURE_EXPORT MesoMilliseconds MesoSummarise(std::vector<double> milliseconds);

#endif

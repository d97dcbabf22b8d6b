#ifndef BenchScaling_h
#define BenchScaling_h

#include "BenchResults.h"
#include "BenchSettings.h"

class BenchProgress;

/**
 * How the time to draw grows: a torus of bricks in each technique that is asked for (those that search,
 * and the floor `plain`), with more pixels, more triangles, a larger map and more lights, one of them at
 * a time. All techniques of a setting are timed in turns, in one window.
 *
 * Returns a list of { "what": "pixels", "triangles", "texels" or "lights", "technique", "points":
 * [[value, milliseconds], ...], "ns_per_unit" } with the slope of the straight line through the points;
 * for pixels the value is the number that the torus covers.
 */
BenchResults::Json MeasureScaling(const BenchSettings& settings, BenchProgress& progress);

/// What MeasureScaling() will tell the progress.
double StepsOfScaling(const BenchSettings& settings);

/// Of all that MeasureScaling() depends on, to tell whether kept figures are those asked for.
std::string KeyOfScaling(const BenchSettings& settings, const std::string& device);

#endif

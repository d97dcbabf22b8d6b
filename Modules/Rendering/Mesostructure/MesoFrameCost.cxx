#include "vtk_glew.h" // must come first

#include "MesoFrameCost.h"

#include "MesoEGLContext.h" // for MesoIsSoftwareRenderer
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"

#include <algorithm>
#include <chrono>

namespace
{
/// Wall clock and, on hardware, GPU time of one frame.
struct FrameTime
{
  double Wall;
  double Gpu;
};

FrameTime TimeFrame(vtkOpenGLRenderWindow* window, GLuint query)
{
  window->MakeCurrent();
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  if (query)
  {
    glBeginQuery(GL_TIME_ELAPSED, query);
  }
  window->Render();
  if (query)
  {
    glEndQuery(GL_TIME_ELAPSED);
  }
  glFinish();
  const auto end = std::chrono::steady_clock::now();
  FrameTime time;
  time.Wall = std::chrono::duration<double, std::milli>(end - start).count();
  time.Gpu = time.Wall;
  if (query)
  {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    time.Gpu = static_cast<double>(nanoseconds) * 1.e-6;
  }
  return time;
}
}

MesoMilliseconds MesoSummarise(std::vector<double> milliseconds)
{
  MesoMilliseconds summary;
  if (milliseconds.empty())
  {
    return summary;
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t middle = milliseconds.size() / 2;
  summary.Median = milliseconds.size() % 2 == 1
    ? milliseconds[middle]
    : 0.5 * (milliseconds[middle - 1] + milliseconds[middle]);
  summary.Minimum = milliseconds.front();
  summary.Maximum = milliseconds.back();
  return summary;
}

std::vector<MesoFrameCost> MesoMeasureFrames(vtkOpenGLRenderWindow* window,
  const std::vector<std::vector<vtkProp*>>& groups, int warmUp, int runs)
{
  window->Render(); // makes the context where there is none yet
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool software = MesoIsSoftwareRenderer(name ? name : "");
  GLuint query = 0;
  if (!software)
  {
    glGenQueries(1, &query);
  }
  const auto show = [&](std::size_t group, bool visible)
  {
    for (vtkProp* prop : groups[group])
    {
      prop->SetVisibility(visible);
    }
  };
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    show(group, false);
  }
  std::vector<std::vector<double>> gpu(groups.size());
  std::vector<std::vector<double>> frame(groups.size());
  for (int round = -warmUp; round < runs; ++round)
  {
    const FrameTime without = TimeFrame(window, query);
    for (std::size_t group = 0; group < groups.size(); ++group)
    {
      show(group, true);
      const FrameTime with = TimeFrame(window, query);
      show(group, false);
      if (round >= 0)
      {
        gpu[group].push_back(with.Gpu - without.Gpu);
        frame[group].push_back(with.Wall);
      }
    }
  }
  if (query)
  {
    glDeleteQueries(1, &query);
  }
  std::vector<MesoFrameCost> costs(groups.size());
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    show(group, true);
    MesoFrameCost& cost = costs[group];
    cost.Gpu = MesoSummarise(gpu[group]);
    cost.GpuRounds = gpu[group];
    cost.Frame = MesoSummarise(frame[group]);
    cost.Clock = software ? "wall clock, frame with minus frame without, each closed by glFinish"
                          : "GL_TIME_ELAPSED, frame with minus frame without";
    cost.Runs = runs;
  }
  return costs;
}

// The exact reference beside plain Embree on the diced surface: rays a second on one thread, bytes, time
// to build, and how far the diced hits are from the exact ones. The same rays, interleaved.

#include "ReferenceWorld.h"

#include <chrono>
#include <cstdio>

namespace
{
constexpr int Rays = 100000;

double SecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Arm
{
  std::string Name;
  std::unique_ptr<ReferenceWorld> World;
  double BuildSeconds = 0.;
  double Seconds = 0.;
  std::vector<double> Hits;
};

void Measure(const char* title, const std::string& nodes, double depth, const glm::dvec3& eye,
  double reach, const std::vector<double>& facetsPerTexel)
{
  std::vector<Arm> arms;
  const auto add = [&](const std::string& name, double facets)
  {
    Arm arm;
    arm.Name = name;
    const auto start = std::chrono::steady_clock::now();
    arm.World = std::make_unique<ReferenceWorld>(nodes, false, facets);
    arm.BuildSeconds = SecondsSince(start);
    arms.push_back(std::move(arm));
  };
  add("exact", 0.);
  for (double facets : facetsPerTexel)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "diced %g a texel", facets);
    add(name, facets);
  }
  // From one eye, row by row, as a picture's rays come.
  const int side = static_cast<int>(std::sqrt(double(Rays)));
  constexpr int Runs = 5;
  for (int run = 0; run < Runs; ++run)
  {
    for (Arm& arm : arms)
    {
      arm.Hits.clear();
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < side * side; ++i)
      {
        const int column = i % side;
        const int row = i / side;
        const glm::dvec3 target(
          reach * (2. * column / side - 1.), reach * (2. * row / side - 1.), 0.);
        arm.Hits.push_back(arm.World->T(eye, target - eye));
      }
      const double seconds = SecondsSince(start);
      arm.Seconds = run == 0 ? seconds : std::min(arm.Seconds, seconds);
    }
  }
  std::printf("%s\n%-18s %10s %10s %9s %9s %11s %11s %7s\n", title, "", "facets", "rays/s", "MB",
    "build s", "p95 / D", "max / D", "alone");
  for (const Arm& arm : arms)
  {
    std::vector<double> distances;
    int alone = 0;
    for (std::size_t i = 0; i < arm.Hits.size(); ++i)
    {
      const double exact = arms[0].Hits[i];
      if (std::isnan(exact) != std::isnan(arm.Hits[i]))
      {
        ++alone;
      }
      else if (!std::isnan(exact))
      {
        distances.push_back(std::abs(exact - arm.Hits[i]) * glm::length(eye) / depth);
      }
    }
    std::size_t bytes = arm.World->Tracer->MemoryBytes();
    for (const auto& surface : arm.World->Surfaces)
    {
      bytes += surface->MemoryBytes();
    }
    std::printf("%-18s %10zu %10.0f %9.1f %9.2f %11.2e %11.2e %7d\n", arm.Name.c_str(),
      arm.World->Tracer->NumberOfFacets(), side * side / arm.Seconds, 1e-6 * double(bytes),
      arm.BuildSeconds, Percentile(distances, 0.95), Percentile(distances, 1.), alone);
  }
  const MesoSolverWork& work = arms[0].World->Work.Solver;
  const double traced = double(Runs) * side * side;
  std::printf("exact: %.1f blocks, %.2f pieces a ray, largest residual %.1e, unresolved %llu\n\n",
    double(work.Blocks) / traced, double(work.Pieces) / traced, work.LargestResidual,
    static_cast<unsigned long long>(work.Unresolved));
}
}

int main()
{
  Measure("torus of 2304 triangles, bricks of 128 x 128 texels, 4 x 2 tiles, D = 0.06",
    R"([{"transform": {"rotate": [50, 1, 0.2, 0]}, "mesh": {"shape": "torus"},
      "mesostructure": {"technique": "relief", "scale": 0.06, "tiles": [4, 2],
                        "height_map": {"pattern": "brick", "size": [128, 128]}}}])",
    0.06, { 0., 0., 5. }, 1.3, { 1., 2., 4. });
  Measure("plane of 2 triangles, noise of 1024 x 1024 texels, D = 0.05, 60 degrees off the normal",
    R"([{"transform": {"rotate": [60, 1, 0, 0]}, "mesh": {"shape": "plane", "size": [2, 2]},
      "mesostructure": {"technique": "relief", "scale": 0.05,
                        "height_map": {"pattern": "noise", "size": [1024, 1024]}}}])",
    0.05, { 0., 0., 5. }, 0.6, { 1., 2. });
  return 0;
}

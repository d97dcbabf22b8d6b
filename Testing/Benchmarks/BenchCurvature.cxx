// How exact vtkMesoPrincipalCurvatures is and what it costs, beside vtkCurvatures in the same run.

#include "CurvedMeshes.h"

#include "vtkMesoPrincipalCurvatures.h"

#include "vtkCurvatures.h"
#include "vtkSMPTools.h"

#include <chrono>
#include <cstdio>

namespace
{
struct Score
{
  double Root = 0.;    ///< root mean square of the error of c_max over the largest curvature
  double Largest = 0.; ///< largest such error
  double Inside = 0.;  ///< root mean square without border points
  double Degrees =
    0.; ///< root mean square of the angle between directions, where they are distinct
  double Microseconds = 0.;
};

template <typename Filter>
double Time(Filter* filter, vtkPolyData* mesh)
{
  filter->SetInputData(mesh);
  double best = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    filter->Modified();
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return 1e6 * best / static_cast<double>(mesh->GetNumberOfPoints());
}

Score ScoreOf(const CurvedMesh& mesh, vtkDataArray* maximum, vtkDataArray* directions)
{
  Score score;
  const double largest = mesh.Largest() > 0. ? mesh.Largest() : 1.;
  double inside = 0.;
  double turned = 0.;
  for (std::size_t i = 0; i < mesh.Curvatures.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    const double error =
      std::abs(maximum->GetComponent(point, 0) - mesh.Curvatures[i][0]) / largest;
    score.Root += error * error;
    score.Largest = std::max(score.Largest, error);
    if (!mesh.Border[i])
    {
      score.Inside += error * error;
      inside += 1.;
    }
    if (directions && mesh.Curvatures[i][0] - mesh.Curvatures[i][1] > 0.1 * largest)
    {
      std::array<double, 6> d;
      directions->GetTuple(point, d.data());
      const double angle =
        std::asin(std::min(1., MesoLength(MesoCross({ d[0], d[1], d[2] }, mesh.Directions[i]))));
      score.Degrees += angle * angle;
      turned += 1.;
    }
  }
  score.Root = std::sqrt(score.Root / static_cast<double>(mesh.Curvatures.size()));
  score.Inside = std::sqrt(score.Inside / std::max(1., inside));
  score.Degrees = std::sqrt(score.Degrees / std::max(1., turned)) * 180. / std::acos(-1.);
  return score;
}

Score Ours(const CurvedMesh& mesh)
{
  vtkNew<vtkMesoPrincipalCurvatures> filter;
  const double time = Time(filter.Get(), mesh.Mesh);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  Score score =
    ScoreOf(mesh, data->GetArray("MesoCurvature"), data->GetArray("MesoPrincipalDirections"));
  score.Microseconds = time;
  return score;
}

Score Vtk(const CurvedMesh& mesh)
{
  vtkNew<vtkCurvatures> filter;
  filter->SetCurvatureTypeToMaximum();
  const double time = Time(filter.Get(), mesh.Mesh);
  Score score =
    ScoreOf(mesh, filter->GetOutput()->GetPointData()->GetScalars("Maximum_Curvature"), nullptr);
  score.Microseconds = time;
  return score;
}

using Method = Score (*)(const CurvedMesh&);

void Row(const char* method, Method measure, const char* surface, double jitter)
{
  std::array<Score, 3> scores;
  const std::array<int, 3> points = { 2000, 8000, 32000 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    scores[i] = measure(SampleNamed(surface, points[i], jitter));
  }
  const double order =
    scores[2].Root > 1e-11 ? 0.5 * std::log2(scores[0].Root / scores[2].Root) : 0.;
  std::printf("| %s | %s, %s | %.1e | %.1e | %.1e | %.1e | %.1f | %.2f | %.1f |\n", method, surface,
    jitter > 0. ? "jittered" : "regular", scores[0].Root, scores[1].Root, scores[1].Largest,
    scores[1].Inside, order, scores[1].Degrees, scores[1].Microseconds);
}
}

int main()
{
  vtkSMPTools::Initialize(1);
  vtkObject::GlobalWarningDisplayOff(); // vtkCurvatures warns at each point that it doubts
  std::printf(
    "| method | mesh | rms, 2k | rms, 8k | max, 8k | rms inside, 8k | order | directions, "
    "degrees | us a vertex |\n| - | - | - | - | - | - | - | - | - |\n");
  for (const char* surface : { "plane", "sphere", "cylinder", "torus", "saddle", "monkey saddle" })
  {
    for (const double jitter : { 0., 0.24 })
    {
      Row("Meso", Ours, surface, jitter);
      Row("vtkCurvatures", Vtk, surface, jitter);
    }
  }
  return 0;
}

// How exact vtkMesoPrincipalCurvatures and vtkMesoQuadricFit are and what they cost, beside
// vtkCurvatures and, where this was built with CGAL, its jets in the same run.

#include "CurvedMeshes.h"
#include "JetOracle.h"

#include "MesoSiteFits.h"
#include "vtkMesoPrincipalCurvatures.h"
#include "vtkMesoQuadricFit.h"

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

#ifdef MESO_WITH_CGAL
/// Degree 4 over three rings, or 2 over two; the rings are ours.
template <int Degree, int Rings>
Score Cgal(const CurvedMesh& mesh)
{
  MesoTriangleMesh triangles;
  for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
  {
    triangles.Positions.push_back(PositionOf(mesh.Mesh, i));
    triangles.Vertex.push_back(i);
  }
  for (const auto& t : TrianglesOf(mesh.Mesh))
  {
    triangles.Triangles.push_back({ t[0], t[1], t[2] });
  }
  vtkNew<vtkDoubleArray> maximum;
  vtkNew<vtkDoubleArray> directions;
  directions->SetNumberOfComponents(6);
  const auto start = std::chrono::steady_clock::now();
  const MesoSmoothPatches patches(triangles, 180.);
  MesoFitSpace space;
  for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
  {
    const std::int64_t site = patches.SiteOf(i);
    int rings = Rings;
    do // more rings where there are too few for the polynomial, at borders
    {
      MesoGatherNeighbours(patches, site, rings, 0, rings, space);
      ++rings;
    } while (space.Offsets.size() + 1 < (Degree + 1) * (Degree + 2) / 2);
    const JetOracleResult result = JetOracle(space.Offsets, patches.NormalOf(site), Degree);
    maximum->InsertNextValue(result.Maximum);
    directions->InsertNextTuple6(
      result.Direction[0], result.Direction[1], result.Direction[2], 0., 0., 0.);
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  Score score = ScoreOf(mesh, maximum, directions);
  score.Microseconds = 1e6 * time.count() / static_cast<double>(mesh.Mesh->GetNumberOfPoints());
  return score;
}
#endif

/// Error of a, b, c together: root mean square of the quadric's difference from half the second
/// fundamental form, over half the largest curvature.
void QuadricRow(const char* method, const std::function<void(vtkMesoQuadricFit*)>& set,
  double jitter, bool exactNormals)
{
  std::array<double, 3> errors;
  std::array<double, 3> conditions;
  double time = 0.;
  for (int i = 0; i < 3; ++i)
  {
    const CurvedMesh mesh = SampleNamed("torus", 2000 << (2 * i), jitter);
    vtkNew<vtkDoubleArray> tangent;
    tangent->SetName("MesoTangent");
    tangent->SetNumberOfComponents(3);
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (vtkIdType p = 0; p < mesh.Mesh->GetNumberOfPoints(); ++p)
    {
      const MesoVector q = PositionOf(mesh.Mesh, p);
      const double w = std::hypot(q[0], q[1]);
      tangent->InsertNextTuple3(-q[1] / w, q[0] / w, 0.);
      normals->InsertNextTuple3((q[0] - q[0] / w) / 0.4, (q[1] - q[1] / w) / 0.4, q[2] / 0.4);
    }
    mesh.Mesh->GetPointData()->AddArray(tangent);
    if (exactNormals)
    {
      mesh.Mesh->GetPointData()->SetNormals(normals);
    }
    vtkNew<vtkMesoQuadricFit> filter;
    set(filter);
    const double microseconds = Time(filter.Get(), mesh.Mesh);
    time = i == 1 ? microseconds : time;
    errors[i] = 0.;
    conditions[i] = 0.;
    for (vtkIdType p = 0; p < mesh.Mesh->GetNumberOfPoints(); ++p)
    {
      // The tangent runs along the direction of c_min, and y along that of c_max.
      const MesoVector q = TupleOf(filter->GetOutput(), "MesoQuadric", p);
      const double a = q[0] - 0.5 * mesh.Curvatures[p][1];
      const double b = q[1] - 0.5 * mesh.Curvatures[p][0];
      errors[i] += a * a + b * b + 0.5 * q[2] * q[2];
      conditions[i] =
        std::max(conditions[i], TupleOf(filter->GetOutput(), "MesoQuadricCondition", p)[0]);
    }
    errors[i] = std::sqrt(errors[i] / static_cast<double>(mesh.Mesh->GetNumberOfPoints())) / 1.25;
  }
  std::printf("| %s | %s, %s | %.1e | %.1e | %.1e | %.1f | %.1e | %.1f |\n", method,
    jitter > 0. ? "jittered" : "regular", exactNormals ? "exact" : "made", errors[0], errors[1],
    errors[2], 0.5 * std::log2(errors[0] / errors[2]), conditions[1], time);
}

void QuadricTable()
{
  std::printf(
    "\n| quadric | torus, normals | rms, 2k | rms, 8k | rms, 32k | order | condition, 8k | "
    "us a vertex |\n| - | - | - | - | - | - | - | - |\n");
  const auto paper = [](vtkMesoQuadricFit* filter)
  {
    filter->FullOff();
    filter->SlopesOff();
    filter->SetRings(1);
    filter->NormalEquationsOn();
  };
  const auto full = [](vtkMesoQuadricFit* filter)
  {
    filter->SlopesOff();
    filter->SetRings(1);
  };
  const auto slopes = [](vtkMesoQuadricFit*) {};
  for (const double jitter : { 0., 0.24 })
  {
    for (const bool exact : { true, false })
    {
      QuadricRow("a, b, one ring, normal equations (Oliveira2005)", paper, jitter, exact);
      QuadricRow("a, b, c, one ring", full, jitter, exact);
      QuadricRow("a, b, c and slopes, two rings (default)", slopes, jitter, exact);
    }
  }
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
#ifdef MESO_WITH_CGAL
      Row("CGAL, degree 4, 3 rings", Cgal<4, 3>, surface, jitter);
      Row("CGAL, degree 2, 2 rings", Cgal<2, 2>, surface, jitter);
#endif
    }
  }
  QuadricTable();
  return 0;
}

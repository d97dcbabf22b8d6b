#ifndef CurvatureRun_h
#define CurvatureRun_h

#include "CurvedMeshes.h"

#include "vtkMesoPrincipalCurvatures.h"

#include <gtest/gtest.h>

/// The filter's output as numbers.
struct CurvatureRun
{
  std::vector<std::array<double, 2>> Curvatures;
  std::vector<std::array<MesoVector, 2>> Directions;
  std::vector<double> Confidences;
  vtkSmartPointer<vtkPolyData> Output;
};

/// Also expects what holds on every mesh: finite values, order, directions that are an orthonormal
/// pair at right angles to the normal, and zeros exactly where the confidence is 0.
inline CurvatureRun RunCurvatures(vtkPolyData* mesh, double featureAngle = 60.)
{
  CurvatureRun run;
  vtkNew<vtkMesoPrincipalCurvatures> filter;
  filter->SetInputData(mesh);
  filter->SetFeatureAngle(featureAngle);
  filter->Update();
  run.Output = filter->GetOutput();
  vtkPointData* data = run.Output->GetPointData();
  vtkDataArray* curvatures = data->GetArray("MesoCurvature");
  vtkDataArray* directions = data->GetArray("MesoPrincipalDirections");
  vtkDataArray* confidences = data->GetArray("MesoCurvatureConfidence");
  if (!curvatures || !directions || !confidences)
  {
    ADD_FAILURE() << "arrays are missing";
    return run;
  }
  const double rounding = curvatures->GetDataType() == VTK_DOUBLE ? 1e-12 : 1e-6;
  for (vtkIdType i = 0; i < run.Output->GetNumberOfPoints(); ++i)
  {
    std::array<double, 2> c;
    std::array<double, 6> d;
    curvatures->GetTuple(i, c.data());
    directions->GetTuple(i, d.data());
    const double confidence = confidences->GetComponent(i, 0);
    run.Curvatures.push_back(c);
    run.Directions.push_back({ MesoVector{ d[0], d[1], d[2] }, MesoVector{ d[3], d[4], d[5] } });
    run.Confidences.push_back(confidence);
    const MesoVector& first = run.Directions.back()[0];
    const MesoVector& second = run.Directions.back()[1];
    EXPECT_TRUE(confidence >= 0. && confidence <= 1.) << i << ": " << confidence;
    EXPECT_TRUE(std::isfinite(c[0]) && std::isfinite(c[1])) << i;
    EXPECT_GE(c[0], c[1]) << i;
    const double length = confidence > 0. ? 1. : 0.;
    EXPECT_NEAR(MesoLength(first), length, rounding) << i;
    EXPECT_NEAR(MesoLength(second), length, rounding) << i;
    EXPECT_NEAR(MesoDot(first, second), 0., rounding) << i;
    const MesoVector normal = TupleOf(run.Output, "Normals", i);
    EXPECT_LT(DistanceOf(MesoCross(first, second), MesoScaled(normal, length)), 4. * rounding) << i;
    EXPECT_TRUE(confidence > 0. || (c[0] == 0. && c[1] == 0.)) << i;
  }
  return run;
}

struct CurvatureError
{
  double Maximum = 0.; ///< root mean square of the error of c_max over the largest curvature
  double Minimum = 0.; ///< the same of c_min
  double Direction =
    0.; ///< root mean square of the angle, in radians, where curvatures are distinct
};

inline CurvatureError ErrorOf(const CurvedMesh& mesh, const CurvatureRun& run, bool borders = true)
{
  CurvatureError error;
  const double largest = mesh.Largest() > 0. ? mesh.Largest() : 1.;
  double all = 0.;
  double distinct = 0.;
  for (std::size_t i = 0; i < mesh.Curvatures.size(); ++i)
  {
    if (mesh.Border[i] && !borders)
    {
      continue;
    }
    const auto& exact = mesh.Curvatures[i];
    error.Maximum += std::pow((run.Curvatures[i][0] - exact[0]) / largest, 2.);
    error.Minimum += std::pow((run.Curvatures[i][1] - exact[1]) / largest, 2.);
    all += 1.;
    if (exact[0] - exact[1] > 0.1 * largest)
    {
      const double sine = MesoLength(MesoCross(run.Directions[i][0], mesh.Directions[i]));
      error.Direction += std::pow(std::asin(std::min(1., sine)), 2.);
      distinct += 1.;
    }
  }
  error.Maximum = std::sqrt(error.Maximum / all);
  error.Minimum = std::sqrt(error.Minimum / all);
  error.Direction = std::sqrt(error.Direction / std::max(1., distinct));
  return error;
}

#endif

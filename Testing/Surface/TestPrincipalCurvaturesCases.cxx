// vtkMesoPrincipalCurvatures on the cases that users of other libraries report: each test is named
// after what was complained about (libigl's issues 11, 37, 88, 221, 310, 1405, 1767, 2176 and 2443,
// PyMeshLab's 428, trimesh's 698).

#include "CurvatureRun.h"

#include <limits>

namespace
{
const double Pi = std::acos(-1.);

void Append(vtkPolyData* mesh, const std::vector<MesoVector>& positions,
  const std::vector<std::array<vtkIdType, 3>>& triangles)
{
  const vtkIdType first = mesh->GetNumberOfPoints();
  for (const MesoVector& position : positions)
  {
    mesh->GetPoints()->InsertNextPoint(position.data());
  }
  for (const auto& t : triangles)
  {
    mesh->GetPolys()->InsertNextCell({ first + t[0], first + t[1], first + t[2] });
  }
}

/// A unit cylinder whose sides meet a flat cap at z = 0 in shared points.
vtkSmartPointer<vtkPolyData> CappedCylinder(int sides, int rings)
{
  std::vector<MesoVector> positions;
  std::vector<std::vector<vtkIdType>> cells;
  const auto at = [&](int ring, int side) { return vtkIdType(ring) * sides + side % sides; };
  // Rings 0 to `rings` - 1 on the cap, the next on its rim, then down the side.
  for (int ring = 0; ring <= 2 * rings; ++ring)
  {
    for (int side = 0; side < sides; ++side)
    {
      const double a = 2. * Pi * side / sides;
      const double r = ring < rings ? (ring + 1.) / (rings + 1.) : 1.;
      const double z = ring < rings ? 0. : -0.12 * (ring - rings);
      positions.push_back({ r * std::cos(a), r * std::sin(a), z });
      if (ring > 0)
      {
        const vtkIdType b = at(ring, side);
        const vtkIdType c = at(ring, side + 1);
        const vtkIdType d = at(ring - 1, side + 1);
        const vtkIdType e = at(ring - 1, side);
        cells.push_back({ b, c, d });
        cells.push_back({ b, d, e });
      }
    }
  }
  return MakeMesh(positions, {}, cells);
}
}

TEST(CurvatureComplaints, FewerThanSixNeighbours)
{
  // A tetrahedron and an octahedron have 3 and 5 in all, and none may be a crease.
  const CurvatureRun four =
    RunCurvatures(MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, {},
                    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } }),
      180.);
  const CurvatureRun six = RunCurvatures(
    MakeMesh({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } },
      {},
      { { 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 }, { 4, 0, 2 }, { 1, 0, 5 }, { 3, 1, 5 }, { 4, 3, 5 },
        { 0, 4, 5 } }),
    180.);
  for (const CurvatureRun* run : { &four, &six })
  {
    for (double confidence : run->Confidences)
    {
      EXPECT_EQ(confidence, 0.);
    }
  }
  // Six are enough for a quadric: a fan over a paraboloid with c = 1.
  std::vector<MesoVector> fan = { { 0., 0., 0. } };
  std::vector<std::vector<vtkIdType>> cells;
  for (int i = 0; i < 6; ++i)
  {
    const double x = 0.1 * std::cos(Pi * i / 3.);
    const double y = 0.15 * std::sin(Pi * i / 3.);
    fan.push_back({ x, y, -0.5 * x * x - 0.25 * y * y });
    cells.push_back({ 0, 1 + i, 1 + (i + 1) % 6 });
  }
  const CurvatureRun seven = RunCurvatures(MakeMesh(fan, {}, cells));
  EXPECT_NEAR(seven.Curvatures[0][0], 1., 1e-9);
  EXPECT_NEAR(seven.Curvatures[0][1], 0.5, 1e-9);
  EXPECT_GT(seven.Confidences[0], 0.4);
  EXPECT_LE(seven.Confidences[0], 0.5);
}

TEST(CurvatureComplaints, SmallComponents)
{
  const CurvedMesh sphere = SampleSphere(6, 0.);
  const auto points = static_cast<std::size_t>(sphere.Mesh->GetNumberOfPoints());
  Append(sphere.Mesh, { { 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 } }, { { 0, 1, 2 } });
  Append(sphere.Mesh, { { 9, 0, 0 }, { 9, 1, 0 }, { 8, 0, 1 }, { 8, 0, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  Append(sphere.Mesh, { { 7, 7, 7 } }, {}); // in no triangle
  const CurvatureRun run = RunCurvatures(sphere.Mesh);
  for (std::size_t i = 0; i < run.Confidences.size(); ++i)
  {
    EXPECT_EQ(run.Confidences[i] > 0., i < points) << i;
    EXPECT_NEAR(run.Curvatures[i][0], i < points ? 1. : 0., 0.01) << i;
  }
}

TEST(CurvatureComplaints, SkinnyTrianglesDoNotFlipSigns)
{
  // Triangles up to 100 times as long as wide, along the axis and around it.
  for (const std::array<int, 2> size :
    { std::array<int, 2>{ 200, 8 }, std::array<int, 2>{ 24, 1500 } })
  {
    const CurvedMesh mesh =
      SampleSurface(SurfaceNamed("cylinder"), size[0], size[1], true, false, 0.);
    const CurvatureRun run = RunCurvatures(mesh.Mesh);
    for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
    {
      // At and beside an open border the neighbours lie a hundred times wider along it than across,
      // on one side: nothing can be said about the curvature across.
      const bool said = run.Confidences[i] > 0.;
      const auto ring = static_cast<int>(i) / size[0];
      EXPECT_TRUE(said || ring < 2 || ring > size[1] - 2) << size[0] << " " << ring;
      EXPECT_NEAR(run.Curvatures[i][0], said ? 1. : 0., 0.02);
      EXPECT_NEAR(run.Curvatures[i][1], 0., 0.02);
    }
  }
}

TEST(CurvatureComplaints, SliversHaveValuesOrNone)
{
  // Points slid along edges until triangles nearly vanish, and then do.
  for (const double left : { 1e-2, 1e-4, 1e-8, 1e-16, 0. })
  {
    const CurvedMesh mesh = SampleNamed("torus", 2000, 0.);
    for (vtkIdType i = 0; i + 1 < mesh.Mesh->GetNumberOfPoints(); i += 37)
    {
      const MesoVector a = PositionOf(mesh.Mesh, i);
      const MesoVector b = PositionOf(mesh.Mesh, i + 1);
      const MesoVector p = MesoSum(MesoScaled(a, left), MesoScaled(b, 1. - left));
      mesh.Mesh->GetPoints()->SetPoint(i, p.data());
    }
    const CurvatureRun run = RunCurvatures(mesh.Mesh);
    double without = 0.;
    for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
    {
      without += run.Confidences[i] > 0. ? 0. : 1.;
      EXPECT_TRUE(run.Confidences[i] < 0.9 || std::abs(run.Curvatures[i][0] - 2.5) < 0.3) << left;
    }
    EXPECT_LT(without, 0.12 * static_cast<double>(run.Curvatures.size())) << left;
  }
}

TEST(CurvatureComplaints, SharpEdgesDoNotSwapMaximumAndMinimum)
{
  const int sides = 48;
  const int rings = 8;
  const CurvatureRun run = RunCurvatures(CappedCylinder(sides, rings));
  for (int ring = 0; ring <= 2 * rings; ++ring)
  {
    for (int side = 0; side < sides; ++side)
    {
      const std::size_t i = ring * sides + side;
      const bool rim = ring == rings;
      const double c = ring > rings ? 1. : 0.;
      EXPECT_EQ(run.Confidences[i] > 0., !rim) << ring;
      EXPECT_NEAR(run.Curvatures[i][0], c, 0.005) << ring;
      EXPECT_NEAR(run.Curvatures[i][1], 0., 0.005) << ring;
      EXPECT_TRUE(ring <= rings || std::abs(run.Directions[i][1][2]) > 0.9999) << ring;
    }
  }
}

TEST(CurvatureComplaints, MaximumIsNeverBelowMinimum)
{
  // RunCurvatures() expects the order at each point; here on noise, which has no curvature at all.
  const CurvedMesh mesh = SampleNamed("sphere", 500, 0.2);
  std::mt19937 random(3);
  for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
  {
    const double size = 1. + 0.05 * (static_cast<double>(random()) / 4294967295. - 0.5);
    const MesoVector p = MesoScaled(PositionOf(mesh.Mesh, i), size);
    mesh.Mesh->GetPoints()->SetPoint(i, p.data());
  }
  const CurvatureRun run = RunCurvatures(mesh.Mesh, 180.);
  double mean = 0.;
  for (double confidence : run.Confidences)
  {
    mean += confidence / static_cast<double>(run.Confidences.size());
  }
  EXPECT_LT(mean, 0.75); // the fit's residuals tell
}

TEST(CurvatureComplaints, MinimumAndMaximumAreNotSwapped)
{
  // Inside a torus' hole c_max = 1 / r runs around the tube, and c_min < 0 around the hole.
  const CurvedMesh mesh = SampleNamed("torus", 2000, 0.);
  const CurvatureRun run = RunCurvatures(mesh.Mesh);
  for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
  {
    const MesoVector p = PositionOf(mesh.Mesh, static_cast<vtkIdType>(i));
    const double cosine = (std::hypot(p[0], p[1]) - 1.) / 0.4;
    EXPECT_GT(run.Curvatures[i][0], 2.4);
    EXPECT_TRUE(std::abs(cosine) < 0.05 || (run.Curvatures[i][1] < 0.) == (cosine < 0.))
      << cosine << " " << run.Curvatures[i][1];
    EXPECT_GT(std::abs(MesoDot(run.Directions[i][0], mesh.Directions[i])), 0.999);
  }
}

TEST(CurvatureComplaints, GaussianCurvatureIsTheProduct)
{
  const CurvedMesh mesh = SampleNamed("torus", 8000, 0.24);
  const CurvatureRun run = RunCurvatures(mesh.Mesh);
  for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
  {
    const double exact = mesh.Curvatures[i][0] * mesh.Curvatures[i][1];
    EXPECT_NEAR(run.Curvatures[i][0] * run.Curvatures[i][1], exact, 0.1); // of 4.2 at most
    const double mean = 0.5 * (run.Curvatures[i][0] + run.Curvatures[i][1]);
    EXPECT_GE(mean * mean, run.Curvatures[i][0] * run.Curvatures[i][1]);
  }
}

TEST(CurvatureComplaints, BrokenMeshesGiveNoNaN)
{
  const double huge = std::numeric_limits<double>::max();
  const std::vector<MesoVector> square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  RunCurvatures(
    MakeMesh(square, {}, { { 0, 1, 2 }, { 0, 1, 2 }, { 2, 1, 0 } })); // duplicates, turned
  RunCurvatures(MakeMesh(square, {}, { { 0, 0, 0 }, { 0, 1, 1 }, { 0, 1, 2 } })); // without area
  RunCurvatures(MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } }, {},
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } })); // three triangles at an edge
  RunCurvatures(MakeMesh({ { 0, 0, 0 }, { huge, 0, 0 }, { 0, huge, 0 } }, {}, { { 0, 1, 2 } }));
  RunCurvatures(MakeMesh({ { 0, 0, 0 }, { 1e-300, 0, 0 }, { 0, 1e-300, 0 } }, {}, { { 0, 1, 2 } }));
  std::vector<MesoVector> fan = { { 0., 0., 1. } };
  std::vector<std::vector<vtkIdType>> cells;
  for (int i = 0; i < 20000; ++i) // all of its points are within two edges
  {
    const double a = 2. * Pi * i / 20000.;
    fan.push_back({ std::cos(a), std::sin(a), 0.7 });
    cells.push_back({ 0, 1 + i, 1 + (i + 1) % 20000 });
  }
  RunCurvatures(MakeMesh(fan, {}, cells));
}

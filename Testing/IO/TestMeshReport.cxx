// What is counted in meshes, each against a mesh small enough to count by hand.

#include "MesoChartOverlap.h"
#include "MesoMeshReport.h"
#include "TemporaryFolder.h"

#include "vtkMesoMeshReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{
const std::string Tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

MesoMeshReport Report(const std::string& text)
{
  const TemporaryFolder folder;
  vtkNew<vtkMesoMeshReader> reader;
  vtkObject::GlobalWarningDisplayOff();
  reader->SetFileName(folder.Write("m.obj", text).c_str());
  reader->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(reader->GetErrorMessage(), "");
  return MesoReportMesh(reader->GetOutput());
}
}

TEST(MeshReport, AClosedSurface)
{
  const auto report = Report(Tetrahedron + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_EQ(report.Vertices, 4u);
  EXPECT_EQ(report.Triangles, 4u);
  EXPECT_EQ(report.Components, 1u);
  EXPECT_EQ(report.BoundaryEdges + report.NonManifoldEdges + report.TurnedEdges, 0u);
  EXPECT_EQ(report.NonManifoldVertices, 0u);
  EXPECT_EQ(report.Degenerate + report.Duplicate, 0u);
  ASSERT_TRUE(report.Volume);
  EXPECT_NEAR(*report.Volume, 1. / 6., 1e-15);
  EXPECT_FALSE(report.Chart);
  EXPECT_EQ(report.Most, (std::array<double, 3>{ 1., 1., 1. }));

  const auto turned = Report(Tetrahedron + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  ASSERT_TRUE(turned.Volume);
  EXPECT_NEAR(*turned.Volume, -1. / 6., 1e-15) << "inside out";
}

TEST(MeshReport, BrokenJoints)
{
  const auto fin = Report(Tetrahedron + "v 0 0 -1\nf 1 2 3\nf 1 2 4\nf 2 1 5\n");
  EXPECT_EQ(fin.NonManifoldEdges, 1u);
  EXPECT_EQ(fin.BoundaryEdges, 6u);
  EXPECT_FALSE(fin.Volume);
  EXPECT_EQ(fin.NonManifoldVertices, 0u);

  const auto turned = Report(Tetrahedron + "f 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(turned.TurnedEdges, 1u);

  const auto bow = Report("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n");
  EXPECT_EQ(bow.NonManifoldVertices, 1u);
  EXPECT_EQ(bow.Components, 1u);

  const auto twice = Report(Tetrahedron + "f 1 2 3\nf 3 1 2\nf 2 1 3\n");
  EXPECT_EQ(twice.Duplicate, 2u);
  EXPECT_EQ(twice.Components, 1u);

  const auto sliver = Report("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 5 5 5\nv 6 5 5\nv 5 6 5\n"
                             "f 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(sliver.Degenerate, 1u);
  EXPECT_EQ(sliver.Components, 2u);
}

TEST(MeshReport, Charts)
{
  // A square of two triangles in one chart, and a third, mirrored, in a chart of its own.
  const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 0 0\n"
                             "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 3 0\nvt 2 0\nvt 3 1\n";
  const auto report = Report(square + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 2/5 5/6 3/7\n");
  ASSERT_TRUE(report.Chart);
  EXPECT_EQ(report.Chart->Charts, 2u);
  EXPECT_EQ(report.Chart->SeamEdges, 1u);
  EXPECT_EQ(report.Chart->Mirrored, 1u);
  EXPECT_EQ(report.Chart->Degenerate, 0u);
  EXPECT_EQ(report.Chart->Most, (std::array<double, 2>{ 3., 1. }));
  EXPECT_NEAR(report.Chart->Scale, 2., 1e-12);
  ASSERT_TRUE(report.Chart->Overlap);
  EXPECT_EQ(*report.Chart->Overlap, 0.);

  const auto flat = Report(square + "f 1/1 2/2 3/2\nf 1/1 3/3 4/4\n");
  EXPECT_EQ(flat.Chart->Degenerate, 1u);
  const auto over = Report(square + "f 1/1 2/2 3/3\nf 2/1 5/2 3/3\n");
  EXPECT_EQ(*over.Chart->Overlap, 1.);
}

TEST(MeshReport, OverlapIsAPart)
{
  // Two squares of side 1 that share half of each: 0.5 of 1.5.
  const auto square = [](double x)
  {
    return std::vector<MesoTextureTriangle>{ { { { x, 0 }, { x + 1, 0 }, { x + 1, 1 } } },
      { { { x, 0 }, { x + 1, 1 }, { x, 1 } } } };
  };
  auto triangles = square(0.);
  EXPECT_EQ(*MesoChartOverlap(triangles), 0.);
  for (const auto& triangle : square(0.5))
  {
    triangles.push_back(triangle);
  }
  EXPECT_NEAR(*MesoChartOverlap(triangles), 1. / 3., 0.005);
  EXPECT_EQ(*MesoChartOverlap({}), 0.);
  // A long list of large triangles is given up.
  EXPECT_FALSE(MesoChartOverlap(std::vector<MesoTextureTriangle>(1000, triangles[0])));
}

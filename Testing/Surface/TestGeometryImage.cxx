// Geometry images: closed where the mesh is, whatever charts it is in; nearer to the mesh with each size;
// facing outward, mirrored charts included; and levels that lie where they say.

#include "ErrorRecorder.h"
#include "SurfaceArrays.h"
#include "vtkMesoGeometryImage.h"
#include "vtkMesoShapeSource.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
vtkSmartPointer<vtkPolyData> Shape(
  const char* name, const std::map<std::string, std::vector<double>>& parameters = {})
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape(name);
  for (const auto& parameter : parameters)
  {
    source->SetParameter(parameter.first, parameter.second);
  }
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> ImageOf(vtkPolyData* mesh, int size)
{
  vtkNew<vtkMesoGeometryImage> filter;
  filter->SetInputData(mesh);
  filter->SetSize(size);
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(), "");
  return filter->GetOutput();
}

using Place = std::array<double, 3>;

/// Edges that have no like of the other direction, by position.
int OpenEdges(vtkPolyData* surface)
{
  std::map<std::array<Place, 2>, int> edges;
  const auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (int k = 0; k < 3; ++k)
    {
      std::array<Place, 2> edge;
      surface->GetPoint(ids[k], edge[0].data());
      surface->GetPoint(ids[(k + 1) % 3], edge[1].data());
      ++edges[edge];
    }
  }
  int open = 0;
  for (const auto& edge : edges)
  {
    const auto back = edges.find({ edge.first[1], edge.first[0] });
    open += edge.second - (back == edges.end() ? 0 : std::min(edge.second, back->second));
  }
  return open;
}

/// Six times the volume around the origin.
double Volume(vtkPolyData* surface)
{
  double sum = 0.;
  const auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    MesoVector p[3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids[k], p[k].data());
    }
    sum += MesoDot(p[0], MesoCross(p[1], p[2]));
  }
  return sum;
}

/// Root mean square error of a level.
double ErrorOf(vtkImageData* image, int level)
{
  return image->GetFieldData()->GetArray("MesoLevels")->GetComponent(level, 2);
}
}

TEST(GeometryImage, ClosesWhereTheMeshIsClosed)
{
  for (const char* shape : { "torus", "cube" })
  {
    const auto mesh = Shape(shape);
    for (const int size : { 32, 48, 64, 128 })
    {
      const auto image = ImageOf(mesh, size);
      const auto surface = vtkMesoGeometryImage::SurfaceOf(image, 0);
      EXPECT_GT(surface->GetNumberOfPolys(), size * size) << shape;
      EXPECT_EQ(OpenEdges(surface), 0) << shape << " " << size;
    }
  }
}

TEST(GeometryImage, OpenMeshesEndWhereTheyEnd)
{
  const auto surface = vtkMesoGeometryImage::SurfaceOf(ImageOf(Shape("plane"), 32), 0);
  double bounds[6];
  surface->GetBounds(bounds);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(bounds[k], k % 2 ? 0.5 : -0.5, 1e-6);
  }
  const int open = OpenEdges(surface);
  EXPECT_GT(open, 4 * 15);
  EXPECT_LT(open, 4 * 32);
  // Its corners are kept.
  double nearest = 1.;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    nearest = std::min(nearest, std::hypot(p[0] - 0.5, p[1] - 0.5));
  }
  EXPECT_EQ(nearest, 0.);
}

TEST(GeometryImage, ErrorFallsWithTheSize)
{
  const auto mesh = Shape("torus", { { "rings", { 96. } }, { "sides", { 48. } } });
  const auto image = ImageOf(mesh, 128);
  vtkDataArray* levels = image->GetFieldData()->GetArray("MesoLevels");
  ASSERT_EQ(levels->GetNumberOfTuples(), 5); // 128 to 8
  for (int level = 0; level < 4; ++level)
  {
    std::cout << levels->GetComponent(level, 0) << ": rms " << ErrorOf(image, level) << ", largest "
              << levels->GetComponent(level, 3) << "\n";
    EXPECT_EQ(levels->GetComponent(level, 0), 128 >> level);
    // Chords lie below arcs by the square of their length; along seams they are twice as long.
    EXPECT_LT(ErrorOf(image, level), 0.55 * ErrorOf(image, level + 1)) << level;
  }
  EXPECT_LT(ErrorOf(image, 0), 1e-3);
  // A level is what an image of its size would be.
  const auto small = ImageOf(mesh, 32);
  EXPECT_EQ(ErrorOf(small, 0), ErrorOf(image, 2));
  EXPECT_EQ(vtkMesoGeometryImage::SurfaceOf(small, 0)->GetNumberOfPolys(),
    vtkMesoGeometryImage::SurfaceOf(image, 2)->GetNumberOfPolys());
}

TEST(GeometryImage, MirroredChartsFaceOutwardToo)
{
  const auto mesh = Shape("sphere");
  const double volume = Volume(mesh);
  ASSERT_GT(volume, 0.);
  const auto straight = ImageOf(mesh, 64);
  EXPECT_NEAR(Volume(vtkMesoGeometryImage::SurfaceOf(straight, 0)), volume, 0.05 * volume);
  vtkNew<vtkPolyData> mirrored;
  mirrored->DeepCopy(mesh);
  vtkDataArray* coordinates = mirrored->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, 1. - coordinates->GetComponent(i, 0));
  }
  const auto image = ImageOf(mirrored, 64);
  EXPECT_NEAR(Volume(vtkMesoGeometryImage::SurfaceOf(image, 0)), volume, 0.05 * volume);
  const double* range = image->GetPointData()->GetArray("MesoChart")->GetRange();
  EXPECT_LT(range[0], 0.);
  EXPECT_EQ(range[1], 0.);
}

TEST(GeometryImage, FollowsCoordinatesBeyondTheMap)
{
  const auto mesh = Shape("torus");
  vtkNew<vtkPolyData> shifted;
  shifted->DeepCopy(mesh);
  vtkDataArray* coordinates = shifted->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, coordinates->GetComponent(i, 0) - 0.125);
  }
  const auto surface = vtkMesoGeometryImage::SurfaceOf(ImageOf(shifted, 64), 0);
  EXPECT_EQ(OpenEdges(surface), 0);
  const double* range = surface->GetPointData()->GetTCoords()->GetRange(0);
  EXPECT_NEAR(range[0], -0.125, 1e-6);
  EXPECT_NEAR(range[1], 0.875, 1e-6);
}

TEST(GeometryImage, NormalsAreUnitWhereThereIsAChart)
{
  const auto image = ImageOf(Shape("cube"), 48);
  vtkDataArray* charts = image->GetPointData()->GetArray("MesoChart");
  vtkDataArray* normals = image->GetPointData()->GetArray("MesoNormal");
  int covered = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* n = normals->GetTuple3(i);
    const bool chart = charts->GetTuple1(i) != 0.;
    covered += chart ? 1 : 0;
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), chart ? 1. : 0., 1e-6);
  }
  EXPECT_GT(covered, 48 * 48 / 2);
}

TEST(GeometryImage, SaysWhatItCannotUse)
{
  vtkNew<vtkMesoGeometryImage> filter;
  ErrorRecorder errors;
  errors.Watch(filter);
  const auto message = [&](vtkPolyData* mesh)
  {
    filter->SetInputData(mesh);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    return filter->GetErrorMessage();
  };
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(Shape("torus"));
  mesh->GetPointData()->GetTCoords()->SetComponent(7, 1, 2.25);
  EXPECT_EQ(message(mesh),
    "the texture coordinates spread over 2.250000 tiles: a geometry image needs an atlas in [0, 1] "
    "x "
    "[0, 1]");
  mesh->DeepCopy(Shape("torus"));
  mesh->GetPointData()->GetNormals()->SetComponent(7, 1, NAN);
  EXPECT_NE(message(mesh).find("the normal of point 7 is not finite"), std::string::npos);
  mesh->DeepCopy(Shape("torus"));
  mesh->GetPointData()->SetTCoords(nullptr);
  mesh->GetPointData()->RemoveArray("TextureCoordinates");
  EXPECT_EQ(message(mesh), "the mesh has no texture coordinates");
  EXPECT_EQ(errors.Errors.size(), 3u);
  std::string problem;
  vtkNew<vtkImageData> other;
  other->SetDimensions(4, 4, 1);
  EXPECT_EQ(vtkMesoGeometryImage::NumberOfLevelsOf(other, problem), 0);
  EXPECT_EQ(problem, "a geometry image has MesoLevels among its field data, which is missing");
}

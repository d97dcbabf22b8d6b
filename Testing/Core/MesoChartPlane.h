#ifndef MesoChartPlane_h
#define MesoChartPlane_h

/**
 * @file MesoChartPlane.h
 * @brief A plane under any affine chart, seen from straight above: what each pixel should show is known.
 *
 * The plane lies in z = 0 with normal +z. Its points are (x, y) = J (u - 1/2, v - 1/2) for the texture
 * coordinates (u, v) in [0,1]^2; J may stretch, shear and mirror.
 */

#include "MesoTestScene.h"

#include "vtkMesoAOVPass.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>
#include <functional>

/// J = [[a, b], [c, d]]: dp/du = (a, c), dp/dv = (b, d).
struct MesoChart
{
  const char* Name;
  double A, B, C, D;

  double Determinant() const { return this->A * this->D - this->B * this->C; }

  /// Unit normal of the height field of slopes (dh/du, dh/dv) and depth D over the chart: that of
  /// z = D h, whose gradient over the plane is J^-T (dh/du, dh/dv).
  std::array<double, 3> Normal(double slopeU, double slopeV, double depth) const
  {
    const double x = -depth * (this->D * slopeU - this->C * slopeV) / this->Determinant();
    const double y = -depth * (this->A * slopeV - this->B * slopeU) / this->Determinant();
    const double length = std::sqrt(x * x + y * y + 1.);
    return { x / length, y / length, 1. / length };
  }
};

/// Orthogonal, stretched, mirrored, sheared, and all of these.
inline const MesoChart MesoCharts[] = { { "Square", 1., 0., 0., 1. },
  { "Stretched", 1.6, 0., 0., 0.7 }, { "Mirrored", -1., 0., 0., 1. },
  { "Sheared", 1., 0.8, 0., 0.9 }, { "ShearedAndMirrored", -1.2, 0.5, 0.4, 0.8 } };

/// Front faces show to +z whatever way the chart turns; with `turned`, to -z.
inline vtkSmartPointer<vtkPolyData> MesoChartMesh(
  const MesoChart& chart, int cuts = 1, bool turned = false)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (int row = 0; row <= cuts; ++row)
  {
    for (int column = 0; column <= cuts; ++column)
    {
      const double u = double(column) / cuts;
      const double v = double(row) / cuts;
      points->InsertNextPoint(
        chart.A * (u - 0.5) + chart.B * (v - 0.5), chart.C * (u - 0.5) + chart.D * (v - 0.5), 0.);
      normals->InsertNextTuple3(0., 0., 1.);
      coordinates->InsertNextTuple2(u, v);
    }
  }
  vtkNew<vtkCellArray> triangles;
  for (int row = 0; row < cuts; ++row)
  {
    for (int column = 0; column < cuts; ++column)
    {
      const vtkIdType a = row * (cuts + 1) + column;
      const vtkIdType b = a + 1;
      const vtkIdType c = a + cuts + 1;
      const vtkIdType d = c + 1;
      const bool swapped = (chart.Determinant() < 0.) != turned;
      const vtkIdType first[] = { a, swapped ? d : b, swapped ? b : d };
      const vtkIdType second[] = { a, swapped ? c : d, swapped ? d : c };
      triangles->InsertNextCell(3, first);
      triangles->InsertNextCell(3, second);
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(mesh);
  frames->Update();
  return frames->GetOutput();
}

/// An image of float values at texel centres, of a function of map coordinates.
inline vtkSmartPointer<vtkImageData> MesoImageOf(int width, int height, int components,
  const std::function<std::array<double, 3>(double, double)>& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  auto* target = static_cast<float*>(image->GetScalarPointer());
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const auto value = values((column + 0.5) / width, (row + 0.5) / height);
      for (int k = 0; k < components; ++k)
      {
        *target++ = static_cast<float>(value[k]);
      }
    }
  }
  return image;
}

inline vtkSmartPointer<vtkImageData> MesoHeightsOf(
  int width, int height, const std::function<double(double, double)>& heights)
{
  return MesoImageOf(width, height, 1,
    [&](double u, double v) {
      return std::array<double, 3>{ heights(u, v), 0., 0. };
    });
}

/// The plane before a parallel camera that looks straight down.
struct MesoChartPlane : public MesoTestScene
{
  vtkNew<vtkMesoAOVPass> Pass;

  explicit MesoChartPlane(int size = 64)
    : MesoTestScene(size, size)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.4);
    camera->SetPosition(0., 0., 3.);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    this->Renderer->ResetCameraClippingRange();
  }

  ~MesoChartPlane() { this->Pass->ReleaseGraphicsResources(this->Window); }

  void Capture()
  {
    this->Renderer->SetPass(this->Pass);
    this->Window->Render();
    this->Renderer->SetPass(nullptr);
  }

  /// Calls a function of (column, row) for every covered pixel; gives their number.
  int ForEachPixel(const std::function<void(int, int)>& function) const
  {
    int covered = 0;
    for (int row = 0; row < this->Pass->GetHeight(); ++row)
    {
      for (int column = 0; column < this->Pass->GetWidth(); ++column)
      {
        if (this->Pass->GetValue("coverage", column, row) > 0.f)
        {
          ++covered;
          function(column, row);
        }
      }
    }
    return covered;
  }

  std::array<double, 3> NormalAt(int column, int row) const
  {
    return { this->Pass->GetValue("normal.x", column, row),
      this->Pass->GetValue("normal.y", column, row),
      this->Pass->GetValue("normal.z", column, row) };
  }
};

/// Degrees between two unit vectors; exact for small angles.
inline double MesoDegreesBetween(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  return 2. * std::asin(std::min(1., apart / 2.)) * 180. / std::acos(-1.);
}

#endif

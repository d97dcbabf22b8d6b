#include "vtk_glew.h" // must come first

#include "MesoGeometryImageShader.h"

#include "MesoGridBase.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMesoGeometryImage.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>

MesoGeometryImageShader::MesoGeometryImageShader() = default;

MesoGeometryImageShader::~MesoGeometryImageShader() = default;

void MesoGeometryImageShader::SetImage(vtkImageData* image)
{
  this->Image = image;
  this->UploadedTime = 0;
}

void MesoGeometryImageShader::SetBufferPlace(
  const std::array<double, 3>& shift, const std::array<double, 3>& scale)
{
  if (shift != this->Shift || scale != this->Scale)
  {
    this->Shift = shift;
    this->Scale = scale;
    this->UploadedTime = 0;
  }
}

MesoShaderShape MesoGeometryImageShader::GetShape() const
{
  MesoShaderShape shape = MesoTechniqueShader::GetShape();
  if (this->Image && MesoEffectsOn(this->Options).Has(MesoEffect::Shading))
  {
    shape.Diced = true;
    shape.VertexChunks = { "Techniques/GeometryImage.glsl" };
  }
  return shape;
}

std::string MesoGeometryImageShader::Upload(vtkOpenGLRenderWindow* window)
{
  std::string problem;
  const int count = vtkMesoGeometryImage::NumberOfLevelsOf(this->Image, problem);
  if (count == 0)
  {
    return problem;
  }
  std::vector<float> vertices;
  std::vector<unsigned int> indices;
  this->Levels.clear();
  for (int level = 0; level < count; ++level)
  {
    const vtkSmartPointer<vtkPolyData> surface =
      vtkMesoGeometryImage::SurfaceOf(this->Image, level);
    if (level == 0)
    {
      surface->GetBounds(this->Bounds.data());
    }
    const auto firstVertex = static_cast<unsigned int>(vertices.size() / 8);
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      for (int k = 0; k < 3; ++k)
      {
        vertices.push_back(static_cast<float>((p[k] - this->Shift[k]) * this->Scale[k]));
      }
      for (int k = 0; k < 3; ++k)
      {
        vertices.push_back(static_cast<float>(normals->GetComponent(i, k)));
      }
      for (int k = 0; k < 2; ++k)
      {
        vertices.push_back(static_cast<float>(coordinates->GetComponent(i, k)));
      }
    }
    Grid grid = { indices.size(), 0, 0. };
    double area = 0.;
    for (vtkIdType t = 0; t < surface->GetNumberOfPolys(); ++t)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      surface->GetCellPoints(t, size, corners);
      double points[3][3];
      for (int k = 0; k < 3; ++k)
      {
        indices.push_back(firstVertex + static_cast<unsigned int>(corners[k]));
        surface->GetPoint(corners[k], points[k]);
      }
      area += vtkTriangle::TriangleArea(points[0], points[1], points[2]);
    }
    grid.Indices = indices.size() - grid.FirstIndex;
    grid.Spacing = grid.Indices > 0 ? std::sqrt(6. * area / static_cast<double>(grid.Indices)) : 0.;
    this->Levels.push_back(grid);
  }
  if (indices.empty())
  {
    return "the geometry image holds no triangle";
  }
  const std::string failure = this->Vertices.Upload(window, vertices, "the samples of the image");
  if (!failure.empty())
  {
    return failure;
  }
  if (!this->Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer))
  {
    return "the grids of the geometry image could not be made a buffer";
  }
  this->IndexBytes = indices.size() * sizeof(unsigned int);
  this->UploadedTime = this->Image->GetMTime();
  this->UploadedTo = window;
  return {};
}

std::string MesoGeometryImageShader::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->GetShape().Diced)
  {
    return {};
  }
  if (this->UploadedTime != this->Image->GetMTime() || this->UploadedTo != window)
  {
    const std::string failure = this->Upload(window);
    if (!failure.empty())
    {
      return failure;
    }
  }
  this->Vertices.Activate();
  return {};
}

void MesoGeometryImageShader::ChooseLevel(const MesoGridView& view)
{
  this->Level = 0;
  const double wanted = this->Options.FacetPixels.value_or(MesoFacetPixels(this->Options.Quality));
  // Clip coordinates' w at the nearest corner of the bounds: the distance, or 1 of parallel views.
  double nearest = 1e300;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double p[] = { this->Bounds[corner & 1], this->Bounds[2 + (corner >> 1 & 1)],
      this->Bounds[4 + (corner >> 2 & 1)], 1. };
    double w = view.Projection[15];
    for (int row = 0; row < 3; ++row)
    {
      double coordinate = 0.;
      for (int k = 0; k < 4; ++k)
      {
        coordinate += view.ModelToView[4 * row + k] * p[k];
      }
      w += view.Projection[12 + row] * coordinate;
    }
    nearest = std::min(nearest, w);
  }
  double stretch = 0.;
  for (int i = 0; i < 12; ++i)
  {
    stretch += i % 4 < 3 ? view.ModelToView[i] * view.ModelToView[i] / 3. : 0.;
  }
  const double pixels =
    std::sqrt(stretch) * std::abs(view.Projection[5]) * view.Height / (2. * nearest);
  for (std::size_t level = 1; level < this->Levels.size() && nearest > 0.; ++level)
  {
    if (this->Levels[level].Indices > 0 && this->Levels[level].Spacing * pixels <= wanted)
    {
      this->Level = static_cast<int>(level);
    }
  }
}

std::int64_t MesoGeometryImageShader::GetNumberOfTriangles() const
{
  return this->Levels.empty() ? 0 : std::int64_t(this->Levels[this->Level].Indices / 3);
}

void MesoGeometryImageShader::Draw()
{
  const Grid& grid = this->Levels[this->Level];
  this->Indices->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(grid.Indices), GL_UNSIGNED_INT,
    reinterpret_cast<const GLvoid*>(grid.FirstIndex * sizeof(unsigned int)));
  this->Indices->Release();
}

void MesoGeometryImageShader::SetUniforms(vtkShaderProgram* program)
{
  this->Vertices.SetUniform(program, "mesoVertices");
}

void MesoGeometryImageShader::Deactivate()
{
  this->Vertices.Deactivate();
}

void MesoGeometryImageShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources(window);
  this->Indices->ReleaseGraphicsResources();
  this->IndexBytes = 0;
  this->UploadedTime = 0;
}

std::size_t MesoGeometryImageShader::GetGPUBytes() const
{
  return this->Vertices.GetGPUBytes() + this->IndexBytes;
}

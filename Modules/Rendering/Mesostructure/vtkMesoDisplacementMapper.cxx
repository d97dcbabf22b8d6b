#include "vtkMesoDisplacementMapper.h"

#include "MesoActorView.h"
#include "MesoDisplacementShader.h"
#include "MesoGridBase.h"
#include "MesoGridBuffers.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>

vtkStandardNewMacro(vtkMesoDisplacementMapper);

struct vtkMesoDisplacementMapper::Grids
{
  std::unique_ptr<MesoGridBase> Base;
  vtkPolyData* Mesh = nullptr; ///< that Base is of; never looked into
  vtkTimeStamp BaseTime;
  vtkTimeStamp CornersTime;
  MesoGridPieces Pieces;
  MesoGridBuffers Buffers;
};

vtkMesoDisplacementMapper::vtkMesoDisplacementMapper()
  : Displacement(std::make_unique<MesoDisplacementShader>())
  , Inside(std::make_unique<Grids>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Displacement;
  this->SetOptions(options);
}

vtkMesoDisplacementMapper::~vtkMesoDisplacementMapper() = default;

void vtkMesoDisplacementMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->GetHeightMap() << "\n";
  os << indent << "HorizonMap: " << this->GetHorizonMap() << "\n";
  os << indent << "NumberOfTrianglesDrawn: " << this->GetNumberOfTrianglesDrawn() << "\n";
}

void vtkMesoDisplacementMapper::SetHeightMap(vtkImageData* heights)
{
  if (heights != this->GetHeightMap())
  {
    this->Displacement->GetHeights().SetHeightMap(heights);
    this->Modified();
  }
}

vtkImageData* vtkMesoDisplacementMapper::GetHeightMap()
{
  return this->Displacement->GetHeights().GetHeightMap();
}

void vtkMesoDisplacementMapper::SetHorizonMap(vtkImageData* horizons, double scale)
{
  if (horizons && !(scale > 0.))
  {
    vtkErrorMacro("The scale of a horizon map must be above 0; got " << scale);
    return;
  }
  this->Displacement->GetHorizon().SetHorizonMap(horizons, scale);
  this->Modified();
}

vtkImageData* vtkMesoDisplacementMapper::GetHorizonMap()
{
  return this->Displacement->GetHorizon().GetHorizonMap();
}

std::int64_t vtkMesoDisplacementMapper::GetNumberOfTrianglesDrawn()
{
  return this->Inside->Pieces.Groups.empty() ? this->Superclass::GetNumberOfTrianglesDrawn()
                                             : this->Inside->Pieces.Triangles;
}

MesoTechniqueShader* vtkMesoDisplacementMapper::GetTechnique()
{
  return this->Displacement.get();
}

MesoTechnique vtkMesoDisplacementMapper::TechniqueOf(const MesoMesostructureOptions&) const
{
  return MesoTechnique::Displacement;
}

void vtkMesoDisplacementMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = MesoTechnique::Displacement; // whose effects "auto" means
  this->Displacement->SetOptions(options);
}

std::string vtkMesoDisplacementMapper::UpdateBase()
{
  Grids& grids = *this->Inside;
  if (grids.Base && grids.Mesh == this->CurrentInput &&
    this->CurrentInput->GetMTime() < grids.BaseTime)
  {
    return {};
  }
  grids.Base = nullptr;
  try
  {
    grids.Base = std::make_unique<MesoGridBase>(this->CurrentInput);
  }
  catch (const std::invalid_argument& problem)
  {
    return std::string(problem.what()) + ": the base mesh is drawn";
  }
  grids.Mesh = this->CurrentInput;
  grids.BaseTime.Modified();
  return {};
}

std::string vtkMesoDisplacementMapper::UpdateCorners(vtkOpenGLRenderWindow* window)
{
  Grids& grids = *this->Inside;
  using Extra = MesoDisplacementShader::Extra;
  if (grids.CornersTime > grids.BaseTime && grids.CornersTime > this->VBOBuildTime &&
    grids.Buffers.GetGPUBytes() > 0)
  {
    return {};
  }
  vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO("vertexMC");
  MesoVector shift = { 0., 0., 0. };
  MesoVector scale = { 1., 1., 1. };
  if (buffer && buffer->GetCoordShiftAndScaleEnabled())
  {
    std::copy_n(buffer->GetShift().begin(), 3, shift.begin());
    std::copy_n(buffer->GetScale().begin(), 3, scale.begin());
  }
  this->Displacement->SetBufferScale(scale);
  const Extra extra = this->Displacement->GetExtra();
  const std::size_t size = std::size_t(4) * this->Displacement->GetCornerTexels();
  const auto& triangles = grids.Base->GetTriangles();
  std::vector<float> numbers(size * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    float* out = &numbers[size * t];
    for (const std::int64_t point : triangles[t])
    {
      const MesoVector& position = grids.Base->GetPositions()[point];
      for (int k = 0; k < 3; ++k)
      {
        *out++ = static_cast<float>((position[k] - shift[k]) * scale[k]);
      }
      for (const double component : grids.Base->GetNormals()[point])
      {
        *out++ = static_cast<float>(component);
      }
      for (const double component : grids.Base->GetCoordinates()[point])
      {
        *out++ = static_cast<float>(component);
      }
    }
    for (const std::int64_t point : triangles[t])
    {
      if (extra == Extra::Colors)
      {
        for (int k = 0; k < 4; ++k)
        {
          *out++ = k < this->Colors->GetNumberOfComponents()
            ? static_cast<float>(this->Colors->GetComponent(point, k)) / 255.f
            : 1.f;
        }
      }
      else if (extra == Extra::Coordinates)
      {
        for (int k = 0; k < 2; ++k)
        {
          *out++ = static_cast<float>(this->ColorCoordinates->GetComponent(point, k));
        }
      }
    }
  }
  const std::string failure =
    numbers.empty() ? std::string() : grids.Buffers.SetCorners(window, numbers);
  grids.CornersTime.Modified();
  return failure;
}

std::string vtkMesoDisplacementMapper::UpdatePieces(vtkRenderer* renderer, vtkActor* actor)
{
  Grids& grids = *this->Inside;
  const MesoMesostructureOptions& options = this->GetOptions();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  MesoGridSize size;
  int texels[3];
  this->GetHeightMap()->GetDimensions(texels);
  size.Texels = { options.Tiles[0] * texels[0], options.Tiles[1] * texels[1] };
  size.FacetsPerTexel = MesoFacetsPerTexel(options.Quality);
  size.FacetPixels = options.FacetPixels.value_or(MesoFacetPixels(options.Quality));
  size.Reach = options.Scale;

  const MesoGridView view = MesoViewOfActor(renderer, actor);
  try
  {
    grids.Pieces = grids.Base->PiecesFor(size, &view);
  }
  catch (const std::invalid_argument& problem)
  {
    grids.Pieces = {};
    return problem.what();
  }
  return grids.Pieces.Numbers.empty() ? std::string()
                                      : grids.Buffers.SetPieces(window, grids.Pieces);
}

void vtkMesoDisplacementMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Displacement->SetFailure(this->UpdateBase());
  this->Superclass::RenderPieceStart(renderer, actor);
  if (!this->PlacesVertices(actor))
  {
    this->Inside->Pieces = {};
    return;
  }
  using Extra = MesoDisplacementShader::Extra;
  const bool coordinates = this->InterpolateScalarsBeforeMapping && this->ColorCoordinates;
  const bool colors = !coordinates && this->VBOs->GetNumberOfComponents("scalarColor") != 0;
  const Extra extra = coordinates ? Extra::Coordinates : (colors ? Extra::Colors : Extra::Nothing);
  if (extra != this->Displacement->GetExtra())
  {
    this->Displacement->SetExtra(extra);
    this->Inside->BaseTime.Modified();
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::string failure = this->UpdateCorners(window);
  if (failure.empty())
  {
    failure = this->UpdatePieces(renderer, actor);
  }
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    this->Inside->Pieces = {};
  }
  this->Inside->Buffers.Activate();
}

void vtkMesoDisplacementMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->PlacesVertices(actor))
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  if (!this->Inside->Pieces.Groups.empty() && this->ReadyToPlaceVertices(renderer, actor))
  {
    this->Inside->Buffers.Draw(this->LastBoundBO->Program, this->Inside->Pieces);
  }
}

void vtkMesoDisplacementMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Inside->Buffers.Deactivate();
  this->Superclass::RenderPieceFinish(renderer, actor);
}

void vtkMesoDisplacementMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  this->Inside->Buffers.SetUniforms(cellBO.Program);
}

void vtkMesoDisplacementMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inside->Buffers.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

std::size_t vtkMesoDisplacementMapper::GetGeometryBytes() const
{
  return this->Inside->Buffers.GetGPUBytes();
}

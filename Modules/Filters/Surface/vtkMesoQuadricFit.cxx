#include "vtkMesoQuadricFit.h"

#include "MesoFitInput.h"
#include "MesoQuadric.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <limits>
#include <new>

vtkStandardNewMacro(vtkMesoQuadricFit);

namespace
{
// Roundings that a depth gathers: two positions, a normal, and the products.
constexpr double RoundingsOfDepth = 8.;

std::vector<MesoVector> ReadTangents(vtkPolyData* input)
{
  vtkDataArray* array = input->GetPointData()->GetArray("MesoTangent");
  if (!array || array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw std::invalid_argument(
      "the mesh has no point array MesoTangent of 3 components, which vtkMesoSurfaceFrames makes");
  }
  return MesoTuples<3>(array, "MesoTangent");
}

/// x and y of the header.
std::array<MesoVector, 2> AxesOf(const MesoVector& tangent, const MesoVector& normal)
{
  const MesoVector x = MesoDifference(tangent, MesoScaled(normal, MesoDot(tangent, normal)));
  const double length = MesoLength(x);
  if (!(length > 1e-6 * MesoLength(tangent)))
  {
    return MesoPerpendiculars(normal);
  }
  const MesoVector unit = MesoScaled(x, 1. / length);
  return { unit, MesoCross(normal, unit) };
}

/// Depths below this are rounding: of positions by their distance from the origin, and of the
/// normal by the neighbours' distance.
double RoundingAt(const MesoVector& position, const std::vector<MesoVector>& offsets,
  double ofPositions, double ofNormals)
{
  double farthest = 0.;
  for (const MesoVector& offset : offsets)
  {
    farthest = std::max(farthest, MesoDot(offset, offset));
  }
  farthest = std::sqrt(farthest);
  return RoundingsOfDepth *
    (ofPositions * (MesoLength(position) + farthest) + ofNormals * farthest);
}
}

int vtkMesoQuadricFit::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfPointsWithout = 0;
  this->ErrorMessage = MesoFitFailure(
    "quadrics", [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoQuadricFit::Execute(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  const std::vector<MesoVector> tangents = ReadTangents(input);
  const MesoFitInput fit = MesoReadFitInput(input);
  this->UpdateProgress(0.1);
  const MesoSmoothPatches patches(fit.Mesh, this->FeatureAngle);
  MesoQuadricOptions common;
  common.Full = this->Full;
  common.Slopes = this->Slopes;
  common.Solver =
    this->NormalEquations ? MesoQuadricSolver::NormalEquations : MesoQuadricSolver::QR;
  vtkDataArray* normals = MesoFindNormals(input);
  const double ofNormals = std::max(
    fit.Mesh.PositionRounding, normals ? MesoRoundingOf(normals) : fit.Mesh.PositionRounding);
  const auto rings = static_cast<std::size_t>(this->Rings);
  const double most = fit.ArrayType() == VTK_DOUBLE ? std::numeric_limits<double>::max()
                                                    : std::numeric_limits<float>::max();

  const std::size_t points = fit.Mesh.Positions.size();
  std::vector<std::array<double, 3>> quadrics(points, { 0., 0., 0. });
  std::vector<std::array<double, 1>> conditions(points, { 0. });
  const bool done = MesoForEachFit(this, static_cast<std::int64_t>(points), 0.2, 0.95,
    [&](std::int64_t point, MesoFitSpace& space)
    {
      const std::int64_t site = patches.SiteOf(point);
      if (site < 0)
      {
        return;
      }
      MesoGatherNeighbours(patches, site, rings, 0, rings, space);
      const MesoVector& normal = fit.Normals[point];
      const std::array<MesoVector, 2> axes = AxesOf(tangents[point], normal);
      MesoQuadricOptions options = common;
      options.Rounding =
        RoundingAt(fit.Mesh.Positions[point], space.Offsets, fit.Mesh.PositionRounding, ofNormals);
      const MesoQuadric q = MesoFitQuadric(space.Offsets, axes[0], axes[1], normal, options);
      if (std::max({ std::abs(q.A), std::abs(q.B), std::abs(q.C) }) <= most)
      {
        quadrics[point] = { q.A, q.B, q.C };
        conditions[point] = { q.Condition };
      }
    });
  if (!done)
  {
    return;
  }
  for (const auto& condition : conditions)
  {
    this->NumberOfPointsWithout += condition[0] > 0. ? 0 : 1;
  }
  MesoWriteFitOutput(fit, output);
  vtkPointData* data = output->GetPointData();
  data->AddArray(MesoMakeArray("MesoQuadric", fit.ArrayType(), quadrics));
  data->AddArray(MesoMakeArray("MesoQuadricCondition", fit.ArrayType(), conditions));
}

void vtkMesoQuadricFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Full: " << (this->Full ? "On" : "Off") << "\n";
  os << indent << "Slopes: " << (this->Slopes ? "On" : "Off") << "\n";
  os << indent << "Rings: " << this->Rings << "\n";
  os << indent << "NormalEquations: " << (this->NormalEquations ? "On" : "Off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << " degrees\n";
  os << indent << "NumberOfPointsWithout: " << this->NumberOfPointsWithout << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

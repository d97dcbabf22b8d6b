#include "vtkMesoPrincipalCurvatures.h"

#include "MesoFitInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <limits>
#include <new>

vtkStandardNewMacro(vtkMesoPrincipalCurvatures);

namespace
{
struct Arrays
{
  std::vector<std::array<double, 2>> Curvatures;
  std::vector<std::array<double, 6>> Directions;
  std::vector<std::array<double, 1>> Confidences;
};

/// The pair turned into the plane at right angles to a unit normal; false where there is no such
/// pair.
bool TurnIntoPlane(const MesoVector& normal, MesoVector& first, MesoVector& second)
{
  first = MesoDifference(first, MesoScaled(normal, MesoDot(first, normal)));
  const double length = MesoLength(first);
  if (!(length > 1e-6))
  {
    return false;
  }
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    // The margin keeps rounding from choosing between components of equal size.
    largest = std::abs(first[k]) > 1.000001 * std::abs(first[largest]) ? k : largest;
  }
  first = MesoScaled(first, std::copysign(1., first[largest]) / length);
  second = MesoCross(normal, first);
  return true;
}

/// The site's curvatures as the point with this normal sees them.
void SetPoint(const MesoPrincipalCurvature& site, const MesoVector& siteNormal,
  const MesoVector& normal, double share, double most, std::size_t point, Arrays& arrays)
{
  double maximum = site.Maximum;
  double minimum = site.Minimum;
  MesoVector first = site.MaximumDirection;
  MesoVector second = site.MinimumDirection;
  if (MesoDot(siteNormal, normal) < 0.)
  {
    maximum = -site.Minimum;
    minimum = -site.Maximum;
    std::swap(first, second);
  }
  const bool fits = std::abs(maximum) <= most && std::abs(minimum) <= most;
  if (fits && TurnIntoPlane(normal, first, second))
  {
    arrays.Curvatures[point] = { maximum, minimum };
    arrays.Directions[point] = { first[0], first[1], first[2], second[0], second[1], second[2] };
    arrays.Confidences[point] = { share * site.Confidence };
  }
}
}

int vtkMesoPrincipalCurvatures::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfPointsWithout = 0;
  this->ErrorMessage = MesoFitFailure(
    "curvatures", [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoPrincipalCurvatures::Execute(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  const MesoFitInput fit = MesoReadFitInput(input);
  this->UpdateProgress(0.1);
  const MesoSmoothPatches patches(fit.Mesh, this->FeatureAngle);
  std::vector<MesoPrincipalCurvature> sites(patches.NumberOfSites());
  const bool done = MesoForEachFit(this, patches.NumberOfSites(), 0.2, 0.95,
    [&](std::int64_t site, MesoFitSpace& space)
    { sites[site] = MesoFitSiteCurvature(patches, site, space); });
  if (!done)
  {
    return;
  }

  const std::size_t points = fit.Mesh.Positions.size();
  const double most = fit.ArrayType() == VTK_DOUBLE ? std::numeric_limits<double>::max()
                                                    : std::numeric_limits<float>::max();
  Arrays arrays;
  arrays.Curvatures.assign(points, { 0., 0. });
  arrays.Directions.assign(points, { 0., 0., 0., 0., 0., 0. });
  arrays.Confidences.assign(points, { 0. });
  for (std::size_t i = 0; i < points; ++i)
  {
    const std::int64_t site = patches.SiteOf(static_cast<std::int64_t>(i));
    if (site >= 0 && sites[site].Degree > 0)
    {
      SetPoint(sites[site], patches.NormalOf(site), fit.Normals[i],
        patches.ShareOf(static_cast<std::int64_t>(i)), most, i, arrays);
    }
    this->NumberOfPointsWithout += arrays.Confidences[i][0] > 0. ? 0 : 1;
  }
  MesoWriteFitOutput(fit, output);
  vtkPointData* data = output->GetPointData();
  const int type = fit.ArrayType();
  data->AddArray(MesoMakeArray("MesoCurvature", type, arrays.Curvatures));
  data->AddArray(MesoMakeArray("MesoPrincipalDirections", type, arrays.Directions));
  data->AddArray(MesoMakeArray("MesoCurvatureConfidence", type, arrays.Confidences));
}

void vtkMesoPrincipalCurvatures::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << " degrees\n";
  os << indent << "NumberOfPointsWithout: " << this->NumberOfPointsWithout << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

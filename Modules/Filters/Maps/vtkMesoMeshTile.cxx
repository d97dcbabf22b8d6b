#include "vtkMesoMeshTile.h"

#include "MesoDistanceTransform.h"
#include "MesoMeshVoxels.h"
#include "MesoVolumePattern.h" // for MesoVolumeMaximumSize
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkMesoMeshTile);

void vtkMesoMeshTile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Box:";
  for (const double side : this->Box)
  {
    os << " " << side;
  }
  os << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << " " << this->Size[2] << "\n";
}

int vtkMesoMeshTile::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMesoMeshTile::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, this->Size[2] - 1 };
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkMesoMeshTile::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  const auto [fewest, most] = std::minmax({ this->Size[0], this->Size[1], this->Size[2] });
  if (fewest < 2 || most > MesoVolumeMaximumSize || mesh->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro(
      "there are no triangles, or a side is not of 2 to " << MesoVolumeMaximumSize << " voxels");
    return 1;
  }
  double box[6];
  mesh->GetBounds(box);
  if (this->Box[0] < this->Box[1])
  {
    std::copy(this->Box, this->Box + 6, box);
  }
  const double width[3] = { box[1] - box[0], box[3] - box[2], box[5] - box[4] };
  if (!(std::min({ width[0], width[1], width[2] }) > 0.) ||
    !std::isfinite(width[0] + width[1] + width[2]))
  {
    vtkErrorMacro("the tile's box has no volume");
    return 1;
  }
  const double depth = width[2] / width[0];
  const double scale[3] = { 1. / width[0], 1. / width[1], 1. / width[0] };
  const std::array<int, 3> size = { this->Size[0], this->Size[1], this->Size[2] };
  MesoMeshVoxels voxels(size, depth);
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(count, points);
    MesoMeshVoxels::Triangle triangle;
    for (vtkIdType corner = 0; corner + 2 < count; ++corner) // a fan, of more corners than three
    {
      const vtkIdType corners[3] = { points[0], points[corner + 1], points[corner + 2] };
      for (int c = 0; c < 3; ++c)
      {
        double position[3];
        mesh->GetPoint(corners[c], position);
        for (int axis = 0; axis < 3; ++axis)
        {
          triangle[c][axis] = (position[axis] - box[2 * axis]) * scale[axis];
        }
      }
      voxels.Add(triangle);
    }
  }
  std::vector<float> distances = voxels.Finish();
  if (std::none_of(distances.begin(), distances.end(), [](float d) { return d < 0.f; }))
  {
    vtkErrorMacro("nothing in the tile is solid: the mesh is inside out, thinner than voxels, or "
                  "outside of the box");
    return 1;
  }
  const auto volume = MesoCanonicalVolume(MesoVolumeField(size, depth, std::move(distances)), this);
  if (volume)
  {
    output->ShallowCopy(volume);
  }
  return 1;
}

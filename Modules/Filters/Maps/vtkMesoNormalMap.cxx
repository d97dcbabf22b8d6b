#include "vtkMesoNormalMap.h"

#include "MesoKernels.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkMesoNormalMap);

void vtkMesoNormalMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "TileSize: " << this->TileSize[0] << " " << this->TileSize[1] << "\n";
}

void vtkMesoNormalMap::Compute(const Map& map, vtkImageData* output)
{
  if (!(this->TileSize[0] > 0.) || !(this->TileSize[1] > 0.))
  {
    vtkErrorMacro("A tile of " << this->TileSize[0] << " x " << this->TileSize[1]
                               << " is no tile: both must be above 0");
    output->Initialize();
    return;
  }
  const MesoKernels::Double::HeightField field(map.Width, map.Height, this->GetWrap(), map.Heights);
  const glm::dvec2 perTile(this->Scale / this->TileSize[0], this->Scale / this->TileSize[1]);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normal");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(output->GetNumberOfPoints());
  this->ForRows(map.Height,
    [&](int first, int end)
    {
      for (int row = first; row < end; ++row)
      {
        for (int column = 0; column < map.Width; ++column)
        {
          const glm::dvec2 center((column + 0.5) / map.Width, (row + 0.5) / map.Height);
          const glm::dvec2 slope = perTile * field.heightGradient(center);
          const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 1.));
          float* tuple = normals->GetPointer(3 * (vtkIdType(row) * map.Width + column));
          for (int i = 0; i < 3; ++i)
          {
            tuple[i] = static_cast<float>(normal[i]);
          }
        }
      }
    });
  output->GetPointData()->SetScalars(normals);
}

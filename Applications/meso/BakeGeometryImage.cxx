#include "BakeGeometryImage.h"

#include "MesoAlgorithmRun.h"
#include "MesoBakedFile.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGeometryImage.h"
#include "vtkMesoMeshReader.h"
#include "vtkMesoSurfaceFrames.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>

void BakeGeometryImage::AddOptions(CLI::App& command)
{
  command.description("A mesh as an image of its positions and normals, in levels of detail.");
  command.add_option("MESH", this->MeshFile, "Mesh whose texture coordinates are an atlas")
    ->required();
  this->Output.AddOptions(command, "Baked file to write (.vti)");
  command.add_option("--size", this->Size, "Texels along each side (default: 256)")
    ->check(CLI::Range(vtkMesoGeometryImage::SmallestSize, 4096));
  command.footer("Example: meso bake geometry-image spot.obj -o spot.geometry.vti --size 512");
}

void BakeGeometryImage::Run()
{
  this->Output.Check({ this->MeshFile });
  std::vector<std::string> warnings;
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(this->MeshFile.c_str());
  MesoRunAlgorithm(reader, this->MeshFile, warnings);
  if (!reader->GetOutput()->GetPointData()->GetTCoords())
  {
    throw MesoInputError(this->MeshFile +
      ": has no texture coordinates, over which the image is laid: unwrap it first (an atlas in "
      "[0,1] x [0,1])");
  }
  vtkNew<vtkMesoSurfaceFrames> frames; // normals as they are drawn
  frames->SetInputConnection(reader->GetOutputPort());
  MesoRunAlgorithm(frames, this->MeshFile, warnings);
  vtkNew<vtkMesoGeometryImage> image;
  image->SetInputConnection(frames->GetOutputPort());
  image->SetSize(this->Size);
  this->Output.Update(image);

  MesoBaked baked;
  baked.Kind = this->GetName();
  baked.Parameters["size"] = std::vector<double>{ double(this->Size) };
  baked.Table = image->GetOutput();
  MesoWriteBaked(this->Output.GetFileName(), baked);

  double bounds[6];
  frames->GetOutput()->GetBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  std::cout << image->GetNumberOfCharts() << " charts, " << image->GetNumberOfOverlaps()
            << " texels under several triangles\n"
            << "the mesh's points lie off each level, in percent of its diagonal:\n";
  vtkDataArray* levels = image->GetOutput()->GetFieldData()->GetArray("MesoLevels");
  for (vtkIdType i = 0; i < levels->GetNumberOfTuples(); ++i)
  {
    std::cout << levels->GetComponent(i, 0) << ": mean square root "
              << 100. * levels->GetComponent(i, 2) / diagonal << ", largest "
              << 100. * levels->GetComponent(i, 3) / diagonal << "\n";
  }
  this->Output.WriteStats(this->GetName(), baked.Table);
}

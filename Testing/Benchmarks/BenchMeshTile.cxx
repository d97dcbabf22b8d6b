// What it costs a table of distances that a mesh is made voxels first: its numbers against rays cast on the mesh itself
// and on its copies in the tiles around it, by Embree.
//
//   BenchMeshTile   a ring in a tile of 1 x 1 x 0.3, as rows of a table in Markdown

#include "MesoGDMSweep.h"
#include "MesoRayScene.h"
#include "MesoVolume.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkImageData.h"
#include "vtkMesoMeshTile.h"
#include "vtkMesoShapeSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double Depth = 0.3;
constexpr double Reach = 3.;

/// The nearest triangle on a ray's way.
class FirstTriangle : public MesoRayQuery
{
public:
  bool IsFront = true;
  bool IsHit = false;

  void Test(int, unsigned int) override {}
  bool TestTriangle(int, unsigned int, double t, bool front) override
  {
    if (t <= this->TMin || t >= this->TMax)
    {
      return false;
    }
    this->TMax = t;
    this->IsFront = front;
    this->IsHit = true;
    return true;
  }
};

/// The mesh and its copies as far as rays go; tile widths, the tile's corner at 0.
void AddTiles(vtkPolyData* mesh, MesoRayScene& scene)
{
  constexpr int around = 4;
  for (int tile = 0; tile < (2 * around + 1) * (2 * around + 1); ++tile)
  {
    const double shift[2] = { double(tile % (2 * around + 1) - around) + 0.5,
      double(tile / (2 * around + 1) - around) + 0.5 };
    std::vector<glm::dvec3> points;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      points.emplace_back(p[0] + shift[0], p[1] + shift[1], p[2] + 0.5 * Depth);
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCurrentCell(count, corners);
      triangles.push_back({ static_cast<std::uint32_t>(corners[0]),
        static_cast<std::uint32_t>(corners[1]), static_cast<std::uint32_t>(corners[2]) });
    }
    scene.AddTriangles(points, std::move(triangles));
  }
  scene.Commit();
}

/// The table's definition, on the mesh.
double OnMesh(const MesoRayScene& scene, const MesoVolumeField::Vector& origin,
  const MesoVolumeField::Vector& direction, bool& isHit)
{
  FirstTriangle query;
  query.Origin = { origin[0], origin[1], Depth * origin[2] };
  query.Direction = { direction[0], direction[1], direction[2] };
  query.TMax = std::min(Reach, MesoVolumeRay::ToPlane(origin[2], direction[2], Depth));
  scene.Trace(query);
  isHit = query.IsHit;
  return query.IsHit && !query.IsFront ? 0. : query.TMax; // a back is seen from within
}

void Report(vtkPolyData* mesh, const MesoRayScene& scene, int side)
{
  vtkNew<vtkMesoMeshTile> tile;
  tile->SetInputData(mesh);
  tile->SetBox(-0.5, 0.5, -0.5, 0.5, -0.5 * Depth, 0.5 * Depth);
  tile->SetSize(side, side, side / 2);
  tile->Update();
  const MesoVolumeField field(tile->GetOutput());
  const MesoGDMSweep sweep(field, Reach);
  const MesoVolumeRay caster(field);
  const auto& size = field.GetSize();
  const MesoGDMDirections directions;
  std::vector<double> errors;
  double squares = 0.;
  std::size_t lost = 0;
  std::size_t hits = 0;
  std::size_t swept = 0;
  std::size_t sweptOff = 0;
  const double voxel = 1. / side;
  for (int azimuth = 0; azimuth < directions.Azimuths; azimuth += 5)
  {
    for (int polar = 1; polar < directions.Polars; polar += 4)
    {
      const auto direction = directions.At(azimuth, polar);
      std::vector<float> numbers(std::size_t(size[0]) * size[1] * size[2]);
      sweep.Sweep(direction, numbers.data(), size[2]);
      const int step = side / 16; // the same number of rays at every size
      for (int j = 0; j < size[1]; j += step)
      {
        for (int i = 0; i < size[0]; i += step)
        {
          for (int k = 0; k < size[2]; k += step)
          {
            const MesoVolumeField::Vector origin = { (i + 0.5) / size[0], (j + 0.5) / size[1],
              double(k) / (size[2] - 1) };
            bool isHit = false;
            const double truth = OnMesh(scene, origin, direction, isHit);
            if (!isHit)
            {
              continue;
            }
            const auto voxels = caster.Cast(origin, direction, Reach);
            ++hits;
            lost += !voxels.IsHit;
            if (voxels.IsHit)
            {
              errors.push_back(std::abs(voxels.Distance - truth));
              squares += errors.back() * errors.back();
            }
            ++swept;
            sweptOff +=
              std::abs(numbers[(std::size_t(j) * size[0] + i) * size[2] + k] - truth) > voxel;
          }
        }
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  std::printf("| %dx%dx%d | %.5f | %.4f | %.3f | %.4f | %.2f %% | %.2f %% |\n", side, side,
    side / 2, errors[errors.size() / 2], errors[errors.size() * 19 / 20],
    errors[errors.size() / 2] / voxel, std::sqrt(squares / double(errors.size())),
    100. * double(lost) / double(hits), 100. * double(sweptOff) / double(swept));
  std::fflush(stdout);
}
}

int main()
{
  vtkNew<vtkMesoShapeSource> ring;
  ring->SetShape("torus");
  ring->SetParameter("radius", { 0.3 });
  ring->SetParameter("tube", { 0.1 });
  ring->SetParameter("rings", { 96. });
  ring->SetParameter("sides", { 48. });
  ring->Update();
  MesoRayScene scene;
  AddTiles(ring->GetOutput(), scene);
  std::printf(
    "| voxels | median, tile widths | p95 | median, voxels | RMS | hits lost | of the swept "
    "table further off than a voxel |\n");
  for (const int side : { 16, 32, 64, 128 })
  {
    Report(ring->GetOutput(), scene, side);
  }
  return 0;
}

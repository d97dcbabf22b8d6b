// What tables of distances through volumes are worth: the error of look-ups at random places and directions, against
// rays that are followed exactly, by rank, bits and directions, with the bytes that a renderer holds.
//
//   BenchGDMTable [PATTERN]   64 x 64 x 32, as rows of a table in Markdown

#include "MesoGDMShape.h"
#include "MesoGDMSweep.h"
#include "MesoKernels.h"
#include "MesoVolume.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoGDMTable.h"
#include "vtkMesoVolumeSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace
{
using Factors = MesoKernels::Float::GDMFactors;
using Whole = MesoKernels::Float::GDMWhole;

/// Of the table, or of its first `rank` products.
template <typename Kernel>
Kernel KernelOf(vtkImageData* table, int rank)
{
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  vtkDataArray* scalars = table->GetPointData()->GetScalars();
  vtkDataArray* range = table->GetFieldData()->GetArray("MesoGDMWeightRange");
  vtkDataArray* functions = table->GetFieldData()->GetArray("MesoGDMFunctions");
  const int components = scalars->GetNumberOfComponents();
  const int bytes = scalars->GetDataTypeSize();
  const double steps = bytes == 1 ? 255. : bytes == 2 ? 65535. : 1.;
  const int padded = shape.Rank > 0 ? (components + 3) / 4 * 4 : components;
  std::vector<float> numbers(std::size_t(scalars->GetNumberOfTuples()) * padded, 0.f);
  for (vtkIdType row = 0; row < scalars->GetNumberOfTuples(); ++row)
  {
    for (int c = 0; c < components; ++c)
    {
      const double least = range ? range->GetComponent(0, c) : 0.;
      const double most = range ? range->GetComponent(1, c) : steps > 1. ? shape.Reach : 1.;
      numbers[row * padded + c] =
        static_cast<float>(least + (most - least) * scalars->GetComponent(row, c) / steps);
    }
  }
  std::vector<float> columns;
  for (vtkIdType column = 0; functions && column < functions->GetNumberOfTuples(); ++column)
  {
    for (int c = 0; c < padded; ++c)
    {
      columns.push_back(c < std::min(components, rank)
          ? static_cast<float>(functions->GetComponent(column, c))
          : 0.f);
    }
  }
  return Kernel({ shape.Size[0], shape.Size[1], shape.Size[2] }, { shape.Azimuths, shape.Polars },
    shape.Even, shape.Rank > 0 ? padded : 0, std::move(numbers), std::move(columns));
}

struct Ray
{
  MesoVolumeField::Vector Origin;
  MesoVolumeField::Vector Direction;
  double Distance;
  bool IsHit;
};

std::vector<Ray> RandomRays(const MesoVolumeField& field, double reach)
{
  std::mt19937 random(1);
  const auto uniform = [&]() { return double(random()) / double(std::mt19937::max()); };
  const MesoVolumeRay caster(field);
  std::vector<Ray> rays;
  while (rays.size() < 20000)
  {
    // As they come into the shell: half of them through a plane, half through fins.
    const bool isPlane = rays.size() % 2 == 0;
    const double z = 2. * uniform() - 1.;
    const double phi = 2. * std::acos(-1.) * uniform();
    const double s = std::sqrt(1. - z * z);
    Ray ray;
    ray.Direction = { s * std::cos(phi), s * std::sin(phi), z };
    ray.Origin = { uniform(), uniform(), isPlane ? (z < 0. ? 1. : 0.) : uniform() };
    const auto hit = caster.Cast(ray.Origin, ray.Direction, reach);
    if (hit.Distance > 0.)
    {
      ray.Distance = hit.Distance;
      ray.IsHit = hit.IsHit;
      rays.push_back(ray);
    }
  }
  return rays;
}

template <typename Kernel>
void Report(const char* name, const Kernel& kernel, const std::vector<Ray>& rays,
  const MesoVolumeField& field, double megabytes, double seconds)
{
  std::vector<double> errors;
  int lost = 0;
  int found = 0;
  const double voxel = 1. / field.GetSize()[0];
  for (const Ray& ray : rays)
  {
    const double d =
      kernel.gdmDistance({ float(ray.Origin[0]), float(ray.Origin[1]), float(ray.Origin[2]) },
        { float(ray.Direction[0]), float(ray.Direction[1]), float(ray.Direction[2]) });
    // What the volume says where the table ends: within a voxel of the solid it is a hit.
    const double end =
      std::min(d, MesoVolumeRay::ToPlane(ray.Origin[2], ray.Direction[2], field.GetDepth()));
    const bool saysHit =
      field.At({ ray.Origin[0] + end * ray.Direction[0], ray.Origin[1] + end * ray.Direction[1],
        ray.Origin[2] + end * ray.Direction[2] / field.GetDepth() }) < voxel;
    if (ray.IsHit)
    {
      errors.push_back(std::abs(d - ray.Distance));
      lost += !saysHit;
    }
    else
    {
      found += saysHit;
    }
  }
  std::sort(errors.begin(), errors.end());
  double squares = 0.;
  for (const double error : errors)
  {
    squares += error * error;
  }
  const double misses = double(rays.size() - errors.size());
  const double hits = double(errors.size());
  std::printf("| %s | %.2f | %.4f | %.4f | %.4f | %.1f %% | %.1f %% | %.1f |\n", name, megabytes,
    errors[errors.size() / 2], errors[errors.size() * 9 / 10], std::sqrt(squares / hits),
    100. * lost / hits, misses > 0. ? 100. * found / misses : 0., seconds);
  std::fflush(stdout);
}

/// Bakes once, and reports the ranks that are given; none: the whole table.
void Run(vtkImageData* volume, const char* name, const std::vector<int>& ranks, int bits, bool even,
  const std::vector<Ray>& rays)
{
  const MesoVolumeField field(volume);
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(volume);
  table->SetRank(ranks.empty() ? 0 : ranks.back());
  table->SetBits(bits);
  table->SetEven(even);
  const auto start = std::chrono::steady_clock::now();
  table->Update();
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  vtkImageData* image = table->GetOutput();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkDataArray* functions = image->GetFieldData()->GetArray("MesoGDMFunctions");
  constexpr double mebibyte = 1048576.;
  const double bytes = double(scalars->GetNumberOfValues()) * scalars->GetDataTypeSize() +
    (functions ? 4. * double(functions->GetNumberOfValues()) : 0.);
  if (ranks.empty())
  {
    Report(name, KernelOf<Whole>(image, 0), rays, field, bytes / mebibyte, seconds);
  }
  for (const int rank : ranks)
  {
    const std::string line = std::to_string(rank) + name;
    Report(line.c_str(), KernelOf<Factors>(image, rank), rays, field,
      bytes * rank / ranks.back() / mebibyte, seconds);
  }
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMesoVolumeSource> source;
  source->SetPattern(argc > 1 ? argv[1] : "weave");
  source->Update();
  vtkImageData* volume = source->GetOutput();
  const std::vector<Ray> rays = RandomRays(MesoVolumeField(volume), 8.);
  std::printf("| table | MiB | median | p90 | RMS | hits lost | hits found | bake, s |\n");
  Run(volume, " products, 16 bit", { 4, 8, 16, 32 }, 16, false, rays);
  Run(volume, " products, 8 bit", { 16, 32 }, 8, false, rays);
  Run(volume, " products, 16 bit, even over the sphere", { 16 }, 16, true, rays);
  Run(volume, "whole, 16 bit", {}, 16, false, rays);
  return 0;
}

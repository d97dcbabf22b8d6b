#ifndef ReferenceWorld_h
#define ReferenceWorld_h

/**
 * @file ReferenceWorld.h
 * @brief A scene's true surfaces and rays against them in double, for tests of the reference.
 */

#include "MesoReference.h"
#include "MesoReferenceTracer.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

/// Text of a scene: `rest` is what it has beside "meso".
inline MesoScene SceneOf(const std::string& rest)
{
  return MesoParseScene(R"({"meso": 1, )" + rest + "}", "test.json");
}

/// Heights from a function of column and row.
inline vtkSmartPointer<vtkImageData> HeightsOf(
  int width, int height, const std::function<double(int, int)>& heightAt)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* next = static_cast<float*>(image->GetScalarPointer());
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      *next++ = static_cast<float>(heightAt(column, row));
    }
  }
  return image;
}

/// The surfaces of a scene, without camera or light; a map can take the place of the scene's.
class ReferenceWorld
{
public:
  explicit ReferenceWorld(const std::string& nodes, bool smooth = false, double facetsPerTexel = 0.,
    vtkImageData* heights = nullptr)
  {
    const MesoScene scene = SceneOf(R"("nodes": )" + nodes);
    MesoSceneBuilder builder;
    builder.Build(scene, this->Renderer);
    for (MesoSceneBuilder::Object object : builder.GetObjects())
    {
      if (heights)
      {
        object.HeightMap = heights;
      }
      this->Surfaces.push_back(std::make_unique<MesoReferenceSurface>(
        object, *scene.Nodes[object.Number - 1].Mesh, smooth));
    }
    this->Tracer = std::make_unique<MesoReferenceTracer>(this->Surfaces, facetsPerTexel);
  }

  /// Where a ray hits; NaN where it does not.
  double T(const glm::dvec3& origin, const glm::dvec3& direction)
  {
    MesoReferenceTracer::Ray ray;
    ray.Origin = origin;
    ray.Direction = direction;
    ray.TMax = std::numeric_limits<double>::infinity();
    return this->Tracer->Trace(ray, this->Hit, this->Work)
      ? this->Hit.T
      : std::numeric_limits<double>::quiet_NaN();
  }

  vtkNew<vtkRenderer> Renderer;
  std::vector<std::unique_ptr<MesoReferenceSurface>> Surfaces;
  std::unique_ptr<MesoReferenceTracer> Tracer;
  MesoReferenceHit Hit;
  MesoTraceWork Work;
};

/// Random numbers from a fixed seed.
class RandomNumbers
{
public:
  explicit RandomNumbers(unsigned int seed)
    : Engine(seed)
  {
  }
  double In(double low, double high)
  {
    // Not std::uniform_real_distribution, whose numbers differ between libraries.
    return low + (high - low) * (static_cast<double>(this->Engine()) / 4294967296.);
  }
  glm::dvec3 Direction()
  {
    for (;;)
    {
      const glm::dvec3 v(this->In(-1., 1.), this->In(-1., 1.), this->In(-1., 1.));
      const double square = glm::dot(v, v);
      if (square > 0.01 && square < 1.)
      {
        return v / std::sqrt(square);
      }
    }
  }

private:
  std::mt19937 Engine;
};

/// A channel's value at a pixel of a result's AOVs; row 0 is the top.
inline double ValueAt(const MesoExrImage& image, const std::string& channel, int column, int row)
{
  const auto place = std::find(image.ChannelNames.begin(), image.ChannelNames.end(), channel);
  return place == image.ChannelNames.end()
    ? std::numeric_limits<double>::quiet_NaN()
    : static_cast<double>(image.At(column, row, place - image.ChannelNames.begin()));
}

/// The value below which a part of the numbers lies.
inline double Percentile(std::vector<double> values, double part)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * (values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

#endif

#ifndef DicedMeshes_h
#define DicedMeshes_h

#include "SurfaceArrays.h"

#include "MesoHeightTexture.h"
#include "MesoPattern.h"
#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoShapeSource.h"

#include "vtkImageData.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>

/// A height map with height(i, j) at texel (i, j).
inline vtkSmartPointer<vtkImageData> MakeMap(
  int width, int height, const std::function<double(int, int)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* texel = static_cast<float*>(image->GetScalarPointer());
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      *texel++ = static_cast<float>(value(i, j));
    }
  }
  return image;
}

inline vtkSmartPointer<vtkImageData> ConstantMap(double height)
{
  return MakeMap(4, 4, [height](int, int) { return height; });
}

inline vtkSmartPointer<vtkImageData> PatternMap(const std::string& name, int size)
{
  const std::vector<float> heights = MesoMakePattern(name, { size, size }, 1);
  return MakeMap(size, size, [&](int i, int j) { return heights[std::size_t(j) * size + i]; });
}

/// The map as it is read between its texels, apart from the kernels.
inline MesoHeightTexture<double> TextureOf(vtkImageData* map, MesoWrap wrap)
{
  const int* size = map->GetDimensions();
  const auto* texels = static_cast<const float*>(map->GetScalarPointer());
  return { size[0], size[1], wrap, std::vector<float>(texels, texels + size[0] * size[1]) };
}

inline vtkSmartPointer<vtkPolyData> ShapeMesh(const std::string& name,
  const std::map<std::string, std::vector<double>>& parameters,
  int precision = vtkAlgorithm::DOUBLE_PRECISION)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape(name.c_str());
  source->SetOutputPointsPrecision(precision);
  for (const auto& parameter : parameters)
  {
    source->SetParameter(parameter.first, parameter.second);
  }
  source->Update();
  return source->GetOutput();
}

/// The edges of a mesh, points of exactly one position being one (unless points are to be told apart
/// by number), and how many of them have other than one triangle in each direction.
struct MergedEdges
{
  int Wrong = 0;
  int Edges = 0;

  explicit MergedEdges(vtkPolyData* mesh, bool merge = true)
  {
    std::map<MesoVector, int> known;
    std::vector<int> merged;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const MesoVector p = PositionOf(mesh, i);
      const int first = known.emplace(p, static_cast<int>(known.size())).first->second;
      merged.push_back(merge ? first : static_cast<int>(i));
    }
    std::map<std::pair<int, int>, std::array<int, 2>> edges;
    for (const auto& triangle : TrianglesOf(mesh))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = merged[triangle[k]];
        const int b = merged[triangle[(k + 1) % 3]];
        ++edges[std::minmax(a, b)][a < b ? 0 : 1];
      }
    }
    for (const auto& edge : edges)
    {
      this->Wrong += edge.second == std::array<int, 2>{ 1, 1 } ? 0 : 1;
    }
    this->Edges = static_cast<int>(edges.size());
  }
};

#endif

#ifndef BakeFromMesh_h
#define BakeFromMesh_h

#include "BakeKind.h"

#include <utility>
#include <vector>

class vtkMesoMapFromMesh;
class vtkPolyData;

/// `meso bake from-mesh`: the maps that make a coarse mesh look like a detailed one.
class BakeFromMesh : public BakeKind
{
public:
  const char* GetName() const override { return "from-mesh"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  /// How displacements become heights in [0,1]: D = High - Low, and r = -Low / D.
  struct Range
  {
    double Low;
    double High;
  };

  vtkSmartPointer<vtkPolyData> ReadBase() const;
  vtkSmartPointer<vtkPolyData> ReadDetail() const;
  void WriteHeights(vtkImageData* maps, const Range& range) const;
  void Report(vtkMesoMapFromMesh* maps, const Range& range) const;

  std::string DetailFile;
  std::string BaseFile;
  BakeOutput Output;
  std::array<int, 2> Size = { 1024, 1024 };
  int Bits = 16;
  double Reach = 0.;
  double SlopeLimit = 8.;
  std::optional<double> FeatureAngle;
  bool ByTexture = false;
  bool GeometricNormals = false;
  bool Json = false;
  std::string NormalFile;
  std::string NormalObjectFile;
  std::string CurvatureFile;
  std::string StateFile;
  std::vector<std::pair<std::string, std::string>> Arrays; ///< of the detail, each with its file
};

#endif

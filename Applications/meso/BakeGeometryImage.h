#ifndef BakeGeometryImage_h
#define BakeGeometryImage_h

#include "BakeKind.h"

/// `meso bake geometry-image`: a mesh as an image of its positions and normals.
class BakeGeometryImage : public BakeKind
{
public:
  const char* GetName() const override { return "geometry-image"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  std::string MeshFile;
  BakeOutput Output;
  int Size = 256;
};

#endif

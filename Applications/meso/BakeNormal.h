#ifndef BakeNormal_h
#define BakeNormal_h

#include "BakeKind.h"

/// `meso bake normal`: a height map becomes a normal map in tangent space, an image.
class BakeNormal : public BakeKind
{
public:
  const char* GetName() const override { return "normal"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  BakeInput Input;
  BakeOutput Output;
  double Scale = 0.1;
  std::array<double, 2> TileSize = { 1., 1. };
  bool IsYDown = false;
  int Bits = 8;
};

#endif

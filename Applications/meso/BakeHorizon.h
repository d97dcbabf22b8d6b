#ifndef BakeHorizon_h
#define BakeHorizon_h

#include "BakeKind.h"

/// `meso bake horizon`: a height map's horizons and ambient occlusion, a baked file.
class BakeHorizon : public BakeKind
{
public:
  const char* GetName() const override { return "horizon"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  BakeInput Input;
  BakeOutput Output;
  int Azimuths = 32;
  double Scale = 0.1;
  double Reach = 2.;
};

#endif

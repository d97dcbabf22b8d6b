#ifndef BakeGDM_h
#define BakeGDM_h

#include "BakeKind.h"
#include "BakeVolume.h"

/// `meso bake gdm`: the distances through a volume as a baked file (vtkMesoGDMTable).
class BakeGDM : public BakeKind
{
public:
  const char* GetName() const override { return "gdm"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  BakeVolume Volume;
  std::array<int, 2> Directions = { 16, 32 };
  bool Even = false;
  bool Exact = false;
  bool Cautious = false;
  double Reach = 8.;
  int Rank = 16;
  int Bits = 16;
  bool Json = false;
  BakeOutput Output;
};

#endif

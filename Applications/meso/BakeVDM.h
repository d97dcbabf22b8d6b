#ifndef BakeVDM_h
#define BakeVDM_h

#include "BakeKind.h"
#include "MesoVDMTable.h"

class vtkMesoVDM;

/// `meso bake vdm`: a height map's view-dependent displacements, a baked file.
class BakeVDM : public BakeKind
{
public:
  const char* GetName() const override { return "vdm"; }
  void AddOptions(CLI::App& command) override;
  void Run() override;

private:
  void WriteStats(vtkMesoVDM* filter, int taken) const;

  BakeInput Input;
  BakeOutput Output;
  MesoVDMLayout Layout;
  MesoVDMCurved Curved = MesoVDMCurved::Exact;
  std::array<int, 2> Ranks = { 8, 4 };
  int Bits = 8;
  double Patience = 10.; ///< seconds after which what is finished is kept
};

#endif

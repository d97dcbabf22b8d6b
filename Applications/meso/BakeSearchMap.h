#ifndef BakeSearchMap_h
#define BakeSearchMap_h

#include "BakeKind.h"

#include <vector>

class vtkMesoHeightMapAlgorithm;

/// A kind that runs one filter over a height map and keeps all that it gives in a baked file.
class BakeSearchMap : public BakeKind
{
public:
  void AddOptions(CLI::App& command) override;
  void Run() override;

protected:
  virtual const char* GetDescription() const = 0;
  virtual vtkSmartPointer<vtkMesoHeightMapAlgorithm> MakeFilter() const = 0;

private:
  BakeInput Input;
  BakeOutput Output;
};

/// `meso bake cone`: the cones of free space by which searches of a height map take long steps.
class BakeCone : public BakeSearchMap
{
public:
  const char* GetName() const override { return "cone"; }

protected:
  const char* GetDescription() const override;
  vtkSmartPointer<vtkMesoHeightMapAlgorithm> MakeFilter() const override;
};

/// `meso bake maxmip`: the pyramid of a height map's maxima.
class BakeMaximumMip : public BakeSearchMap
{
public:
  const char* GetName() const override { return "maxmip"; }

protected:
  const char* GetDescription() const override;
  vtkSmartPointer<vtkMesoHeightMapAlgorithm> MakeFilter() const override;
};

#endif

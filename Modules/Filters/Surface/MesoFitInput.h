#ifndef MesoFitInput_h
#define MesoFitInput_h

/**
 * @file MesoFitInput.h
 * @brief What the filters that fit to a mesh's vertices have in common.
 */

#include "MesoPolyDataInput.h"
#include "MesoSiteFits.h"

#include "vtkAlgorithm.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>

/// The input as triangles with a normal each point. Output and arrays have the input's points.
struct MesoFitInput
{
  MesoTriangleMesh Mesh;
  std::vector<MesoVector> Normals; ///< a point each, unit
  bool NormalsAreMade = false;
  vtkSmartPointer<vtkPolyData> Triangles;

  int ArrayType() const
  {
    return this->Triangles->GetPoints()->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  }
};

/// Throws std::invalid_argument with the filter's message. The input has points.
MesoFitInput MesoReadFitInput(vtkPolyData* input);

/// The input's points, triangles and data, with Normals and MesoVertex.
void MesoWriteFitOutput(const MesoFitInput& input, vtkPolyData* output);

/// Runs a filter's work. Returns what it failed by, or an empty text; `what` names its result.
template <typename Work>
std::string MesoFitFailure(const char* what, const Work& work)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    return std::string("there is not enough memory for the ") + what + " of this mesh";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

/// Calls work(i, space) for 0 <= i < size in parallel; progress runs from `from` to `to`. False
/// where the algorithm was aborted.
template <typename Work>
bool MesoForEachFit(
  vtkAlgorithm* algorithm, std::int64_t size, double from, double to, const Work& work)
{
  constexpr std::int64_t steps = 20;
  vtkSMPThreadLocal<MesoFitSpace> spaces;
  for (std::int64_t step = 0; step < steps; ++step)
  {
    algorithm->UpdateProgress(from + (to - from) * static_cast<double>(step) / steps);
    if (algorithm->GetAbortExecute())
    {
      return false;
    }
    vtkSMPTools::For(step * size / steps, (step + 1) * size / steps,
      [&](vtkIdType first, vtkIdType last)
      {
        MesoFitSpace& space = spaces.Local();
        for (vtkIdType i = first; i < last; ++i)
        {
          work(i, space);
        }
      });
  }
  return true;
}

#endif

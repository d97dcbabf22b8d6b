#include "MesoVDMTable.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <string>

namespace
{
/// Finds the first thing that is wrong, and says nothing about others.
class Check
{
public:
  void Size(vtkDataArray* array, const std::string& name, int components, vtkIdType tuples)
  {
    if (!array)
    {
      this->Fail("it has no " + name);
    }
    else if (array->GetNumberOfTuples() != tuples ||
      (components > 0 && array->GetNumberOfComponents() != components))
    {
      this->Fail("its " + name + " is not of the table's size");
    }
  }

  void Numbers(vtkDataArray* array, const std::string& name, double least, double largest)
  {
    const int components = this->Reason.empty() ? array->GetNumberOfComponents() : 0;
    for (vtkIdType i = 0; components > 0 && i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < components; ++k)
      {
        const double number = array->GetComponent(i, k);
        if (!(number >= least && number <= largest))
        {
          this->Fail("its " + name + " holds " + std::to_string(number) + " at " +
            std::to_string(i * components + k));
          return;
        }
      }
    }
  }

  void Fail(const std::string& reason)
  {
    if (this->Reason.empty())
    {
      this->Reason = reason;
    }
  }

  std::string Reason;
};

/// Numbers of functions and weights are of the order of a table's, whose rows are few millions.
constexpr double Huge = 1e9;

void CheckFactors(vtkImageData* table, const MesoVDMLayout& layout, Check& check)
{
  vtkFieldData* data = table->GetFieldData();
  vtkDataArray* weights = table->GetPointData()->GetScalars();
  const int rank = weights ? weights->GetNumberOfComponents() : 0;
  check.Size(weights, "Weights", 0, static_cast<vtkIdType>(layout.Rows()));
  if (weights && weights->GetDataType() != VTK_UNSIGNED_CHAR &&
    weights->GetDataType() != VTK_UNSIGNED_SHORT)
  {
    check.Fail("its weights are not of 8 or 16 bits");
  }
  const struct
  {
    const char* Name;
    vtkIdType Tuples;
    double Least;
    bool OfFactors; ///< a tuple has a number for each factor, or for the first of them
  } arrays[] = {
    { "VDMFunctions", layout.DistanceColumns(), -Huge, true },
    { "MVMFunctions", layout.Curvatures, -Huge, true },
    { "WeightLow", rank, -Huge, false },
    { "WeightWidth", rank, 0., false },
    { "Errors", rank, 0., false },
  };
  for (const auto& [name, tuples, least, ofFactors] : arrays)
  {
    vtkDataArray* array = data->GetArray(name);
    check.Size(array, name, ofFactors ? 0 : 1, tuples);
    if (ofFactors && array && array->GetNumberOfComponents() > rank)
    {
      check.Fail(std::string("its ") + name + " are of more factors than it has weights");
    }
    check.Numbers(array, name, least, Huge);
  }
}
}

std::string MesoVDMProblem(vtkImageData* table, const MesoVDMLayout& layout)
{
  vtkPointData* points = table->GetPointData();
  Check check;
  if (points->GetArray("VDM"))
  {
    const auto rows = static_cast<vtkIdType>(layout.Rows());
    check.Size(vtkUnsignedShortArray::SafeDownCast(points->GetArray("VDM")), "VDM",
      layout.DistanceColumns(), rows);
    check.Size(
      vtkUnsignedShortArray::SafeDownCast(points->GetArray("MVM")), "MVM", layout.Curvatures, rows);
  }
  else
  {
    CheckFactors(table, layout, check);
  }
  vtkDataArray* error = table->GetFieldData()->GetArray("AngularError");
  check.Size(error, "AngularError", 1, 1);
  check.Numbers(error, "AngularError", 0., Huge);
  return check.Reason;
}

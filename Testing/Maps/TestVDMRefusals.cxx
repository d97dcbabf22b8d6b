// Heights, layouts and tables of view-dependent displacements that are none, and what is said of them.

#include "ErrorRecorder.h"
#include "VDMTables.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using namespace VDMTables;
}

TEST(VDMRefusals, HeightsThatAreNone)
{
  for (const double height : { std::nan(""), -0.5, 1.5, HUGE_VAL })
  {
    vtkNew<vtkMesoVDM> filter;
    ErrorRecorder recorder;
    recorder.Watch(filter);
    filter->SetInputData(OneTexel(8, 0.5, height));
    filter->SetLayout(SmallLayout(8, 8));
    filter->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u) << height;
    EXPECT_NE(recorder.Errors[0].find("texel (1, 2)"), std::string::npos) << recorder.Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(VDMRefusals, LayoutsThatAreNoNumbers)
{
  const double bad[] = { std::nan(""), HUGE_VAL, -HUGE_VAL, -1., 0., 1e300 };
  for (const double number : bad)
  {
    MesoVDMLayout layout = SmallLayout(8, 8);
    layout.Depth = number;
    EXPECT_NE(layout.Problem(), "") << number;
  }
  for (const double number : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    MesoVDMLayout layout = SmallLayout(8, 8);
    layout.FirstCurvature = number;
    EXPECT_NE(layout.Problem(), "") << number;
    layout = SmallLayout(8, 8);
    layout.LastCurvature = number;
    EXPECT_NE(layout.Problem(), "") << number;
  }
}

TEST(VDMRefusals, SayWhatIsWrongWithATable)
{
  const MesoVDMLayout layout = SmallLayout(4, 4);
  vtkSmartPointer<vtkImageData> map = RandomMap(4, 4);
  struct Case
  {
    int Rank;
    std::function<void(vtkImageData*)> Change;
    const char* Says;
  };
  const auto field = [](const char* name)
  { return [name](vtkImageData* table) { return table->GetFieldData()->GetArray(name); }; };
  const auto set = [&](const char* name, int tuple, double number)
  { return [=](vtkImageData* table) { field(name)(table)->SetComponent(tuple, 0, number); }; };
  const auto remove = [](const char* name)
  {
    return [=](vtkImageData* table)
    {
      table->GetFieldData()->RemoveArray(name);
      table->GetPointData()->RemoveArray(name);
    };
  };
  const auto cut = [&](const char* name)
  {
    return [=](vtkImageData* table)
    {
      vtkDataArray* array = field(name)(table);
      array->SetNumberOfTuples(array->GetNumberOfTuples() - 1);
    };
  };
  const double nan = std::nan("");
  const Case cases[] = {
    { 4, remove("Weights"), "has no Weights" },
    { 4, remove("VDMFunctions"), "has no VDMFunctions" },
    { 4, remove("MVMFunctions"), "has no MVMFunctions" },
    { 4, remove("WeightLow"), "has no WeightLow" },
    { 4, remove("Errors"), "has no Errors" },
    { 4, remove("AngularError"), "has no AngularError" },
    { 0, remove("MVM"), "has no MVM" },
    { 0, remove("AngularError"), "has no AngularError" },
    { 4, cut("VDMFunctions"), "VDMFunctions is not of the table's size" },
    { 4, cut("WeightWidth"), "WeightWidth is not of the table's size" },
    { 4, cut("Errors"), "Errors is not of the table's size" },
    { 4, set("VDMFunctions", 7, nan), "VDMFunctions holds" },
    { 4, set("MVMFunctions", 2, HUGE_VAL), "MVMFunctions holds" },
    { 4, set("WeightLow", 1, -1e30), "WeightLow holds" },
    { 4, set("WeightWidth", 3, -1.), "WeightWidth holds" },
    { 4, set("Errors", 0, nan), "Errors holds" },
    { 0, set("AngularError", 0, -1.), "AngularError holds" },
    { 4,
      [&](vtkImageData* table)
      {
        // Functions of more factors than the rows have weights for.
        table->GetFieldData()->RemoveArray("VDMFunctions");
        table->GetFieldData()->AddArray(
          Bake(map, layout, 6)->GetFieldData()->GetArray("VDMFunctions"));
      },
      "more factors than it has weights" },
    { 4,
      [](vtkImageData* table)
      {
        vtkNew<vtkFloatArray> weights;
        weights->DeepCopy(table->GetPointData()->GetScalars());
        weights->SetName("Weights");
        table->GetPointData()->RemoveArray("Weights");
        table->GetPointData()->SetScalars(weights);
      },
      "not of 8 or 16 bits" },
  };
  for (const Case& wrong : cases)
  {
    vtkSmartPointer<vtkImageData> table = Bake(map, layout, wrong.Rank);
    EXPECT_EQ(MesoVDMProblem(table, layout), "");
    wrong.Change(table);
    const std::string problem = MesoVDMProblem(table, layout);
    EXPECT_NE(problem.find(wrong.Says), std::string::npos) << wrong.Says << ": " << problem;
  }
}

TEST(VDMRefusals, LayoutsOfFilesThatMakeNoSense)
{
  const MesoVDMLayout layout = SmallLayout(4, 4);
  vtkSmartPointer<vtkImageData> map = RandomMap(4, 4);
  struct Case
  {
    const char* Array;
    int Index;
    double Number;
  };
  const Case cases[] = { { "VDMSizes", 0, 5. }, { "VDMSizes", 0, -4. }, { "VDMSizes", 1, 4.5 },
    { "VDMSizes", 2, std::nan("") }, { "VDMSizes", 3, 1e300 }, { "VDMSizes", 4, 0. },
    { "VDMSizes", 4, 65536. }, { "VDMSizes", 5, 3. }, { "VDMSizes", 6, 3. },
    { "VDMNumbers", 0, std::nan("") }, { "VDMNumbers", 1, HUGE_VAL }, { "VDMNumbers", 1, 20. },
    { "VDMNumbers", 2, 0. }, { "VDMNumbers", 2, std::nan("") }, { "VDMNumbers", 2, -1. } };
  for (const Case& wrong : cases)
  {
    vtkSmartPointer<vtkImageData> table = Bake(map, layout, 4);
    EXPECT_NO_THROW(MesoVDMLayout::Read(table));
    table->GetFieldData()->GetArray(wrong.Array)->SetComponent(wrong.Index, 0, wrong.Number);
    EXPECT_THROW(MesoVDMLayout::Read(table), std::runtime_error)
      << wrong.Array << " " << wrong.Index << " " << wrong.Number;
  }
}

// vtkMesoMeshPart: each triangle in one of the parts of ranges that meet, with its points' data.

#include "DicedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMesoMeshPart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace
{
vtkSmartPointer<vtkPolyData> Part(
  vtkPolyData* mesh, const std::string& by, double from, double to, int component = -1)
{
  vtkNew<vtkMesoMeshPart> filter;
  filter->SetInputData(mesh);
  filter->SetBy(by);
  filter->SetComponent(component);
  filter->SetRange(from, to);
  filter->Update();
  return filter->GetOutput();
}

/// A torus whose cells are numbered.
vtkSmartPointer<vtkPolyData> NumberedTorus()
{
  const auto torus = ShapeMesh("torus", { { "rings", { 24. } }, { "sides", { 12. } } });
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < torus->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  torus->GetCellData()->AddArray(numbers);
  return torus;
}
}

TEST(MeshPart, PartsMakeUpTheMesh)
{
  const auto torus = NumberedTorus();
  std::set<int> seen;
  vtkIdType cells = 0;
  for (const auto& [from, to] : { std::pair(-9., -0.1), std::pair(-0.1, 0.2), std::pair(0.2, 9.) })
  {
    const auto part = Part(torus, "y", from, to);
    ASSERT_GT(part->GetNumberOfCells(), 0);
    EXPECT_LT(part->GetNumberOfPoints(), torus->GetNumberOfPoints());
    cells += part->GetNumberOfCells();
    for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
    {
      const auto number = static_cast<int>(part->GetCellData()->GetArray("Number")->GetTuple1(i));
      seen.insert(number);
      // The same corners, in the same order, with the same data.
      vtkIdList* corners = part->GetCell(i)->GetPointIds();
      vtkNew<vtkIdList> original;
      torus->GetCellPoints(number, original);
      ASSERT_EQ(corners->GetNumberOfIds(), original->GetNumberOfIds());
      double mean = 0.;
      for (vtkIdType k = 0; k < original->GetNumberOfIds(); ++k)
      {
        EXPECT_EQ(
          PositionOf(part, part->GetCell(i)->GetPointId(k)), PositionOf(torus, original->GetId(k)));
        EXPECT_EQ(TupleOf(part, "MesoTangent", part->GetCell(i)->GetPointId(k)),
          TupleOf(torus, "MesoTangent", original->GetId(k)));
        mean += PositionOf(torus, original->GetId(k))[1] / 3.;
      }
      EXPECT_GE(mean, from - 1e-12);
      EXPECT_LT(mean, to + 1e-12);
    }
  }
  EXPECT_EQ(cells, torus->GetNumberOfCells());
  EXPECT_EQ(seen.size(), std::size_t(torus->GetNumberOfCells()));
}

TEST(MeshPart, VerticesAreDenseAndStayMerged)
{
  const auto torus = NumberedTorus();
  const auto part = Part(torus, "u", 0.5, 2.);
  std::set<vtkIdType> numbers;
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    numbers.insert(static_cast<vtkIdType>(TupleOf(part, "MesoVertex", i)[0]));
    for (vtkIdType k = 0; k < i; ++k)
    {
      EXPECT_EQ(PositionOf(part, i) == PositionOf(part, k),
        TupleOf(part, "MesoVertex", i)[0] == TupleOf(part, "MesoVertex", k)[0]);
    }
  }
  EXPECT_EQ(*numbers.rbegin() + 1, vtkIdType(numbers.size()));
  EXPECT_LT(vtkIdType(numbers.size()), part->GetNumberOfPoints()); // the seam of v is in it
}

TEST(MeshPart, ChoosesByArrays)
{
  const auto torus = NumberedTorus();
  vtkNew<vtkFloatArray> array;
  array->SetName("pair");
  array->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple2(3., 4.);
  }
  torus->GetPointData()->AddArray(array);
  EXPECT_EQ(Part(torus, "pair", 5., 5.1)->GetNumberOfCells(), torus->GetNumberOfCells());
  EXPECT_EQ(Part(torus, "pair", 4.5, 5.)->GetNumberOfCells(), 0);
  EXPECT_EQ(Part(torus, "pair", 3., 3.1, 0)->GetNumberOfCells(), torus->GetNumberOfCells());
  EXPECT_EQ(Part(torus, "pair", 4., 4.1, 1)->GetNumberOfCells(), torus->GetNumberOfCells());
}

TEST(MeshPart, NaNLiesInNoRange)
{
  const auto torus = NumberedTorus();
  vtkNew<vtkFloatArray> array;
  array->SetName("value");
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(std::numeric_limits<float>::quiet_NaN());
  }
  torus->GetPointData()->AddArray(array);
  EXPECT_EQ(Part(torus, "value", -1e30, 1e30)->GetNumberOfCells(), 0);
}

TEST(MeshPart, SaysWhatIsMissing)
{
  const auto torus = NumberedTorus();
  for (const auto& [by, component] : { std::pair("none", -1), std::pair("MesoTangent", 3) })
  {
    vtkNew<vtkMesoMeshPart> filter;
    ErrorRecorder recorder;
    recorder.Watch(filter);
    filter->SetInputData(torus);
    filter->SetBy(by);
    filter->SetComponent(component);
    filter->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u) << by;
    EXPECT_NE(recorder.Errors[0].find(by), std::string::npos) << recorder.Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(MeshPart, OfNothingIsNothing)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(Part(nothing, "z", 0., 1.)->GetNumberOfPoints(), 0);
}

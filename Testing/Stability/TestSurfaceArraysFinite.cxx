// Broken meshes through frames, curvatures and quadrics: every number of every array is finite and 0
// where nothing can be known, or one line says which element cannot be used.

#include "BrokenMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoPrincipalCurvatures.h"
#include "vtkMesoQuadricFit.h"
#include "vtkMesoSurfaceFrames.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// What a chain of the three filters gives: a mesh, or errors.
struct Result
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<std::string> Errors;
};

Result RunChain(vtkPolyData* input, bool splitNormals, bool asInThePaper)
{
  vtkNew<vtkMesoSurfaceFrames> frames;
  vtkNew<vtkMesoPrincipalCurvatures> curvatures;
  vtkNew<vtkMesoQuadricFit> quadrics;
  ErrorRecorder recorder;
  recorder.Watch(frames);
  recorder.Watch(curvatures);
  recorder.Watch(quadrics);
  frames->SetInputData(input);
  frames->SetSplitNormals(splitNormals);
  Result result;
  // By hand, as a user who sees an error stops.
  frames->Update();
  curvatures->SetInputData(frames->GetOutput());
  if (recorder.Errors.empty())
  {
    curvatures->Update();
  }
  quadrics->SetInputData(curvatures->GetOutput());
  quadrics->SetFull(!asInThePaper);
  quadrics->SetSlopes(!asInThePaper);
  quadrics->SetNormalEquations(asInThePaper);
  quadrics->SetRings(asInThePaper ? 1 : 2);
  if (recorder.Errors.empty())
  {
    quadrics->Update();
  }
  result.Mesh = quadrics->GetOutput();
  result.Errors = recorder.Errors;
  EXPECT_TRUE(recorder.Warnings.empty()) << recorder.Warnings[0];
  return result;
}

/// Numbers that are not finite, in points and point arrays.
int CountNotFinite(vtkPolyData* mesh)
{
  int count = 0;
  const auto check = [&](vtkDataArray* array)
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        if (!std::isfinite(array->GetComponent(i, k)))
        {
          ++count;
          EXPECT_GT(count, 1) << array->GetName() << " of point " << i;
        }
      }
    }
  };
  check(mesh->GetPoints()->GetData());
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(i);
    EXPECT_EQ(array->GetNumberOfTuples(), mesh->GetNumberOfPoints()) << array->GetName();
    check(array);
  }
  return count;
}

/// What the arrays promise of each point; gives the number of points with curvature and quadric.
std::array<vtkIdType, 2> CheckPoints(vtkPolyData* mesh, double rounding)
{
  vtkPointData* data = mesh->GetPointData();
  const auto value = [&](const char* name, vtkIdType i, int k)
  { return data->GetArray(name)->GetComponent(i, k); };
  const auto length = [&](const char* name, vtkIdType i)
  { return MesoLength(TupleOf(mesh, name, i)); };
  std::array<vtkIdType, 2> known = { 0, 0 };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (const char* name : { "Normals", "MesoTangent", "MesoBitangent" })
    {
      EXPECT_NEAR(length(name, i), 1., rounding) << name << " of point " << i;
    }
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_GE(value("MesoTileScale", i, k), 0.) << i;
    }
    const double valid = value("MesoFrameValid", i, 0);
    EXPECT_TRUE(valid == 0. || valid == 1.) << i;

    const double confidence = value("MesoCurvatureConfidence", i, 0);
    EXPECT_TRUE(confidence >= 0. && confidence <= 1.) << i;
    EXPECT_GE(value("MesoCurvature", i, 0), value("MesoCurvature", i, 1)) << i;
    double sum = std::abs(value("MesoCurvature", i, 0)) + std::abs(value("MesoCurvature", i, 1));
    for (int k = 0; k < 6; ++k)
    {
      sum += std::abs(value("MesoPrincipalDirections", i, k));
    }
    EXPECT_EQ(confidence > 0., sum > 0.) << i;

    const double condition = value("MesoQuadricCondition", i, 0);
    EXPECT_TRUE(condition == 0. || condition >= 1. - rounding) << i << ": " << condition;
    EXPECT_TRUE(condition > 0. || length("MesoQuadric", i) == 0.) << i;
    known[0] += confidence > 0. ? 1 : 0;
    known[1] += condition > 0. ? 1 : 0;
  }
  return known;
}

class SurfaceArrays : public testing::TestWithParam<BrokenMesh>
{
};
}

TEST_P(SurfaceArrays, AreFiniteAndZeroWhereNothingIsKnown)
{
  const BrokenMesh& broken = GetParam();
  const auto inDouble = broken.Make();
  const auto inFloat = InFloat(inDouble);
  for (vtkPolyData* input : { inDouble.Get(), inFloat.Get() })
  {
    for (const bool splitNormals : { false, true })
    {
      for (const bool asInThePaper : { false, true })
      {
        const bool isFloat = input != inDouble;
        SCOPED_TRACE(std::string(isFloat ? "float" : "double") + (splitNormals ? ", split" : "") +
          (asInThePaper ? ", as in the paper" : ""));
        const Result result = RunChain(input, splitNormals, asInThePaper);
        const bool tooLarge = isFloat && broken.Name == "TooLargeToSquare";
        if (tooLarge)
        {
          // Floats hold no such position.
          ASSERT_EQ(result.Errors.size(), 1u);
          EXPECT_NE(result.Errors[0].find("of point 0 is not finite"), std::string::npos);
          continue;
        }
        ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
        vtkPolyData* mesh = result.Mesh;
        EXPECT_GE(mesh->GetNumberOfPoints(), input->GetNumberOfPoints());
        if (mesh->GetNumberOfPoints() == 0)
        {
          continue;
        }
        EXPECT_EQ(CountNotFinite(mesh), 0);
        const auto known = CheckPoints(mesh, isFloat ? 1e-6 : 1e-12);
        const double* quadrics = mesh->GetPointData()->GetArray("MesoQuadric")->GetRange(-1);
        const double* curvatures = mesh->GetPointData()->GetArray("MesoCurvature")->GetRange(-1);
        using K = Knowledge;
        const K knowledge = broken.Known;
        if (knowledge == K::None || knowledge == K::NoCurvature)
        {
          EXPECT_EQ(known[0], 0);
        }
        if (knowledge == K::None)
        {
          EXPECT_EQ(known[1], 0);
        }
        if (knowledge == K::Plane || knowledge == K::Sides)
        {
          EXPECT_EQ(curvatures[1], 0.);
        }
        // Normals that are means over a crease tilt the planes that quadrics are fitted over.
        if (knowledge == K::Plane || (knowledge == K::Sides && splitNormals))
        {
          EXPECT_EQ(quadrics[1], 0.);
        }
        // At 1e6 a float keeps a sixteenth of a unit: the surface is gone.
        if (knowledge == K::Most && !(isFloat && broken.Name == "FarFromTheOrigin"))
        {
          EXPECT_GT(2 * known[0], mesh->GetNumberOfPoints());
          EXPECT_GT(2 * known[1], mesh->GetNumberOfPoints());
          EXPECT_GT(curvatures[1], 0.);
          EXPECT_GT(quadrics[1], 0.);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, SurfaceArrays, testing::ValuesIn(BrokenMeshes()),
  [](const auto& info) { return info.param.Name; });

namespace
{
class SurfaceRefusals : public testing::Test
{
protected:
  vtkSmartPointer<vtkPolyData> Mesh = WavyGrid().Make();

  /// One line that has this text, whatever the options, and nothing half made.
  void Expect(const std::string& text)
  {
    for (const bool option : { false, true })
    {
      const Result result = RunChain(this->Mesh, option, option);
      ASSERT_EQ(result.Errors.size(), 1u) << text;
      EXPECT_NE(result.Errors[0].find(text), std::string::npos) << result.Errors[0];
      const std::string said = result.Errors[0].substr(result.Errors[0].find("): ") + 3);
      EXPECT_EQ(said.find_last_not_of('\n'), said.find('\n') - 1) << "one line: " << said;
      EXPECT_EQ(result.Mesh->GetNumberOfPoints(), 0);
      EXPECT_EQ(result.Mesh->GetNumberOfCells(), 0);
    }
  }
};
}

TEST_F(SurfaceRefusals, PositionsThatAreNotFinite)
{
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    this->Mesh->GetPoints()->SetPoint(17, 0., bad, 0.);
    this->Mesh->Modified();
    this->Expect("of point 17 is not finite");
  }
}

TEST_F(SurfaceRefusals, TextureCoordinatesThatAreNotFinite)
{
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    this->Mesh->GetPointData()->GetTCoords()->SetComponent(23, 1, bad);
    this->Mesh->Modified();
    this->Expect("of point 23 is not finite");
  }
}

TEST_F(SurfaceRefusals, NormalsThatAreNotFinite)
{
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(this->Mesh->GetNumberOfPoints());
  normals->Fill(1.);
  normals->SetComponent(40, 2, NaN);
  this->Mesh->GetPointData()->SetNormals(normals);
  this->Expect("of point 40 is not finite");
}

TEST_F(SurfaceRefusals, MissingTextureCoordinates)
{
  this->Mesh->GetPointData()->SetTCoords(nullptr);
  this->Mesh->GetPointData()->RemoveArray("uv");
  this->Expect("texture coordinates");
}

TEST_F(SurfaceRefusals, CellsWithPointsThatDoNotExist)
{
  this->Mesh->GetPolys()->InsertNextCell({ 0, 1, 81 });
  this->Mesh->Modified();
  this->Expect("81");
}

// A normal of length 0 is made anew: the numbers are those of a mesh without normals.
TEST(SurfaceNormals, OfLengthZeroAreMade)
{
  const auto mesh = WavyGrid().Make();
  const Result without = RunChain(mesh, false, false);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
  normals->Fill(0.);
  mesh->GetPointData()->SetNormals(normals);
  const Result zero = RunChain(mesh, false, false);
  ASSERT_TRUE(zero.Errors.empty()) << zero.Errors[0];
  EXPECT_EQ(CountNotFinite(zero.Mesh), 0);
  vtkNew<vtkMesoPrincipalCurvatures> alone; // with no filter before it that makes normals
  alone->SetInputData(mesh);
  alone->Update();
  EXPECT_EQ(CountNotFinite(alone->GetOutput()), 0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (const char* name : { "Normals", "MesoPrincipalDirections" })
    {
      // Normals made unit twice differ by rounding.
      EXPECT_LT(
        DistanceOf(TupleOf(alone->GetOutput(), name, i), TupleOf(without.Mesh, name, i)), 1e-14)
        << name << " " << i;
    }
  }
  for (const char* name : { "Normals", "MesoCurvature", "MesoQuadric" })
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(TupleOf(zero.Mesh, name, i), TupleOf(without.Mesh, name, i)) << name << " " << i;
    }
  }
}

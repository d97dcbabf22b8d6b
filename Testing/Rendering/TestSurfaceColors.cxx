// color_by of a scene: colours read back as numbers of the lookup table, for arrays and for heights, in
// each technique; equal to vtkPolyDataMapper's picture; nothing in the shader where it is off.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"

#include "MesoLookupTable.h"
#include "MesoSceneBuilder.h"

#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using Rgb = std::array<int, 3>;

constexpr int Size = 60; // pixels; the plane of 2 x 2 fills the picture

class SurfaceColors : public testing::Test
{
protected:
  MesoTestScene Scene{ Size, Size };
  MesoSceneBuilder Builder;

  SurfaceColors() { this->Scene.Renderer->RemoveActor(this->Scene.Actor); }

  /// One node, seen from above, lit by what `lights` says.
  void Build(const std::string& node, const std::string& lights = "[]")
  {
    this->Scene.Renderer->RemoveAllViewProps();
    const std::string text = R"({ "meso": 1,
      "camera": {"position": [0, 0, 5], "parallel_scale": 1},
      "lights": )" +
      lights + R"(, "nodes": [{)" + node + "}] }";
    this->Builder.Build(MesoParseScene(text, "test.json"), this->Scene.Renderer);
  }

  vtkMesoPolyDataMapper* Mapper() { return this->Builder.GetObjects().at(0).Mapper; }

  std::string Refusal(const std::string& node)
  {
    try
    {
      this->Build(node);
    }
    catch (const MesoInputError& error)
    {
      return error.what();
    }
    return "built without an error";
  }

  vtkSmartPointer<vtkImageData> Picture() { return MesoGrabWindow(this->Scene.Window); }

  static Rgb At(vtkImageData* picture, int column, int row)
  {
    const auto* value = static_cast<unsigned char*>(picture->GetScalarPointer(column, row, 0));
    return { value[0], value[1], value[2] };
  }

  /// Whether a colour is the table's at the value, give or take what rounding (or a fit) may move
  /// it.
  static bool IsColorOf(vtkLookupTable* table, double value, const Rgb& color, double rounding)
  {
    for (int i = -8; i <= 8; ++i)
    {
      const unsigned char* entry = table->MapValue(value + 0.125 * i * rounding);
      if (Rgb{ entry[0], entry[1], entry[2] } == color)
      {
        return true;
      }
    }
    return false;
  }
};

const char* const Plane = R"("mesh": {"shape": "plane", "size": [2, 2]})";

/// Without light, so that the colour is the table's own.
std::string Material(const std::string& colorBy)
{
  return R"(, "material": {"ambient": 1, "diffuse": 0, )" + colorBy + "}";
}

std::string Relief(const std::string& map, const std::string& technique = "relief")
{
  // What is drawn is to be what the numbers say.
  const std::string filter = technique == "tessellated" ? "" : R"(, "filter": "none")";
  return R"(, "mesostructure": {"technique": ")" + technique + "\"" + filter +
    R"(, "scale": 0.05, "height_map": )" + map + "}";
}

/// A map that is 1 everywhere, and so no relief, which the technique has to find out.
std::string Flat(const std::string& technique = "relief")
{
  return Relief(R"({"pattern": "step", "position": 1, "low": 1})", technique);
}

const char* const ReliefTechniques[] = { "relief", "relief-quadric", "tessellated" };

/// Nodes' rest for the base mesh and for each technique over a flat map.
std::vector<std::string> AllFlat()
{
  std::vector<std::string> all = { "" };
  for (const char* technique : ReliefTechniques)
  {
    all.push_back(Flat(technique));
  }
  return all;
}
}

TEST_F(SurfaceColors, ComponentsAreTheTablesAtEveryPixelInEachTechnique)
{
  for (const std::string& technique : AllFlat())
  {
    for (const int component : { 0, 1 })
    {
      for (const char* table : { "viridis", "coolwarm", "grey" })
      {
        this->Build(Plane +
          Material(R"("color_by": "TextureCoordinates[)" + std::to_string(component) +
            R"(]", "lookup_table": {"name": ")" + table + R"(", "range": [0.1, 0.8]})") +
          technique);
        const auto picture = this->Picture();
        const auto expected = MesoMakeLookupTable(table, { 0.1, 0.8 });
        int wrong = 0;
        for (int row = 0; row < Size; ++row)
        {
          for (int column = 0; column < Size; ++column)
          {
            const double value = ((component == 0 ? column : row) + 0.5) / Size;
            wrong += IsColorOf(expected, value, At(picture, column, row), 1e-5) ? 0 : 1;
          }
        }
        EXPECT_EQ(wrong, 0) << table << " " << component << " " << technique;
      }
    }
  }
}

TEST_F(SurfaceColors, WithoutAComponentTheMagnitudeOfSeveral)
{
  this->Build(Plane + Material(R"("color_by": "TextureCoordinates")"));
  const auto picture = this->Picture();
  const auto expected = MesoMakeLookupTable("viridis", { 0., std::sqrt(2.) });
  for (int i = 0; i < Size; ++i)
  {
    // Along the diagonal, where the triangles' interpolation is exact.
    const double value = std::sqrt(2.) * (i + 0.5) / Size;
    EXPECT_TRUE(IsColorOf(expected, value, At(picture, i, i), 1e-5)) << i;
  }
}

TEST_F(SurfaceColors, CurvaturesAreMadeAndColoredByTheirSign)
{
  const std::string torus = R"("mesh": {"shape": "torus", "radius": 0.65, "tube": 0.25,
    "rings": 96, "sides": 48}, "transform": {"rotate": [90, 1, 0, 0]})";
  this->Build(torus + Material(R"("color_by": "MesoCurvature[0]")"));
  const auto maximum = MesoMakeLookupTable("coolwarm", { -4., 4. });
  auto picture = this->Picture();
  const Rgb top = At(picture, Size / 2, Size / 2 + 19);
  EXPECT_TRUE(IsColorOf(maximum, 4., top, 0.05)) << top[0] << " " << top[1] << " " << top[2];

  // c_min = cos(b) / w: negative inside, positive outside; its range is symmetric.
  this->Build(torus + Material(R"("color_by": "MesoCurvature[1]")"));
  picture = this->Picture();
  const double* range = this->Mapper()->GetLookupTable()->GetRange();
  EXPECT_EQ(range[0], -range[1]);
  EXPECT_GT(range[1], 2.1); // a percentile of what goes up to 1 / 0.4
  EXPECT_LT(range[1], 2.45);
  const auto minimum = MesoMakeLookupTable("coolwarm", { range[0], range[1] });
  for (const int row : { 14, 17, 19, 22, 25 })
  {
    const double w = (row + 0.5) / Size * 2.;
    const double value = (w - 0.65) / 0.25 / w;
    const Rgb color = At(picture, Size / 2, Size / 2 + row);
    EXPECT_TRUE(IsColorOf(minimum, value, color, 0.04))
      << "w " << w << ": " << color[0] << " " << color[1] << " " << color[2];
  }
  for (const char* array :
    { "MesoCurvature", "MesoPrincipalDirections[3]", "MesoCurvatureConfidence", "MesoQuadric[0]",
      "MesoQuadric", "MesoQuadricCondition", "MesoTangent[0]", "MesoFrameValid" })
  {
    this->Build(torus + Material(std::string(R"("color_by": ")") + array + "\"") + Flat());
    EXPECT_TRUE(this->Builder.GetWarnings().empty()) << this->Builder.GetWarnings()[0];
    EXPECT_FALSE(MesoCompareImages(this->Picture(), picture).Within) << array;
  }
}

TEST_F(SurfaceColors, EqualsVTKsMapperOnPlainAndOnFlatRelief)
{
  const std::string node = R"("mesh": {"shape": "torus", "radius": 0.65, "tube": 0.25},
    "transform": {"rotate": [50, 1, 0.2, 0]}, "material": {"color_by": "MesoCurvature[1]",
    "specular": 0.4, "specular_power": 20})";
  const std::string lights = R"([{"type": "directional", "direction": [-1, -0.5, -1]},
    {"type": "headlight", "intensity": 0.3}, {"type": "point", "position": [1, 2, 2]}])";
  for (const std::string& technique : AllFlat())
  {
    this->Build(node + technique, lights);
    const auto ours = this->Picture();
    vtkNew<vtkPolyDataMapper> theirs;
    theirs->SetInputData(this->Mapper()->GetInput());
    theirs->SetLookupTable(this->Mapper()->GetLookupTable());
    theirs->UseLookupTableScalarRangeOn();
    theirs->SetScalarModeToUsePointFieldData();
    theirs->SelectColorArray("MesoCurvature");
    theirs->InterpolateScalarsBeforeMappingOn();
    this->Builder.GetObjects()[0].Actor->SetMapper(theirs);
    const auto expected = this->Picture();
    const auto difference = MesoCompareImages(ours, expected, MesoImageLimits::Exact());
    EXPECT_TRUE(difference.Within) << difference.Describe();
    theirs->ScalarVisibilityOff();
    EXPECT_FALSE(MesoCompareImages(this->Picture(), expected).Within) << "there are no colours";
  }
}

TEST_F(SurfaceColors, RangesAreTheSameInEachTechnique)
{
  const auto rangeOf = [&](const std::string& technique)
  {
    this->Build(
      R"("mesh": {"shape": "torus"}, "material": {"color_by": "MesoCurvature[1]"})" + technique);
    const double* range = this->Mapper()->GetLookupTable()->GetRange();
    return std::array<double, 2>{ range[0], range[1] };
  };
  const auto plain = rangeOf("");
  for (const char* technique : ReliefTechniques)
  {
    EXPECT_EQ(rangeOf(Relief(R"({"pattern": "brick", "size": [64, 64]})", technique)), plain)
      << technique;
  }
}

TEST_F(SurfaceColors, NotANumberIsMagenta)
{
  this->Build(R"("mesh": {"shape": "plane", "size": [2, 2], "segments": [4, 4]})" +
    Material(R"("color_by": "TextureCoordinates[0]")"));
  vtkDataArray* values = this->Mapper()->GetInput()->GetPointData()->GetTCoords();
  vtkNew<vtkFloatArray> number;
  number->SetName("number");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    number->InsertNextValue(i == 12 ? std::nanf("") : 0.25f); // the middle of 5 x 5
  }
  this->Mapper()->GetInput()->GetPointData()->AddArray(number);
  this->Mapper()->SelectColorArray("number");
  const auto picture = this->Picture();
  EXPECT_EQ(At(picture, Size / 2, Size / 2), (Rgb{ 255, 0, 255 }));
  EXPECT_EQ(At(picture, Size / 2 + 5, Size / 2 + 2), (Rgb{ 255, 0, 255 }));
  const auto expected = MesoMakeLookupTable("viridis", { 0., 1. });
  EXPECT_TRUE(IsColorOf(expected, 0.25, At(picture, 5, 5), 1e-5));
}

TEST_F(SurfaceColors, HeightsAreThoseOfTheHitAtEveryPixel)
{
  vtkNew<vtkMesoAOVPass> pass;
  for (const char* technique : ReliefTechniques)
  {
    SCOPED_TRACE(technique);
    this->Build(R"("mesh": {"shape": "sphere", "radius": 0.9})" +
      Material(
        R"("color_by": "height", "lookup_table": {"name": "coolwarm", "range": [0.2, 0.9]})") +
      Relief(R"({"pattern": "smooth", "size": [64, 64]})", technique));
    const auto picture = this->Picture();
    MesoCapture(this->Scene, pass);
    EXPECT_GT(MesoCheckEveryPixel(pass), 2000);
    const auto table = MesoMakeLookupTable("coolwarm", { 0.2, 0.9 });
    int wrong = 0;
    double least = 1.;
    double most = 0.;
    for (int row = 0; row < Size; ++row)
    {
      for (int column = 0; column < Size; ++column)
      {
        const int fromTop = Size - 1 - row;
        if (pass->GetValue("coverage", column, fromTop) > 0.f)
        {
          const double height = 1. - pass->GetValue("relief", column, fromTop);
          least = std::min(least, height);
          most = std::max(most, height);
          wrong += IsColorOf(table, height, At(picture, column, row), 1e-5) ? 0 : 1;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_LT(least, 0.2); // the end colours go on
    EXPECT_GT(most, 0.9);
  }
  pass->ReleaseGraphicsResources(this->Scene.Window);
}

TEST_F(SurfaceColors, HeightsAreShadedAsColorsAre)
{
  const std::string lights = R"([{"type": "directional", "direction": [-1, -0.5, -1]}])";
  const std::string relief = Relief(R"({"pattern": "brick", "size": [64, 64]})");
  this->Build(Plane +
      (R"(, "material": {"color_by": "height", "specular": 0.3,
    "lookup_table": {"name": "grey", "range": [-2, -1]}})" +
        relief),
    lights);
  const auto white = this->Picture();
  this->Build(Plane + (R"(, "material": {"color": [1, 1, 1], "specular": 0.3})" + relief), lights);
  const auto difference = MesoCompareImages(this->Picture(), white, MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(SurfaceColors, HeightIsOneWhereTheBaseMeshIsDrawn)
{
  this->Build(Plane + Material(R"("color_by": "height", "lookup_table": {"range": [0, 2]})") +
    R"(, "mesostructure": {"height_map": {"pattern": "noise"}})");
  const auto table = MesoMakeLookupTable("viridis", { 0., 2. });
  EXPECT_TRUE(IsColorOf(table, 1., At(this->Picture(), 20, 30), 1e-5));

  this->Build(Plane + Material(R"("color_by": "height", "lookup_table": {"range": [0, 2]})") +
    Relief(R"({"pattern": "noise"})"));
  this->Mapper()->GetInput()->GetPointData()->RemoveArray("MesoTangent");
  MesoExpectedMessages expected("lacks MesoTangent");
  EXPECT_TRUE(IsColorOf(table, 1., At(this->Picture(), 20, 30), 1e-5));
}

TEST_F(SurfaceColors, NothingIsInTheShaderWhereHeightsAreOff)
{
  const fs::path folder = fs::temp_directory_path() / ("meso-colors-" + std::to_string(getpid()));
  fs::create_directory(folder);
  setenv("MESO_DUMP_SHADERS", folder.c_str(), 1);
  const auto mentions = [&](const char* word)
  {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder))
    {
      std::ifstream file(entry.path());
      const std::string text((std::istreambuf_iterator<char>(file)), {});
      files += text.find(word) != std::string::npos ? 1 : 0;
      fs::remove(entry.path());
    }
    return files;
  };
  const std::string relief = Relief(R"({"pattern": "noise"})");
  this->Build(Plane + Material(R"("color_by": "TextureCoordinates[0]")") + relief);
  const auto without = this->Picture();
  EXPECT_EQ(mentions("eightColor"), 0);

  this->Mapper()->SetHeightColors(MesoMakeLookupTable("grey", { 0., 1. }));
  EXPECT_FALSE(MesoCompareImages(this->Picture(), without).Within);
  EXPECT_EQ(mentions("mesoHeightColors"), 1); // of vertex and fragment shader, the latter

  this->Mapper()->SetHeightColors(nullptr);
  EXPECT_TRUE(MesoCompareImages(this->Picture(), without, MesoImageLimits::Exact()).Within);
  EXPECT_EQ(mentions("eightColor"), 0);
  unsetenv("MESO_DUMP_SHADERS");
  fs::remove_all(folder);
}

TEST_F(SurfaceColors, ATableThatChangesIsSeen)
{
  this->Build(Plane + Material(R"("color_by": "height")") +
    Relief(R"({"pattern": "step", "position": 1, "low": 1})"));
  EXPECT_EQ(At(this->Picture(), 9, 9), (Rgb{ 253, 231, 37 }));
  this->Mapper()->GetHeightColors()->SetTableValue(255, 0., 1., 0.);
  EXPECT_EQ(At(this->Picture(), 9, 9), (Rgb{ 0, 255, 0 }));
  this->Mapper()->GetHeightColors()->SetRange(0., 0.);
  EXPECT_EQ(At(this->Picture(), 9, 9), (Rgb{ 0, 255, 0 })); // no division by 0
}

TEST_F(SurfaceColors, ArraysThatAreNotThereAreRefusedInOneLine)
{
  EXPECT_EQ(this->Refusal(Plane + Material(R"("color_by": "MesoCurvatures[0]")")),
    "test.json: nodes[0].material.color_by: the mesh has no point array \"MesoCurvatures\" (did "
    "you mean MesoCurvature? there are: MesoBitangent, MesoCurvature, MesoCurvatureConfidence, "
    "MesoFrameValid, MesoPrincipalDirections, MesoQuadric, MesoQuadricCondition, MesoTangent, "
    "MesoTileScale, MesoVertex, Normals, TextureCoordinates)");
  EXPECT_EQ(this->Refusal(Plane + Material(R"("color_by": "MesoQuadric[3]")")),
    "test.json: nodes[0].material.color_by: MesoQuadric has 3 components, numbered from 0; there "
    "is no [3]");
  EXPECT_EQ(this->Refusal(Plane + Material(R"("color_by": "MesoCurvatureConfidence[1]")")),
    "test.json: nodes[0].material.color_by: MesoCurvatureConfidence has 1 component, numbered from "
    "0; there is no [1]");
}

TEST_F(SurfaceColors, QuadricsOfAMeshWithoutTextureCoordinatesAreRefused)
{
  const fs::path file =
    fs::temp_directory_path() / ("meso-colors-" + std::to_string(getpid()) + ".obj");
  std::ofstream(file) << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  const std::string mesh = R"("mesh": ")" + file.string() + "\"";
  const std::string message = this->Refusal(mesh + Material(R"("color_by": "MesoQuadric[0]")"));
  EXPECT_EQ(message.find("test.json: nodes[0].mesh: "), 0u) << message;
  EXPECT_NE(message.find("texture coordinates"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  // Curvatures need none; those of one triangle are not known, and so 0: the middle colour.
  this->Build(mesh + Material(R"("color_by": "MesoCurvature[0]")"));
  const auto table = MesoMakeLookupTable("coolwarm", { -1., 1. });
  EXPECT_TRUE(IsColorOf(table, 0., At(this->Picture(), Size / 2, Size / 2), 1e-5));
  fs::remove(file);
}

// The reference beside what the mappers draw, where both must show the same: plain meshes under all
// kinds of light, relief on a plane, where the technique `relief` is exact but for its search, and
// diced meshes, which approach the truth.
// They share no code but texel fetches and bilinear weights.

#include "MesoReference.h"
#include "MesoSceneBuilder.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoShadowMapPass.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <unistd.h>

namespace
{
constexpr int Width = 96;
constexpr int Height = 72;

/// A scene drawn and traced.
class Both
{
public:
  explicit Both(const std::string& rest)
  {
    const MesoScene scene = MesoParseScene(R"({"meso": 1, )" + rest + "}", "test.json");
    this->Truth = MesoReference(scene).Render(Width, Height);
    vtkNew<vtkMesoEGLRenderWindow> window;
    window->SetMultiSamples(0);
    window->SetSize(Width, Height);
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    MesoSceneBuilder builder;
    builder.Build(scene, renderer);
    for (const auto& object : builder.GetObjects())
    {
      if (vtkTexture* texture = object.Actor->GetTexture())
      {
        // As truth is: the stored values, bilinear.
        texture->MipmapOff();
        texture->SetMaximumAnisotropicFiltering(1.f);
      }
    }
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    vtkRenderWindow* reader = window;
    reader->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    this->Picture.assign(pixels->GetPointer(0), pixels->GetPointer(0) + 3 * Width * Height);
    for (const auto& object : builder.GetObjects())
    {
      this->Pass->SetObjectNumber(object.Actor, object.Number);
    }
    vtkMesoShadowMapPass::RenderThrough(renderer, this->Pass);
    this->Pass->ReleaseGraphicsResources(window);
  }

  double True(const std::string& channel, int column, int row) const
  {
    const auto& names = this->Truth.AOVs.ChannelNames;
    const auto place = std::find(names.begin(), names.end(), channel);
    return double(this->Truth.AOVs.At(column, row, place - names.begin()));
  }
  double Drawn(const std::string& channel, int column, int row) const
  {
    return double(this->Pass->GetValue(channel, column, row));
  }

  /// Intersection over union of the covered pixels.
  double Coverage() const
  {
    int either = 0;
    int both = 0;
    this->ForEach(
      [&](int column, int row)
      {
        const bool a = this->True("coverage", column, row) > 0.5;
        const bool b = this->Drawn("coverage", column, row) > 0.5;
        either += a || b ? 1 : 0;
        both += a && b ? 1 : 0;
      });
    EXPECT_GT(both, 500);
    return static_cast<double>(both) / either;
  }

  /// A part of the differences of a channel, where both cover, lies below this.
  double Difference(const std::string& channel, double part) const
  {
    std::vector<double> differences;
    this->ForEach(
      [&](int column, int row)
      {
        if (this->True("coverage", column, row) > 0.5 && this->Drawn("coverage", column, row) > 0.5)
        {
          differences.push_back(
            std::abs(this->True(channel, column, row) - this->Drawn(channel, column, row)));
        }
      });
    std::sort(differences.begin(), differences.end());
    return differences.empty()
      ? std::numeric_limits<double>::quiet_NaN()
      : differences[static_cast<std::size_t>(part * (differences.size() - 1))];
  }

  /// The part of the pixels whose colours differ by more than `steps` of 255.
  double ColorsApart(int steps) const
  {
    const auto* truth = static_cast<unsigned char*>(this->Truth.Picture->GetScalarPointer());
    int apart = 0;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      int most = 0;
      for (int k = 3 * pixel; k < 3 * pixel + 3; ++k)
      {
        most = std::max(most, std::abs(int(truth[k]) - int(this->Picture[k])));
      }
      apart += most > steps ? 1 : 0;
    }
    return static_cast<double>(apart) / (Width * Height);
  }

  MesoReferenceResult Truth;

private:
  template <typename Function>
  static void ForEach(Function&& function)
  {
    for (int row = 0; row < Height; ++row)
    {
      for (int column = 0; column < Width; ++column)
      {
        function(column, row);
      }
    }
  }

  vtkNew<vtkMesoAOVPass> Pass;
  std::vector<unsigned char> Picture;
};

// Covers most of the picture; ambient, diffuse and specular all play a part.
const char* const ShinyTorus = R"("background": [0.1, 0.3, 0.2],
  "nodes": [{"transform": {"rotate": [40, 1, 0.2, 0]}, "mesh": {"shape": "torus"},
    "material": {"color": [0.7, 0.6, 0.9], "ambient": 0.15, "diffuse": 0.8, "specular": 0.5,
                 "specular_power": 12}}])";
const char* const Perspective = R"("camera": {"position": [0.3, 0.4, 4.5], "view_angle": 36}, )";
const char* const Parallel = R"("camera": {"position": [0.3, 0.4, 4.5], "parallel_scale": 1.3}, )";

struct Lights
{
  const char* Name;
  const char* List;
};

// GoogleTest puts it into the test's name, which must not change from run to run.
void PrintTo(const Lights& lights, std::ostream* stream)
{
  *stream << lights.Name;
}

class LightsOfAllKinds : public testing::TestWithParam<Lights>
{
};
}

TEST(ReferenceAgainstRender, PlainMeshes)
{
  for (const char* camera : { Perspective, Parallel })
  {
    for (const char* shape :
      { R"("sphere", "rings": 9, "sides": 14)", R"("torus")", R"("cylinder")" })
    {
      const Both both(std::string(camera) +
        R"("nodes": [{"transform": {"rotate": [20, 1, 1, 0], "scale": [1.2, 1, -0.9]},
                      "mesh": {"shape": )" +
        shape + "}}]");
      EXPECT_GT(both.Coverage(), 0.999) << shape;
      EXPECT_LT(both.Difference("depth", 0.99), 1e-5) << shape; // float's rounding at 4
      EXPECT_LT(both.Difference("texcoord.u", 0.99), 1e-5) << shape;
      EXPECT_LT(both.Difference("texcoord.v", 0.99), 1e-5) << shape;
      for (const char* channel : { "normal.x", "normal.y", "normal.z" })
      {
        EXPECT_LT(both.Difference(channel, 0.99), 1e-5) << shape << " " << channel;
      }
      EXPECT_EQ(both.Difference("object", 1.), 0.) << shape;
    }
  }
}

TEST_P(LightsOfAllKinds, LightAPlainMeshAsVTKDoes)
{
  for (const char* camera : { Perspective, Parallel })
  {
    const Both both(std::string(camera) + R"("lights": )" + GetParam().List + ", " + ShinyTorus);
    // A step of 255 for rounding; an outline's pixel may be covered by one and not by the other.
    EXPECT_LT(both.ColorsApart(1), 1e-3) << camera;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, LightsOfAllKinds,
  testing::Values(Lights{ "None", "[]" },
    Lights{ "Headlight", R"([{"type": "headlight", "color": [1, 0.8, 0.6]}])" },
    Lights{ "TwoHeadlights", R"([{"type": "headlight", "intensity": 0.4},
                                        {"type": "headlight", "intensity": 0.3}])" },
    Lights{ "Directional", R"([{"type": "directional", "direction": [-1, -0.5, -1]},
      {"type": "directional", "direction": [1, 0.2, -0.3], "color": [0.2, 0.4, 0.1]}])" },
    Lights{ "OfTheCamera", R"([{"type": "directional", "direction": [-1, -0.5, -1],
      "coordinates": "camera"}, {"type": "point", "position": [1, 1, -2], "intensity": 0.5,
      "coordinates": "camera"}])" },
    Lights{ "PointWithAttenuation", R"([{"type": "point", "position": [1, 2, 1.5],
      "attenuation": [0.5, 0.2, 0.1]}, {"type": "headlight", "intensity": 0.2}])" },
    Lights{ "Spot", R"([{"type": "spot", "position": [0.5, 1, 3],
      "focal_point": [0.2, 0.1, 0], "cone_angle": 20, "exponent": 6}])" }),
  [](const testing::TestParamInfo<LightsOfAllKinds::ParamType>& info)
  { return std::string(info.param.Name); });

TEST(ReferenceAgainstRender, ReliefOnAPlane)
{
  const char* const lights = R"("lights": [{"type": "directional", "direction": [0.8, -0.5, -1]},
    {"type": "point", "position": [-0.5, 0.4, 0.6], "intensity": 0.4}], )";
  for (const char* pattern : { "brick", "smooth" })
  {
    // Inside of the plane's borders, where the sheet is seen beside its base.
    const Both both(R"("camera": {"position": [0.6, -0.8, 1], "view_angle": 20}, )" +
      std::string(lights) +
      R"("nodes": [{"mesh": {"shape": "plane", "size": [3, 3]},
        "material": {"color": [0.8, 0.55, 0.45], "ambient": 0.1, "specular": 0.3,
                     "specular_power": 16},
        "mesostructure": {"technique": "relief", "quality": "high", "scale": 0.04, "tiles": [4, 4],
                          "height_map": {"pattern": ")" +
      pattern + R"(", "size": [64, 64]}}}])");
    EXPECT_EQ(both.Coverage(), 1.) << pattern;
    // Texels; the search steps 128 times and halves 8 times, and heights are of float.
    EXPECT_LT(64. * both.Difference("texcoord.u", 0.95), 0.01) << pattern;
    EXPECT_LT(64. * both.Difference("texcoord.v", 0.95), 0.01) << pattern;
    EXPECT_LT(both.Difference("depth", 0.95), 1e-4 * 0.04 + 1e-6) << pattern;
    EXPECT_LT(both.Difference("relief", 0.95), 1e-3) << pattern;
    for (const char* channel : { "normal.x", "normal.y", "normal.z" })
    {
      EXPECT_LT(both.Difference(channel, 0.95), 1e-2) << pattern << " " << channel;
    }
    for (const char* channel : { "shadow.0", "shadow.1" })
    {
      EXPECT_LT(both.Difference(channel, 0.99), 0.5) << pattern << " " << channel;
    }
    EXPECT_LT(both.ColorsApart(3), 0.01) << pattern;
  }
}

TEST(ReferenceAgainstRender, DicedMeshesApproachTheTruth)
{
  // Coarse, mirrored and stretched. The nearest of the relief is hit but for pixels at its outlines.
  double depths = 0.;
  double normals = 0.;
  for (const char* quality : { "low", "medium", "high" })
  {
    const Both both(std::string(Perspective) +
      R"("nodes": [{"transform": {"rotate": [50, 1, 0.3, 0], "scale": [1.2, 1, -0.9]},
        "mesh": {"shape": "torus", "rings": 14, "sides": 9},
        "mesostructure": {"technique": "tessellated", "scale": 0.15, "tiles": [4, 2],
                          "height_map": {"pattern": "smooth", "size": [32, 32]}, "quality": ")" +
      quality + R"("}}])");
    EXPECT_GT(both.Coverage(), 0.99) << quality;
    double apart = 0.;
    for (const char* channel : { "normal.x", "normal.y", "normal.z" })
    {
      apart = std::max(apart, both.Difference(channel, 0.9));
    }
    // Twice the facets: a quarter of the error, less what lies at outlines.
    EXPECT_TRUE(depths == 0. || both.Difference("depth", 0.9) < depths / 2.5) << quality;
    EXPECT_TRUE(normals == 0. || apart < normals / 1.5) << quality;
    depths = both.Difference("depth", 0.9);
    normals = apart;
  }
  EXPECT_LT(depths, 5e-3 * 0.15);
  EXPECT_LT(normals, 0.02);
}

TEST(ReferenceAgainstRender, ReliefOnAPlaneInAnyChart)
{
  // Mirrored, sheared and stretched nodes, other wraps: on a plane `relief` stays exact.
  for (const char* transform : { R"("scale": [-1, 1, 1])", R"("scale": [1.5, 0.8, 2])",
         R"("matrix": [1, 0.4, 0, 0,  0.1, 0.9, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1])" })
  {
    for (const char* wrap : { "repeat", "clamp", "mirror" })
    {
      const Both both(std::string(R"("camera": {"position": [0.6, -0.8, 1], "view_angle": 20}, )") +
        R"("lights": [{"type": "directional", "direction": [0.8, -0.5, -1]}],
        "nodes": [{"transform": {)" +
        transform + R"(}, "mesh": {"shape": "plane", "size": [4, 4]},
          "mesostructure": {"technique": "relief", "quality": "high", "scale": 0.04,
            "tiles": [2, 3], "wrap": ")" +
        wrap + R"(", "height_map": {"pattern": "smooth", "size": [48, 32]}}}])");
      EXPECT_EQ(both.Coverage(), 1.) << transform << wrap;
      EXPECT_LT(48. * both.Difference("texcoord.u", 0.95), 0.01) << transform << wrap;
      EXPECT_LT(32. * both.Difference("texcoord.v", 0.95), 0.01) << transform << wrap;
      EXPECT_LT(both.Difference("normal.x", 0.95), 1e-2) << transform << wrap;
      EXPECT_LT(both.Difference("shadow.0", 0.99), 0.5) << transform << wrap;
    }
  }
}

TEST(ReferenceAgainstRender, ReliefOnATorusDicedByTheMappers)
{
  // The technique `tessellated` dices the same surface by code of its own, outlines included.
  const Both both(R"("camera": {"position": [0.2, 1.6, 3.6], "view_angle": 32},
    "nodes": [{"mesh": {"shape": "torus", "rings": 16, "sides": 10},
      "mesostructure": {"technique": "tessellated", "quality": "high", "scale": 0.1,
        "tiles": [3, 2], "height_map": {"pattern": "smooth", "size": [32, 32]}}}])");
  EXPECT_GT(both.Coverage(), 0.999);
  EXPECT_LT(32. * both.Difference("texcoord.u", 0.95), 0.02);
  EXPECT_LT(32. * both.Difference("texcoord.v", 0.95), 0.02);
  EXPECT_LT(both.Difference("depth", 0.95), 1e-2 * 0.1); // two facets a texel
}

TEST(ReferenceAgainstRender, ColorMaps)
{
  const std::string file =
    testing::TempDir() + "meso_reference_colors_" + std::to_string(getpid()) + ".png";
  vtkNew<vtkImageData> colors;
  colors->SetDimensions(4, 3, 1);
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(colors->GetScalarPointer());
  for (int i = 0; i < 36; ++i)
  {
    bytes[i] = static_cast<unsigned char>((i * 89) % 256);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(colors);
  writer->SetFileName(file.c_str());
  writer->Write();
  for (const char* wrap : { "repeat", "clamp", "mirror" })
  {
    const Both both(R"("camera": {"position": [0.2, 0.1, 2]},
      "nodes": [{"mesh": {"shape": "plane", "size": [2, 2]},
        "material": {"color_map": ")" +
      file + R"(", "color": [1, 0.9, 0.8]},
        "mesostructure": {"technique": "plain", "tiles": [2.5, 1.5], "wrap": ")" +
      wrap + R"("}}])");
    // Texture units weigh texels in steps of 1/256: neighbours that differ by 255 by one step each way.
    EXPECT_LT(both.ColorsApart(3), 2e-3) << wrap;
  }
  std::remove(file.c_str());
}

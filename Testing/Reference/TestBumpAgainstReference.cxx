// The techniques that leave the mesh where it is, beside the truth: seen from straight above, where nothing
// moves, normals and shadows are the truth's; a normal map replaces the truth's normals too.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>

namespace
{
constexpr int Width = 96;
constexpr int Height = 96;

/// Figures of a scene as drawn.
MesoGeometryError ErrorOf(const std::string& text)
{
  const MesoScene scene = MesoParseScene(text, "test.json");
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs);
  return MesoCompareGeometry(truth, DrawnAOVs(scene, Width, Height));
}

/// A plane from straight above, its chart under a node's matrix.
std::string FromAbove(
  const std::string& options, const std::string& matrix, const std::string& pattern)
{
  return R"({"meso": 1, "camera": {"position": [0, 0, 3], "parallel_scale": 0.35},
    "lights": [{"type": "directional", "direction": [-1, -0.3, -0.5]},
               {"type": "directional", "direction": [0.6, 0.8, -0.7]},
               {"type": "directional", "direction": [-0.1, 0.9, -0.4]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [2, 2]}, "transform": {"matrix": [)" +
    matrix + R"(]}, "mesostructure": {"scale": )" + (pattern == "smooth" ? "0.2" : "0.05") +
    R"(, "tiles": [4, 4], )" + options + R"(, "height_map": {"pattern": ")" + pattern +
    R"(", "size": [64, 64]}}}]})";
}

const char* const Straight = "1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1";
const char* const Sheared =
  "-1, 0.5, 0, 0,  0.2, 0.9, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1"; // and mirrored

/// A file for a test's normal map, gone with it.
class NormalMapFile
{
public:
  NormalMapFile()
    : Name(testing::TempDir() + "meso_normals_" + std::to_string(getpid()) + ".png")
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(24, 16, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 24 * 16; ++i)
    {
      const double s = std::sin(0.7 * (i % 24));
      const double t = std::cos(0.9 * (i / 24));
      *bytes++ = static_cast<unsigned char>(127.5 + 60. * s);
      *bytes++ = static_cast<unsigned char>(127.5 + 50. * t);
      *bytes++ = 225;
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->Name.c_str());
    writer->Write();
  }
  ~NormalMapFile() { std::remove(this->Name.c_str()); }

  const std::string Name;
};
}

TEST(BumpAgainstReference, NormalsFromAboveAreTheTruths)
{
  for (const char* matrix : { Straight, Sheared })
  {
    for (const char* technique : { "bump", "normal", "normal-object" })
    {
      const MesoGeometryError error =
        ErrorOf(FromAbove(std::string(R"("technique": ")") + technique + "\"", matrix, "smooth"));
      EXPECT_EQ(error.CoverageIou, 1.);
      // Bump has the truth's very slopes; maps interpolate unit normals of texels instead.
      EXPECT_LT(error.Normal.Maximum, std::string(technique) == "bump" ? 0.01 : 0.5)
        << technique << " " << matrix;
      EXPECT_LT(error.Texcoord.Maximum, 0.01);
    }
  }
}

TEST(BumpAgainstReference, HorizonsFromAboveCastTheTruthsShadows)
{
  for (const char* matrix : { Straight, Sheared })
  {
    for (const char* pattern : { "smooth", "brick" })
    {
      const MesoGeometryError bump = ErrorOf(FromAbove(R"("technique": "bump")", matrix, pattern));
      for (const char* quality : { "draft", "high" })
      {
        const MesoGeometryError error = ErrorOf(FromAbove(
          std::string(R"("technique": "horizon", "penumbra": 0, "quality": ")") + quality + "\"",
          matrix, pattern));
        std::cout << pattern << " " << quality << ": shadow_cast " << error.ShadowCast
                  << ", attached " << error.ShadowAttached << ", of bump " << bump.ShadowCast
                  << "\n";
        EXPECT_GT(bump.ShadowCast, 0.1) << pattern; // there are shadows
        EXPECT_LT(error.ShadowCast, std::string(quality) == "draft" ? 0.06 : 0.025)
          << pattern << " " << quality << " " << matrix;
      }
    }
  }
}

TEST(BumpAgainstReference, AGivenNormalMapReplacesTheTruthsNormals)
{
  const NormalMapFile file;
  const auto scene =
    [&](const std::string& mesh, const std::string& mesostructure, const std::string& way)
  {
    return R"({"meso": 1, "camera": {"position": [0.4, 1.5, 3]},
      "nodes": [{"mesh": )" +
      mesh + R"(, "transform": {"rotate": [30, 1, 0.4, 0], "scale": [-1, 0.8, 1.1]},
      "material": {"normal_map": ")" +
      file.Name + R"(", "normal_map_y": ")" + way + R"("}, "mesostructure": {"tiles": [3, 2], )" +
      mesostructure + "}}]}";
  };
  const std::string torus = R"({"shape": "torus", "rings": 96, "sides": 64})";
  const std::string plane = R"({"shape": "plane", "size": [2, 2], "segments": [4, 4]})";
  const std::string heights =
    R"("scale": 0.05, "height_map": {"pattern": "smooth", "size": [32, 32]})";
  for (const char* way : { "up", "down" })
  {
    // 8 bits, which llvmpipe's sampler rounds once more: up to sqrt(3) / 255 radians. On the torus the
    // tangents are those of vertices, interpolated; the truth's those of triangles.
    EXPECT_LT(ErrorOf(scene(torus, R"("technique": "normal")", way)).Normal.P95, 1.5) << way;
    EXPECT_LT(ErrorOf(scene(plane, R"("technique": "normal")", way)).Normal.Maximum, 0.8) << way;
    EXPECT_LT(ErrorOf(scene(plane, R"("technique": "normal-object")", way)).Normal.Maximum, 0.8)
      << way;
    // Relief on a plane hits where the truth does.
    EXPECT_LT(ErrorOf(scene(plane, R"("technique": "relief", "quality": "high", )" + heights, way))
                .Normal.P95,
      0.5)
      << way;
  }
}

TEST(BumpAgainstReference, WhatCannotShowANormalMapSaysSo)
{
  const NormalMapFile file;
  const MesoScene scene = MesoParseScene(R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane"},
    "material": {"normal_map": ")" +
      file.Name + R"("}, "mesostructure": {"technique": "tessellated", "scale": 0.1,
    "height_map": {"pattern": "smooth", "size": [8, 8]}}}]})",
    "test.json");
  vtkNew<vtkRenderer> renderer;
  MesoSceneBuilder builder;
  try
  {
    builder.Build(scene, renderer);
    FAIL();
  }
  catch (const MesoInputError& problem)
  {
    EXPECT_STREQ(problem.what(),
      "test.json: nodes[0].material.normal_map: technique tessellated shows the normals of the "
      "diced "
      "mesh, and no others");
  }
}

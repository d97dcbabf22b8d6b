#ifndef SceneFolder_h
#define SceneFolder_h

#include "MesoExr.h"
#include "MesoImageDifference.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <iterator>
#include <map>

/**
 * A scene file in a folder of its own, and what the program makes of it there. Pictures are
 * 64 x 48, for speed.
 *
 * Scenes here are seen along -z from z = 5 in parallel projection with half height 1.2, so that a
 * pixel is 0.05 wide and pixel (column, row), row 0 at the top, shows the point
 * x = 0.05 (column + 0.5 - 32), y = 0.05 (24 - row - 0.5).
 */
class SceneFolder
{
public:
  static constexpr int Width = 64;
  static constexpr int Height = 48;

  /// `rest` is what a scene has beside "meso" and "camera".
  explicit SceneFolder(const std::string& rest)
  {
    this->Folder.Write("scene.json",
      R"({"meso": 1, "camera": {"position": [0, 0, 5], "parallel_scale": 1.2}, )" + rest + "}");
  }

  /// Renders to <name>.png with more arguments; the job must succeed without a message.
  void Render(const std::vector<std::string>& more = {}, const std::string& name = "x")
  {
    this->Run("render", more, name);
  }

  /// The same by another verb.
  void Run(const std::string& verb, const std::vector<std::string>& more, const std::string& name)
  {
    std::vector<std::string> arguments = { verb, this->PathOf("scene.json"), "-o",
      this->PathOf(name + ".png"), "--size", "64x48" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    this->Pictures.erase(name);
    const MesoRun run = RunMeso(arguments);
    ASSERT_EQ(run.ExitCode, 0) << run.Messages;
    EXPECT_EQ(run.Messages, "");
    EXPECT_EQ(run.Output, "");
  }

  std::string PathOf(const std::string& name) const { return this->Folder.PathOf(name); }

  std::string Bytes(const std::string& name) const
  {
    std::ifstream file(this->PathOf(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  std::vector<std::string> Names() const
  {
    std::vector<std::string> names = this->Folder.Names();
    std::sort(names.begin(), names.end());
    return names;
  }

  /// RGB at a pixel of <name>.png, row 0 at the top; 256 where there is no such picture.
  std::array<int, 3> Color(int column, int row, const std::string& name = "x")
  {
    vtkSmartPointer<vtkImageData>& image = this->Pictures[name];
    if (!image)
    {
      image = MesoReadPNG(this->PathOf(name + ".png"));
    }
    if (!image || image->GetNumberOfScalarComponents() != 3)
    {
      return { 256, 256, 256 };
    }
    const auto* pixel = static_cast<unsigned char*>(
      image->GetScalarPointer(column, image->GetDimensions()[1] - 1 - row, 0));
    return { pixel[0], pixel[1], pixel[2] };
  }

  MesoImageDifference Compare(const std::string& name, const std::string& other) const
  {
    return MesoCompareImageFiles(
      this->PathOf(name + ".png"), this->PathOf(other + ".png"), MesoImageLimits::Exact());
  }

  /// Channels of <name>.aov.exr, in the order given.
  MesoExrImage AOVs(
    const std::vector<std::string>& channels = {}, const std::string& name = "x") const
  {
    return MesoReadExr(this->PathOf(name + ".aov.exr"), channels);
  }

  static double X(int column) { return 0.05 * (column + 0.5 - 0.5 * Width); }
  static double Y(int row) { return 0.05 * (0.5 * Height - row - 0.5); }

private:
  TemporaryFolder Folder;
  std::map<std::string, vtkSmartPointer<vtkImageData>> Pictures; // read so far
};

/// Nodes: a plane of 2 x 2 with rough bricks, 0.1 deep.
inline const char* const BrickPlane = R"("nodes": [{"name": "wall",
  "mesh": {"shape": "plane", "size": [2, 2]},
  "material": {"color": [0.8, 0.5, 0.4]},
  "mesostructure": {"technique": "relief", "scale": 0.1, "tiles": [2, 2],
                    "height_map": {"pattern": "brick", "size": [128, 64]}}}])";

/// The same, under a light from the upper left.
inline std::string LitBrickPlane()
{
  return std::string(R"("lights": [{"type": "directional", "direction": [1, -0.6, -0.6]}], )") +
    BrickPlane;
}

#endif

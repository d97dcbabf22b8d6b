// `meso bake vdm`: what the file holds, that a scene needs nothing beside it, what is refused.

#include "MesoBakedFile.h"
#include "RunMeso.h"
#include "SceneFolder.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace
{
/// A step down the middle, 16 x 16 texels of 8 bits.
void WriteStep(const std::string& fileName)
{
  std::ofstream file(fileName, std::ios::binary);
  file << "P5\n16 16\n255\n";
  for (int i = 0; i < 256; ++i)
  {
    file << static_cast<char>(i % 16 < 8 ? 255 : 40);
  }
}

MesoRun BakeSmall(
  const std::string& map, const std::string& table, const std::vector<std::string>& more = {})
{
  std::vector<std::string> arguments = { "bake", "vdm", map, "-o", table, "--size", "16x16",
    "--directions", "8x6", "--curvatures", "3,-1,1", "--depth", "0.1" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunMeso(arguments);
}

/// A plane of 2 x 2, seen aslant; what is drawn of it is to be added.
std::string Plane(const std::string& mesostructure)
{
  return R"("lights": [{"type": "directional", "direction": [0.6, -0.2, -1]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [2, 2]}, "transform": {"rotate": [40, 0, 1, 0]},
    "mesostructure": {"scale": 0.1, "tiles": [2, 2], )" +
    mesostructure + "}}]";
}
}

TEST(MesoBakeVDM, KeepsFactorsAndTheMap)
{
  const TemporaryFolder folder;
  WriteStep(folder.PathOf("step.pgm"));
  const MesoRun run = BakeSmall(folder.PathOf("step.pgm"), folder.PathOf("a.vdm.vti"));
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const MesoBaked baked = MesoReadBaked(folder.PathOf("a.vdm.vti"), "vdm");
  int size[3];
  baked.Table->GetDimensions(size);
  EXPECT_EQ(size[0], 16);
  EXPECT_EQ(size[1], 16);
  vtkDataArray* heights = baked.Table->GetFieldData()->GetArray("Heights");
  ASSERT_TRUE(heights);
  ASSERT_EQ(heights->GetNumberOfValues(), 256);
  EXPECT_NEAR(heights->GetComponent(0, 0), 1., 1e-6);
  EXPECT_NEAR(heights->GetComponent(12, 0), 40. / 255., 1e-6);
}

TEST(MesoBakeVDM, AFileIsAllThatASceneNeeds)
{
  SceneFolder baked(Plane(R"("technique": "vdm", "quality": "full", "baked": "a.vdm.vti")"));
  WriteStep(baked.PathOf("step.pgm"));
  ASSERT_EQ(
    BakeSmall(baked.PathOf("step.pgm"), baked.PathOf("a.vdm.vti"), { "--rank", "0,0" }).ExitCode,
    0);
  baked.Render({ "--aov", "all" }, "vdm");
  baked.Run("reference", { "--aov", "all" }, "truth");

  SceneFolder mapped(Plane(R"("technique": "relief", "height_map": "step.pgm")"));
  WriteStep(mapped.PathOf("step.pgm"));
  mapped.Run("reference", { "--aov", "all" }, "truth");

  const auto mean = [](
                      const SceneFolder& scene, const std::string& name, const std::string& channel)
  {
    const MesoExrImage image = MesoReadExr(scene.PathOf(name + ".aov.exr"));
    const auto find = [&](const std::string& wanted)
    {
      return std::find(image.ChannelNames.begin(), image.ChannelNames.end(), wanted) -
        image.ChannelNames.begin();
    };
    const std::size_t step = image.ChannelNames.size();
    double sum = 0.;
    double covered = 0.;
    for (std::size_t i = 0; i < image.Data.size(); i += step)
    {
      sum += image.Data[i + find(channel)];
      covered += image.Data[i + find("coverage")];
    }
    return sum / covered;
  };
  // The reference draws the map that the table was baked from, and the table what the reference draws.
  EXPECT_NEAR(mean(baked, "truth", "relief"), mean(mapped, "truth", "relief"), 1e-6);
  EXPECT_GT(mean(mapped, "truth", "relief"), 0.3);
  EXPECT_NEAR(mean(baked, "vdm", "relief"), mean(mapped, "truth", "relief"), 0.03);
}

TEST(MesoBakeVDM, RefusesWhatMakesNoSense)
{
  const TemporaryFolder folder;
  WriteStep(folder.PathOf("step.pgm"));
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
    { { "--depth", "0" }, "--depth" }, { { "--directions", "8" }, "--directions" },
    { { "--curvatures", "3,1" }, "--curvatures" }, { { "--rank", "8" }, "--rank" },
    { { "--bits", "7" }, "--bits" }, { { "--nodes", "round" }, "round" },
    { { "--stores", "colour" }, "colour" }, { { "--curved", "flat" }, "flat" }
  };
  for (const auto& [options, part] : cases)
  {
    std::vector<std::string> arguments = { "bake", "vdm", folder.PathOf("step.pgm"), "-o",
      folder.PathOf("a.vti") };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const MesoRun run = RunMeso(arguments);
    EXPECT_EQ(run.ExitCode, 2) << part;
    EXPECT_NE(run.Messages.find(part), std::string::npos) << run.Messages;
  }
  EXPECT_EQ(folder.Names(), (std::vector<std::string>{ "step.pgm" }));
}

TEST(MesoBakeVDM, FilesThatAreNoTablesAreRefused)
{
  SceneFolder scene(Plane(R"("technique": "vdm", "baked": "a.vdm.vti")"));
  WriteStep(scene.PathOf("step.pgm"));
  const std::string file = scene.PathOf("a.vdm.vti");
  ASSERT_EQ(BakeSmall(scene.PathOf("step.pgm"), file).ExitCode, 0);
  const MesoBaked whole = MesoReadBaked(file, "vdm");
  const auto bytes = [&]
  {
    std::ifstream stream(file, std::ios::binary);
    return std::string{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  };
  const std::string text = bytes();
  const auto expect = [&](const std::string& says)
  {
    const MesoRun run = RunMeso(
      { "render", scene.PathOf("scene.json"), "-o", scene.PathOf("none.png"), "--size", "32x32" });
    EXPECT_EQ(run.ExitCode, 1) << says;
    EXPECT_NE(run.Messages.find("a.vdm.vti"), std::string::npos) << run.Messages;
    EXPECT_NE(run.Messages.find(says), std::string::npos) << run.Messages;
    EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
    EXPECT_FALSE(std::ifstream(scene.PathOf("none.png")));
  };
  // With a right checksum, but not what a table is.
  const auto with = [&](const auto& change, const std::string& says)
  {
    MesoBaked changed = whole;
    changed.Table = vtkSmartPointer<vtkImageData>::New();
    changed.Table->DeepCopy(whole.Table);
    change(changed.Table->GetFieldData());
    MesoWriteBaked(file, changed);
    expect(says);
  };
  with([](vtkFieldData* data) { data->GetArray("Heights")->SetTuple1(7, std::nan("")); },
    "holds the height nan at 7");
  with([](vtkFieldData* data) { data->GetArray("VDMFunctions")->SetComponent(3, 1, HUGE_VAL); },
    "VDMFunctions holds inf");
  with([](vtkFieldData* data) { data->GetArray("VDMSizes")->SetTuple1(0, 17.); },
    "not of the table's size");
  // Damaged.
  const auto holding = [&](const std::string& changed, const std::string& says)
  {
    std::ofstream(file, std::ios::binary) << changed;
    expect(says);
  };
  holding(text.substr(0, text.size() / 2), "damaged");
  holding("", "");
}

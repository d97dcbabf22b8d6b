// `meso bake gdm`: of built-in volumes, files and meshes, and what is refused.

#include "MesoBakedFile.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace
{
class GDMFolder : public TemporaryFolder
{
public:
  MesoRun Bake(const std::string& input, const std::vector<std::string>& options) const
  {
    std::vector<std::string> arguments = { "bake", "gdm", input, "-o", this->PathOf("a.gdm.vti") };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunMeso(arguments);
  }

  /// The same in tables small enough for a test.
  MesoRun BakeSmall(const std::string& input, std::vector<std::string> options) const
  {
    options.insert(options.end(), { "--directions", "4x6" });
    return this->Bake(input, options);
  }
};

void ExpectRefused(const MesoRun& run, int code, const std::string& part)
{
  EXPECT_EQ(run.ExitCode, code);
  EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
  EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n" << run.Messages;
}

/// A volume of text: a slab that is solid where numbers are 10, 4 x 4 x 4 samples.
const std::string Slab = []()
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: text\n\n";
  for (int i = 0; i < 64; ++i)
  {
    text += i / 16 == 1 ? "10 " : "0 ";
  }
  return text;
}();

const std::string Tetrahedron = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 2\n";
}

TEST(MesoBakeGDM, KeepsTheTableOfABuiltInVolumeWithWhatItIsOf)
{
  const GDMFolder folder;
  const MesoRun run = folder.BakeSmall("weave",
    { "--size", "16x16x8", "--rank", "6", "--json", "--stats", folder.PathOf("s.json"),
      "--parameter", "threads=2" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const MesoBaked baked = MesoReadBaked(folder.PathOf("a.gdm.vti"), "gdm");
  EXPECT_EQ(std::get<std::vector<double>>(baked.Parameters.at("rank")), std::vector<double>{ 6. });
  vtkDataArray* weights = baked.Table->GetPointData()->GetArray("MesoGDMWeights");
  ASSERT_TRUE(weights);
  EXPECT_EQ(weights->GetNumberOfComponents(), 6);
  EXPECT_EQ(weights->GetNumberOfTuples(), 16 * 16 * 4);
  EXPECT_EQ(weights->GetDataType(), VTK_UNSIGNED_SHORT);
  vtkDataArray* functions = baked.Table->GetFieldData()->GetArray("MesoGDMFunctions");
  ASSERT_TRUE(functions);
  EXPECT_EQ(functions->GetNumberOfTuples(), 6 * 8);
  const auto report = nlohmann::json::parse(run.Output);
  EXPECT_EQ(report["bytes"], 16 * 16 * 4 * 6 * 2 + 6 * 8 * 6 * 4);
  EXPECT_EQ(report["rms_left_by_rank"].size(), 6u);
  EXPECT_GT(report["rms_left_by_rank"][0], report["rms_left_by_rank"][5]);
}

TEST(MesoBakeGDM, OfASlabOfAFileIsItsDistance)
{
  const GDMFolder folder;
  const MesoRun run = folder.Bake(
    folder.Write("slab.nrrd", Slab), { "--rank", "0", "--bits", "32", "--directions", "4x3" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const MesoBaked baked = MesoReadBaked(folder.PathOf("a.gdm.vti"), "gdm");
  vtkDataArray* distances = baked.Table->GetPointData()->GetArray("MesoGDMDistances");
  ASSERT_EQ(distances->GetNumberOfComponents(), 3 * 4);
  // Solid in z from 1/4 to 1/2 of a shell one tile thick: from the top straight down it is half a tile.
  EXPECT_NEAR(distances->GetComponent(0, 2 * 4 + 3), 0.5, 1e-3);
  EXPECT_NEAR(distances->GetComponent(0, 0 * 4 + 3), 0., 1e-6);   // up, out of the shell
  EXPECT_NEAR(distances->GetComponent(0, 0 * 4 + 0), 0.25, 1e-3); // up from the bottom
}

TEST(MesoBakeGDM, RefusesWhatMakesNoSense)
{
  const GDMFolder folder;
  ExpectRefused(folder.Bake("none.nrrd", {}), 1, "no such file");
  ExpectRefused(folder.Bake("wool", {}), 1, "wool");
  ExpectRefused(folder.Bake("weave", { "--size", "64x64" }), 2, "64x64x32");
  ExpectRefused(folder.Bake("weave", { "--size", "1x64x32" }), 2, "2 to 512");
  ExpectRefused(folder.Bake("weave", { "--directions", "4x1" }), 2, "1x2");
  ExpectRefused(folder.Bake("weave", { "--rank", "65" }), 2, "--rank");
  ExpectRefused(folder.Bake("weave", { "--bits", "12" }), 2, "--bits");
  ExpectRefused(folder.Bake("weave", { "--parameter", "threads" }), 2, "KEY=NUMBER");
  ExpectRefused(folder.Bake("weave", { "--parameter", "threads=3" }), 1, "even");
  ExpectRefused(folder.Bake("weave", { "--crop", "0,1,0,1,1,0" }), 2, "X0,X1");
  const std::string slab = folder.Write("slab.nrrd", Slab);
  ExpectRefused(folder.Bake(slab, { "--crop", "0,9,0,4,0,4" }), 1, "not within");
  ExpectRefused(folder.Bake(slab, { "--crop", "0,3.5,0,4,0,4" }), 1, "whole numbers");
  ExpectRefused(
    folder.Bake(folder.Write("open.obj", Tetrahedron + "f 1 3 2\nf 1 2 4\n"), {}), 1, "not closed");
  EXPECT_EQ(folder.Names().size(), 2u);
}

TEST(MesoBakeGDM, TakesAClosedMesh)
{
  const GDMFolder folder;
  const std::string mesh =
    folder.Write("t.obj", Tetrahedron + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const MesoRun run = folder.BakeSmall(mesh, { "--size", "12x12x6", "--rank", "4" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const MesoBaked baked = MesoReadBaked(folder.PathOf("a.gdm.vti"), "gdm");
  vtkDataArray* volume = baked.Table->GetFieldData()->GetArray("MesoGDMVolume");
  EXPECT_EQ(baked.Table->GetFieldData()->GetArray("MesoVolumeDepth")->GetTuple1(0), 0.5);
  // Near the corner at the origin there is solid, far from it there is none.
  EXPECT_LT(volume->GetTuple1(12 * 12 + 12 + 1), 0.);
  EXPECT_GT(volume->GetTuple1(volume->GetNumberOfTuples() - 1), 0.);
}

TEST(MesoBakeGDM, SaysWhatItWarnsOf)
{
  const GDMFolder folder;
  std::string ramp = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 16 4 2\nencoding: text\n\n";
  for (int i = 0; i < 128; ++i)
  {
    ramp += std::to_string(10 * (i % 16)) + " ";
  }
  const MesoRun run = folder.BakeSmall(folder.Write("ramp.nrrd", ramp), { "--rank", "4" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_NE(run.Messages.find("does not tile in x"), std::string::npos) << run.Messages;
  EXPECT_EQ(run.Messages.find("does not tile in y"), std::string::npos) << run.Messages;
  const MesoRun empty =
    folder.BakeSmall(folder.PathOf("ramp.nrrd"), { "--rank", "4", "--threshold", "200" });
  EXPECT_NE(empty.Messages.find("all of the volume is empty"), std::string::npos) << empty.Messages;
}

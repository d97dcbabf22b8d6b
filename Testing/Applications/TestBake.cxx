// `meso bake`: what each kind writes, and what is refused.

#include "MesoBakedFile.h"
#include "MesoExr.h"
#include "MesoImageFile.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/// Bakes in a folder where ramp.png rises from 0 at the left to 1 at the right, 8 x 4 texels.
class BakeFolder
{
public:
  BakeFolder()
  {
    std::vector<float> heights;
    for (int i = 0; i < 8 * 4; ++i)
    {
      heights.push_back(static_cast<float>(i % 8) / 7.f);
    }
    MesoWriteImage(
      this->PathOf("ramp.png"), 8, 4, 1, MesoImageHeader::Type::UnsignedShort, heights.data());
  }

  std::string PathOf(const std::string& name) const { return this->Folder.PathOf(name); }
  std::size_t NumberOfFiles() const { return this->Folder.Names().size(); }

  MesoRun Bake(const std::string& kind, const std::string& output,
    const std::vector<std::string>& options = {}) const
  {
    std::vector<std::string> arguments = { "bake", kind, this->PathOf("ramp.png"), "-o",
      this->PathOf(output) };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunMeso(arguments);
  }

private:
  TemporaryFolder Folder;
};

void ExpectRefused(const MesoRun& run, int code, const std::string& part)
{
  EXPECT_EQ(run.ExitCode, code);
  EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
  EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n" << run.Messages;
}
}

TEST(MesoBake, NormalIsThatOfTheRampInEveryPrecision)
{
  const BakeFolder folder;
  // A rise of 8/7 over a tile of 2, 0.7 deep: slope 0.4.
  const std::vector<std::string> options = { "--scale", "0.7", "--tile-size", "2,1" };
  const double x = -0.4 / std::sqrt(1.16);
  const double z = 1. / std::sqrt(1.16);
  const auto with = [&](std::vector<std::string> more)
  {
    more.insert(more.end(), options.begin(), options.end());
    return more;
  };
  EXPECT_EQ(folder.Bake("normal", "n.exr", with({ "--bits", "32" })).ExitCode, 0);
  const MesoExrImage image = MesoReadExr(folder.PathOf("n.exr"), { "R", "G", "B" });
  ASSERT_EQ(image.Width, 8);
  ASSERT_EQ(image.Height, 4);
  EXPECT_NEAR(2. * image.At(3, 1, 0) - 1., x, 2e-5); // of a map of 16 bits
  EXPECT_NEAR(image.At(3, 1, 1), 0.5, 1e-6);
  EXPECT_NEAR(2. * image.At(3, 1, 2) - 1., z, 2e-5);

  for (const int bits : { 8, 16 })
  {
    const MesoRun run = folder.Bake("normal", "n.png", with({ "--bits", std::to_string(bits) }));
    EXPECT_EQ(run.ExitCode, 0);
    EXPECT_EQ(run.Messages, "");
    MesoImageInput input(folder.PathOf("n.png"));
    ASSERT_EQ(input.Header().NumberOfValues(), 8u * 4 * 3);
    ASSERT_EQ(input.Header().BytesPerValue(), bits / 8u);
    std::vector<unsigned short> values(8 * 4 * 3);
    input.Read(values.data(), MesoImageInput::RowOrder::TopFirst);
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    const double most = std::ldexp(1., bits) - 1.;
    const double red = bits == 8 ? bytes[(8 + 3) * 3] : values[(8 + 3) * 3];
    EXPECT_NEAR(red, (0.5 * x + 0.5) * most, bits == 8 ? 0.51 : 1.5) << bits;
  }
}

TEST(MesoBake, NormalTurnsItsGreen)
{
  const BakeFolder folder;
  // Stored the other way up, so that it rises along v.
  MesoWriteImage(folder.PathOf("ramp.png"), 1, 2, 1, MesoImageHeader::Type::UnsignedChar,
    std::vector<float>{ 1.f, 0.f }.data());
  const auto green = [&](const std::string& y, const char* wrap)
  {
    EXPECT_EQ(
      folder.Bake("normal", "n.exr", { "--bits", "32", "--y", y, "--wrap", wrap }).ExitCode, 0);
    return MesoReadExr(folder.PathOf("n.exr"), { "G" }).At(0, 0, 0);
  };
  EXPECT_LT(green("up", "clamp"), 0.49f);
  EXPECT_FLOAT_EQ(green("down", "clamp"), 1.f - green("up", "clamp"));
  EXPECT_FLOAT_EQ(green("up", "repeat"), 0.5f); // up and down again
}

TEST(MesoBake, ConesAndMaximaAreKeptInBakedFiles)
{
  const BakeFolder folder;
  ASSERT_EQ(folder.Bake("cone", "ramp.cone.vti", { "--wrap", "clamp" }).ExitCode, 0);
  const MesoBaked cones = MesoReadBaked(folder.PathOf("ramp.cone.vti"), "cone");
  EXPECT_EQ(std::get<std::string>(cones.Parameters.at("wrap")), "clamp");
  vtkPointData* arrays = cones.Table->GetPointData();
  vtkDataArray* apex = arrays->GetArray("ConeApex");
  vtkDataArray* steepness = arrays->GetScalars("ConeSteepness");
  ASSERT_TRUE(apex && steepness);
  // From the left end rightwards: the patch ahead is 6/7 deep, and the right end, 7 texels away, is the
  // texel that a cone from there must be steepest for. A quarter more is allowed.
  EXPECT_EQ(apex->GetComponent(0, 0), std::floor(255. * 6. / 7.));
  const double least = std::floor(255. * 6. / 7.) / 255. / 7.;
  EXPECT_GE(steepness->GetComponent(0, 0), std::floor(255. * std::sqrt(2. * least)));
  EXPECT_LE(steepness->GetComponent(0, 0), std::ceil(255. * std::sqrt(2.5 * least)));
  // From the right end leftwards all is lower.
  EXPECT_EQ(apex->GetComponent(7, 1), 0.);
  EXPECT_EQ(steepness->GetComponent(7, 1), 0.);

  ASSERT_EQ(folder.Bake("maxmip", "ramp.maxmip.vti").ExitCode, 0);
  const MesoBaked maxima = MesoReadBaked(folder.PathOf("ramp.maxmip.vti"), "maxmip");
  EXPECT_EQ(std::get<std::string>(maxima.Parameters.at("wrap")), "repeat");
  EXPECT_NEAR(
    maxima.Table->GetPointData()->GetScalars("Maximum")->GetComponent(0, 0), 1. / 7., 1e-4);
  vtkDataArray* top = maxima.Table->GetFieldData()->GetArray("Maximum3");
  ASSERT_TRUE(top);
  ASSERT_EQ(top->GetNumberOfTuples(), 1);
  EXPECT_EQ(top->GetComponent(0, 0), 1.);
}

TEST(MesoBake, StatsSayWhatItTook)
{
  const BakeFolder folder;
  EXPECT_EQ(folder.Bake("normal", "n.png", { "--stats", folder.PathOf("s.json") }).ExitCode, 0);
  std::ifstream file(folder.PathOf("s.json"));
  const auto stats = nlohmann::json::parse(file);
  EXPECT_EQ(stats["kind"], "normal");
  EXPECT_EQ(stats["size"], nlohmann::json({ 8, 4, 1 }));
  EXPECT_GT(stats["bake_s"], 0.);
  EXPECT_GT(stats["peak_memory_bytes"], 1000000);
}

TEST(MesoBake, RefusesWhatMakesNoSense)
{
  const BakeFolder folder;
  ExpectRefused(RunMeso({ "bake" }), 2, "A kind of bake is required");
  ExpectRefused(RunMeso({ "bake", "cake" }), 2, "cake");
  ExpectRefused(folder.Bake("normal", "n.png", { "--range", "2,1" }), 2, "--range: '2,1'");
  ExpectRefused(folder.Bake("normal", "n.png", { "--wrap", "round" }), 2, "repeat, clamp, mirror");
  ExpectRefused(folder.Bake("normal", "n.png", { "--tile-size", "1,0" }), 2, "--tile-size: '1,0'");
  ExpectRefused(folder.Bake("normal", "n.png", { "--bits", "12" }), 2, "--bits");
  ExpectRefused(folder.Bake("normal", "n.png", { "--bits", "32" }), 1, ".exr or .tif");
  ExpectRefused(folder.Bake("normal", "n.jpg"), 1, ".png or .tif");
  ExpectRefused(folder.Bake("normal", "ramp.png"), 1, "is read, so a result cannot go to it");
  ExpectRefused(folder.Bake("normal", "none/n.png"), 1, "there is no folder");
  EXPECT_EQ(folder.NumberOfFiles(), 1u);
}

namespace
{
/// A wall of two squares that differ in depth, and the flat square that it is baked onto.
class MeshFolder
{
public:
  MeshFolder()
  {
    this->Folder.Write("base.obj",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    this->Folder.Write("bare.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    // The left half lies 0.1 below the base, the right half 0.3 above it.
    this->Folder.Write("detail.obj",
      "v 0 0 -.1\nv .5 0 -.1\nv .5 1 -.1\nv 0 1 -.1\n"
      "v .5 0 .3\nv 1 0 .3\nv 1 1 .3\nv .5 1 .3\nf 1 2 3 4\nf 5 6 7 8\n");
  }
  std::string PathOf(const std::string& name) const { return this->Folder.PathOf(name); }
  std::vector<std::string> Names() const { return this->Folder.Names(); }

  MesoRun Bake(const std::string& base, const std::vector<std::string>& options) const
  {
    std::vector<std::string> arguments = { "bake", "from-mesh", this->PathOf("detail.obj"),
      this->PathOf(base), "-o", this->PathOf("h.exr"), "--size", "16x8", "--reach", "0.5" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunMeso(arguments);
  }

private:
  TemporaryFolder Folder;
};
}

TEST(MesoBake, FromMeshSaysHowItsHeightsAreMeant)
{
  const MeshFolder folder;
  const MesoRun run = folder.Bake("base.obj",
    { "--json", "--slope-limit", "5", "--normal", folder.PathOf("n.exr"), "--state",
      folder.PathOf("s.png") });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const auto report = nlohmann::json::parse(run.Output);
  EXPECT_NEAR(report["scale"], 0.4, 1e-7);
  EXPECT_NEAR(report["reference"], 0.25, 1e-6);
  EXPECT_EQ(report["met_texels"], 128);
  EXPECT_EQ(report["void_texels"], 0);
  EXPECT_EQ(report["fold_texels"], 16) << "the texels on either side of the step";
  const MesoExrImage heights = MesoReadExr(folder.PathOf("h.exr"), {});
  EXPECT_EQ(heights.Width, 16);
  EXPECT_NEAR(heights.At(2, 3, 0), 0., 1e-6);
  EXPECT_NEAR(heights.At(12, 3, 0), 1., 1e-6);
  EXPECT_NEAR(MesoReadExr(folder.PathOf("n.exr"), { "B" }).At(2, 3, 0), 1., 1e-6);
  MesoImageInput states(folder.PathOf("s.png"));
  std::vector<unsigned char> values(states.Header().NumberOfValues());
  states.Read(values.data(), MesoImageInput::RowOrder::TopFirst);
  EXPECT_EQ(values[2], 85);
  EXPECT_EQ(values[7], 255);
}

TEST(MesoBake, FromMeshRefusesWhatMakesNoSense)
{
  const MeshFolder folder;
  ExpectRefused(folder.Bake("bare.obj", {}), 1, "has no texture coordinates");
  ExpectRefused(folder.Bake("base.obj", { "--array", "Color" }), 2, "no NAME=FILE");
  ExpectRefused(
    folder.Bake("base.obj", { "--array", "Color=" + folder.PathOf("c.png") }), 1, "named Color");
  ExpectRefused(folder.Bake("base.obj", { "--rays", "bent" }), 2, "interpolated, geometric");
  ExpectRefused(folder.Bake("base.obj", { "--curvature", folder.PathOf("c.png") }), 2, ".exr");
  ExpectRefused(folder.Bake("base.obj", { "--normal", folder.PathOf("base.obj") }), 1, "is read");
  EXPECT_EQ(folder.Names().size(), 3u);
}

TEST(MesoBake, HorizonOfTheRampSeesItsOwnWall)
{
  const BakeFolder folder;
  const MesoRun run = folder.Bake(
    "horizon", "ramp.horizon.vti", { "--azimuths", "4", "--scale", "0.5", "--wrap", "clamp" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const MesoBaked baked = MesoReadBaked(folder.PathOf("ramp.horizon.vti"), "horizon");
  EXPECT_EQ(
    std::get<std::vector<double>>(baked.Parameters.at("scale")), std::vector<double>{ 0.5 });
  EXPECT_EQ(std::get<std::string>(baked.Parameters.at("wrap")), "clamp");
  vtkDataArray* horizon = baked.Table->GetPointData()->GetArray("Horizon");
  ASSERT_EQ(horizon->GetNumberOfComponents(), 4);
  // Uphill the ramp itself, 8/7 a tile; downhill and across nothing. 16 bits round heights.
  EXPECT_NEAR(horizon->GetComponent(8 + 3, 0), std::atan(0.5 * 8. / 7.), 1e-4);
  EXPECT_EQ(horizon->GetComponent(8 + 3, 2), 0.);
  const double cosine = std::cos(horizon->GetComponent(8 + 3, 0));
  double across = 3.;
  for (const int k : { 1, 3 })
  {
    const double part = std::cos(horizon->GetComponent(8 + 3, k));
    across += part * part - 1.;
  }
  EXPECT_NEAR(baked.Table->GetPointData()->GetArray("AmbientOcclusion")->GetComponent(8 + 3, 0),
    (across + cosine * cosine) / 4., 1e-6);
  ExpectRefused(folder.Bake("horizon", "b.vti", { "--azimuths", "3" }), 2, "--azimuths");
}

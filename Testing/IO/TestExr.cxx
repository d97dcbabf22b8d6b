// EXR files by channel name, and files that are written whole or not at all.

#include "MesoAtomicFile.h"
#include "MesoExr.h"
#include "MesoScene.h" // for MesoInputError
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{
const std::vector<std::string> Names = { "texcoord.v", "depth", "normal.x", "R", "shadow.0" };

std::vector<float> Values(int width, int height, std::size_t channels)
{
  std::vector<float> values;
  for (std::size_t i = 0; i < std::size_t(width) * height * channels; ++i)
  {
    values.push_back(0.1f * float(i) - 1.f);
  }
  return values;
}

std::string ReadBytes(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

template <typename Action>
std::string MessageOf(const Action& action)
{
  try
  {
    action();
  }
  catch (const MesoInputError& error)
  {
    return error.what();
  }
  return "done without an error";
}
}

TEST(Exr, ChannelsAreReadByNameBitForBit)
{
  const TemporaryFolder folder;
  const std::string name = folder.PathOf("a.exr");
  auto values = Values(7, 3, Names.size());
  values[11] = std::numeric_limits<float>::quiet_NaN();
  values[12] = -0.f;
  values[13] = 1e-42f;
  MesoWriteExr(name, 7, 3, Names, values.data());
  const MesoExrImage image = MesoReadExr(name, Names);
  EXPECT_EQ(image.Width, 7);
  EXPECT_EQ(image.Height, 3);
  ASSERT_EQ(image.Data.size(), values.size());
  EXPECT_EQ(0, std::memcmp(image.Data.data(), values.data(), values.size() * sizeof(float)));

  const MesoExrImage two = MesoReadExr(name, { "shadow.0", "depth" });
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 7; ++column)
    {
      const float* pixel = &values[(std::size_t(row) * 7 + column) * Names.size()];
      EXPECT_EQ(two.At(column, row, 0), pixel[4]);
      EXPECT_TRUE(two.At(column, row, 1) == pixel[1] || std::isnan(pixel[1]));
    }
  }
  EXPECT_EQ(MesoReadExr(name).ChannelNames.size(), Names.size());
}

TEST(Exr, KeepsAttributesAndGivesTheSameBytes)
{
  const TemporaryFolder folder;
  const auto values = Values(2, 2, 1);
  const MesoExrAttributes attributes = { { "meso.depth", 0.1 },
    { "meso.technique", std::string("relief") } };
  MesoWriteExr(folder.PathOf("a.exr"), 2, 2, { "depth" }, values.data(), attributes);
  MesoWriteExr(folder.PathOf("b.exr"), 2, 2, { "depth" }, values.data(), attributes);
  EXPECT_EQ(ReadBytes(folder.PathOf("a.exr")), ReadBytes(folder.PathOf("b.exr")));
  const auto read = MesoReadExr(folder.PathOf("a.exr")).Attributes;
  EXPECT_TRUE(!read.count("DateTime") || std::get<std::string>(read.at("DateTime")).empty());
  EXPECT_EQ(std::get<double>(read.at("meso.depth")), 0.1);
  EXPECT_EQ(std::get<std::string>(read.at("meso.technique")), "relief");
}

TEST(Exr, RefusalsLeaveNothingBehind)
{
  const TemporaryFolder folder;
  const auto values = Values(2, 2, 2);
  const std::string name = folder.PathOf("a.exr");
  const auto write = [&](int width, const std::vector<std::string>& channels, const float* data)
  { return MessageOf([&] { MesoWriteExr(name, width, 2, channels, data); }); };
  EXPECT_EQ(
    write(0, { "R" }, values.data()), name + ": cannot be written with 0 x 2 pixels (1 to 16384)");
  EXPECT_NE(write(2, {}, values.data()).find("must have names"), std::string::npos);
  EXPECT_NE(write(2, { "R", "R" }, values.data()).find("all different"), std::string::npos);
  EXPECT_NE(write(2, { "R" }, nullptr).find("no pixels"), std::string::npos);
  EXPECT_TRUE(folder.Names().empty());
  EXPECT_NE(
    MessageOf([&] { MesoWriteExr(folder.PathOf("no/a.exr"), 2, 2, { "R" }, values.data()); })
      .find("there is no folder"),
    std::string::npos);

  MesoWriteExr(name, 2, 2, { "R", "G" }, values.data());
  EXPECT_EQ(folder.Names(), (std::vector<std::string>{ "a.exr" }));
  EXPECT_EQ(MessageOf([&] { MesoReadExr(name, { "depth" }); }),
    name + ": has no channel \"depth\" (it has R, G)");
  EXPECT_NE(MessageOf([&] { MesoReadExr(folder.PathOf("b.exr")); }).find("no such file"),
    std::string::npos);
}

TEST(AtomicFile, ReplacesOnlyOnCommit)
{
  const TemporaryFolder folder;
  const std::string name = folder.Write("out.json", "old");
  std::string temporary;
  {
    MesoAtomicFile atomic(name);
    temporary = atomic.TemporaryName();
    EXPECT_EQ(std::filesystem::path(temporary).extension(), ".json");
    EXPECT_EQ(
      std::filesystem::path(temporary).parent_path(), std::filesystem::path(name).parent_path());
    std::ofstream(temporary) << "half";
  }
  EXPECT_EQ(ReadBytes(name), "old");
  EXPECT_FALSE(std::filesystem::exists(temporary));
  MesoAtomicFile::Write(name, "new", 3);
  EXPECT_EQ(ReadBytes(name), "new");
  EXPECT_EQ(folder.Names().size(), 1u);
}

TEST(AtomicFile, TwoAtOnceDoNotMeet)
{
  const TemporaryFolder folder;
  MesoAtomicFile first(folder.PathOf("a"));
  MesoAtomicFile second(folder.PathOf("a"));
  EXPECT_NE(first.TemporaryName(), second.TemporaryName());
}

TEST(AtomicFile, FollowsLinksAndRefusesWhatIsNoFile)
{
  const TemporaryFolder folder;
  folder.Write("target", "old");
  std::filesystem::create_symlink("target", folder.PathOf("link"));
  MesoAtomicFile::Write(folder.PathOf("link"), "new", 3);
  EXPECT_EQ(ReadBytes(folder.PathOf("target")), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.PathOf("link")));
  EXPECT_THROW(MesoAtomicFile(folder.PathOf("")), MesoInputError);
  EXPECT_THROW(MesoAtomicFile(""), MesoInputError);
  EXPECT_THROW(MesoAtomicFile("/dev/null"), MesoInputError);
  EXPECT_THROW(MesoAtomicFile(folder.PathOf("none/a")), MesoInputError);
  MesoAtomicFile unwritten(folder.PathOf("b"));
  EXPECT_THROW(unwritten.Commit(), MesoInputError);
  EXPECT_FALSE(std::filesystem::exists(folder.PathOf("b")));
}

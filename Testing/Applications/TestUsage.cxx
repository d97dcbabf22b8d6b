// Help, and what the program says to wrong usage: exit code 2 and one line that tells what to do.

#include "RunMeso.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// The run was refused as wrong usage by one line with all these parts in it.
void ExpectRefused(const std::vector<std::string>& arguments, const std::vector<std::string>& parts)
{
  const MesoRun run = RunMeso(arguments);
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_EQ(run.Output, "");
  EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
  EXPECT_EQ(run.Messages.rfind("meso: ", 0), 0u) << run.Messages;
  for (const std::string& part : parts)
  {
    EXPECT_TRUE(Contains(run.Messages, part)) << part << "\nis not in\n" << run.Messages;
  }
}

/// `meso render` with a scene and an output, which do not come to be read or written.
void ExpectOptionsRefused(
  const std::vector<std::string>& options, const std::vector<std::string>& parts)
{
  const TemporaryFolder folder;
  std::vector<std::string> arguments = { "render", folder.PathOf("scene.json"), "-o",
    folder.PathOf("x.png") };
  arguments.insert(arguments.end(), options.begin(), options.end());
  ExpectRefused(arguments, parts);
  EXPECT_TRUE(folder.Names().empty());
}
}

TEST(MesoHelp, IsAskedForAndGiven)
{
  const MesoRun run = RunMeso({ "--help" });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_TRUE(Contains(run.Output, "Example: meso render ")) << run.Output;
  EXPECT_EQ(run.Messages, "");
}

TEST(MesoHelp, OfACommandNamesItsOptions)
{
  const MesoRun run = RunMeso({ "render", "--help" });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Messages, "");
  for (const char* part : { "Example: meso render ", "--output", "--size", "--technique",
         "--quality", "--effects", "--aov", "--samples", "--stats", "plain, bump",
         "draft, low, medium, high", "shading, occlusion, self_shadow, depth" })
  {
    EXPECT_TRUE(Contains(run.Output, part)) << part << "\nis not in\n" << run.Output;
  }
}

TEST(MesoHelp, OfCompareNamesItsOptions)
{
  const MesoRun run = RunMeso({ "compare", "--help" });
  EXPECT_EQ(run.ExitCode, 0);
  for (const char* part :
    { "Example: meso compare ", "--json", "--difference", "--classes", "hole" })
  {
    EXPECT_TRUE(Contains(run.Output, part)) << part << "\nis not in\n" << run.Output;
  }
}

TEST(MesoHelp, VersionIsOneLine)
{
  const MesoRun run = RunMeso({ "--version" });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Output.rfind("meso ", 0), 0u) << run.Output;
}

TEST(MesoUsage, NeedsACommandThatExists)
{
  ExpectRefused({}, { "ommand is required", "meso --help" });
  ExpectRefused({ "rendr", "scene.json" }, { "rendr", "meso --help" });
  ExpectRefused({ "--sise" }, { "--sise" });
}

TEST(MesoUsage, NeedsASceneAndAnOutput)
{
  ExpectRefused({ "compare", "x.png" }, { "TEST", "required", "meso compare --help" });
  ExpectRefused({ "render", "-o", "x.png" }, { "SCENE", "required", "meso render --help" });
  ExpectRefused({ "render", "scene.json" }, { "--output", "required" });
  ExpectRefused({ "render", "scene.json", "-o" }, { "--output" });
  ExpectOptionsRefused({ "second.json" }, { "second.json" });
}

TEST(MesoUsage, OutputIsAPng)
{
  ExpectRefused({ "render", "scene.json", "-o", "x.jpg" }, { "'x.jpg'", ".png" });
  ExpectRefused({ "render", "scene.json", "-o", "" }, { "''", ".png" });
}

TEST(MesoUsage, OptionsAreThoseOfTheHelp)
{
  ExpectOptionsRefused({ "--tecnique", "relief" }, { "--tecnique" });
}

TEST(MesoUsage, NamesTheChoices)
{
  ExpectOptionsRefused({ "--technique", "relif" }, { "--technique", "'relif'", "plain, bump" });
  ExpectOptionsRefused(
    { "--quality", "best" }, { "--quality", "'best'", "draft, low, medium, high" });
  ExpectOptionsRefused({ "--effects", "occlusion,shine" },
    { "--effects", "'shine'", "shading, occlusion, self_shadow, depth" });
  ExpectOptionsRefused({ "--aov", "depth,uv" }, { "--aov", "'uv'", "texcoord", "all" });
}

TEST(MesoUsage, EmptyNamesAreRefused)
{
  ExpectOptionsRefused({ "--aov", "" }, { "--aov", "''" });
  ExpectOptionsRefused({ "--aov", "depth," }, { "--aov", "''" });
  ExpectOptionsRefused({ "--effects", "" }, { "--effects", "''" });
  ExpectOptionsRefused({ "--stats", "" }, { "--stats", "''" });
}

TEST(MesoUsage, SizeIsTwoNumbers)
{
  for (const char* size : { "10", "0x5", "8x8x8", "20000x5", "" })
  {
    ExpectOptionsRefused({ "--size", size }, { "--size", "'" + std::string(size) + "'" });
  }
}

TEST(MesoUsage, SamplesAreANumber)
{
  for (const char* samples : { "0", "many", "1.5" })
  {
    ExpectOptionsRefused({ "--samples", samples }, { "--samples", samples });
  }
}

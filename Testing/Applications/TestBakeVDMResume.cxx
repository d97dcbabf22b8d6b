// `meso bake vdm` that is killed goes on from what it had finished.

#include "RunMeso.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace
{
namespace fs = std::filesystem;

std::string ContentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

class BakeVDMResume : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string map = "P5\n32 32\n255\n";
    for (int i = 0; i < 32 * 32; ++i)
    {
      map += static_cast<char>(40 + i * 7919 % 211);
    }
    this->Folder.Write("map.pgm", map);
    setenv("MESO_CACHE", this->Folder.PathOf("kept").c_str(), 1);
  }
  void TearDown() override { setenv("MESO_CACHE", "", 1); }

  std::vector<std::string> Arguments(const std::string& output, const char* patience = "0") const
  {
    return { "bake", "vdm", this->Folder.PathOf("map.pgm"), "-o", this->Folder.PathOf(output),
      "--size", "32x32", "--directions", "90x8", "--resume-after", patience, "--stats",
      this->Folder.PathOf(output + ".json") };
  }

  /// Parts that lie in the cache.
  int CountParts() const
  {
    std::error_code error;
    int count = 0;
    for (fs::recursive_directory_iterator entry(this->Folder.PathOf("kept"), error), end;
         !error && entry != end; entry.increment(error))
    {
      const std::string name = entry->path().filename().string();
      count += entry->is_regular_file(error) && name[0] != '.' ? 1 : 0;
    }
    return count;
  }

  TemporaryFolder Folder;
};
}

TEST_F(BakeVDMResume, AKilledBakeGoesOnFromWhereItWas)
{
  // Not killed, and nothing kept before it is done.
  ASSERT_EQ(RunMeso(this->Arguments("whole.vti", "1000")).ExitCode, 0);
  EXPECT_FALSE(fs::exists(this->Folder.PathOf("kept")));

  const int process = StartMeso(this->Arguments("killed.vti"));
  const auto start = std::chrono::steady_clock::now();
  while (
    this->CountParts() < 3 && std::chrono::steady_clock::now() - start < std::chrono::minutes(1))
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(process, SIGKILL);
  EXPECT_EQ(WaitForMeso(process), -1);
  EXPECT_FALSE(fs::exists(this->Folder.PathOf("killed.vti")));
  const int parts = this->CountParts();
  EXPECT_GE(parts, 3);
  EXPECT_LT(parts, 90);

  const MesoRun run = RunMeso(this->Arguments("killed.vti"));
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_NE(run.Output.find("went on from " + std::to_string(parts) + " of 90"), std::string::npos)
    << run.Output;
  const auto stats = nlohmann::json::parse(ContentOf(this->Folder.PathOf("killed.vti.json")));
  EXPECT_EQ(stats["azimuths_taken"], parts);
  EXPECT_EQ(
    ContentOf(this->Folder.PathOf("killed.vti")), ContentOf(this->Folder.PathOf("whole.vti")));
  EXPECT_EQ(this->CountParts(), 0); // nor anything else that a killed one had begun to write
  EXPECT_TRUE(fs::is_empty(this->Folder.PathOf("kept")));
}

TEST_F(BakeVDMResume, SaysWhatItTookAndWhatItLeaves)
{
  ASSERT_EQ(RunMeso(this->Arguments("a.vti", "1000")).ExitCode, 0);
  const auto stats = nlohmann::json::parse(ContentOf(this->Folder.PathOf("a.vti.json")));
  for (const char* name : { "rays_s", "factors_s", "peak_memory_bytes", "between_angles_rms_tiles",
         "factors_rms_tiles", "factors_max_tiles", "outline_rms_degrees" })
  {
    ASSERT_TRUE(stats.contains(name)) << name;
    EXPECT_GT(stats[name].get<double>(), 0.) << name;
  }
  EXPECT_LE(stats["rays_s"].get<double>() + stats["factors_s"].get<double>(),
    stats["bake_s"].get<double>());
  EXPECT_LT(stats["factors_rms_tiles"].get<double>(), stats["factors_max_tiles"].get<double>());
  // The numbers of the table alone are 4 bytes each.
  EXPECT_GT(stats["peak_memory_bytes"].get<double>(), 4. * 32 * 32 * 90 * (8 * 16 + 16));
}

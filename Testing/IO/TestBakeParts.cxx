// What is finished of a long bake: kept after a while, found again, and never taken for another's.
#include "MesoBakeParts.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

namespace
{
class BakeParts : public testing::Test
{
protected:
  void SetUp() override { setenv("MESO_CACHE", this->Folder.PathOf("kept").c_str(), 1); }
  void TearDown() override { setenv("MESO_CACHE", "", 1); }

  static MesoBakeParts Parts(double option = 1., double patience = 0.)
  {
    return { "test", { { "option", std::vector<double>{ option } } }, patience };
  }

  bool Has(MesoBakeParts parts, int part)
  {
    std::vector<float> numbers(this->Numbers.size(), -1.f);
    const bool taken = parts.Take(part, numbers.data(), numbers.size());
    EXPECT_EQ(numbers, taken ? this->Numbers : std::vector<float>(numbers.size(), -1.f));
    EXPECT_EQ(parts.GetTaken(), taken ? 1 : 0);
    return taken;
  }

  void Keep(int part, double option = 1.)
  {
    MesoBakeParts parts = Parts(option);
    parts.Keep(part, this->Numbers.data(), this->Numbers.size());
    EXPECT_EQ(parts.GetProblem(), "");
  }

  /// Every file below the cache's folder.
  std::vector<std::filesystem::path> Files() const
  {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::exists(this->Folder.PathOf("kept")))
    {
      for (const auto& entry :
        std::filesystem::recursive_directory_iterator(this->Folder.PathOf("kept")))
      {
        if (entry.is_regular_file())
        {
          files.push_back(entry.path());
        }
      }
    }
    return files;
  }

  TemporaryFolder Folder;
  std::vector<float> Numbers = { 1.f, 0.25f, -3.f, 0.f };
};
}

TEST_F(BakeParts, AreFoundAgain)
{
  EXPECT_FALSE(this->Has(Parts(), 3));
  this->Keep(3);
  EXPECT_TRUE(this->Has(Parts(), 3));
  EXPECT_FALSE(this->Has(Parts(), 4));
  EXPECT_FALSE(this->Has(Parts(2.), 3)); // of another bake
}

TEST_F(BakeParts, AreKeptOnceABakeTakesLong)
{
  MesoBakeParts parts = Parts(1., 3600.);
  parts.Keep(3, this->Numbers.data(), this->Numbers.size());
  EXPECT_TRUE(this->Files().empty());
}

TEST_F(BakeParts, AreNoneWhereTheyAreDamaged)
{
  this->Keep(3);
  const std::string file = this->Files().at(0).string();
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  const auto write = [&](const std::string& changed)
  { std::ofstream(file, std::ios::binary) << changed; };
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    write(changed);
    EXPECT_FALSE(this->Has(Parts(), 3)) << i;
  }
  write(bytes.substr(0, bytes.size() - 1));
  EXPECT_FALSE(this->Has(Parts(), 3));
  write(bytes + "x");
  EXPECT_FALSE(this->Has(Parts(), 3));
  write("");
  EXPECT_FALSE(this->Has(Parts(), 3));
  write(bytes);
  EXPECT_TRUE(this->Has(Parts(), 3));
  // Under another's number.
  std::filesystem::rename(file, std::filesystem::path(file).parent_path() / "5");
  EXPECT_FALSE(this->Has(Parts(), 5));
}

TEST_F(BakeParts, AreOfTheSizeThatIsWanted)
{
  this->Keep(3);
  std::vector<float> fewer(3);
  EXPECT_FALSE(Parts().Take(3, fewer.data(), fewer.size()));
}

TEST_F(BakeParts, AreGoneWhenTheBakeIsDone)
{
  this->Keep(3);
  this->Keep(4);
  this->Keep(3, 2.);
  EXPECT_EQ(this->Files().size(), 3u);
  Parts().Remove();
  EXPECT_EQ(this->Files().size(), 1u);
  EXPECT_TRUE(this->Has(Parts(2.), 3));
}

TEST_F(BakeParts, WorkWithoutACache)
{
  setenv("MESO_CACHE", "", 1);
  this->Keep(3);
  EXPECT_FALSE(this->Has(Parts(), 3));
  Parts().Remove();
}

TEST_F(BakeParts, SayWhereTheyCannotBeKept)
{
  this->Folder.Write("kept", "a file, not a folder");
  MesoBakeParts parts = Parts();
  parts.Keep(3, this->Numbers.data(), this->Numbers.size());
  EXPECT_NE(parts.GetProblem().find("kept"), std::string::npos) << parts.GetProblem();
  EXPECT_FALSE(this->Has(parts, 3));
}

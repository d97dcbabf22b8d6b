// What happens to files: a missing baseline fails and leaves the image, a difference leaves both
// pictures, success leaves none, and baselines change only when that is asked for.

#include "MesoBaseline.h"
#include "MesoTestPicture.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace
{
namespace fs = std::filesystem;

class Baseline : public testing::Test
{
protected:
  void SetUp() override
  {
    unsetenv("MESO_UPDATE_BASELINES");
    fs::remove_all(this->Root);
  }
  void TearDown() override { fs::remove_all(this->Root); }

  testing::AssertionResult Compare(vtkImageData* image)
  {
    return MesoCompareWithBaseline(image, "Name", {}, this->Folders);
  }

  static vtkSmartPointer<vtkImageData> Inverted()
  {
    return MesoChangedPicture(MesoTestPicture(),
      [](vtkImageData* image, int x, int y, int c)
      { return 255. - image->GetScalarComponentAsDouble(x, y, 0, c); });
  }

  const std::string Root =
    testing::TempDir() + "Meso" + testing::UnitTest::GetInstance()->current_test_info()->name();
  const MesoTestFolders Folders = { Root + "/Baseline", Root + "/Output" };
  const std::string Kept = Folders.Baseline + "/Name.png";
  const std::string Image = Folders.Output + "/Name.png";
  const std::string Difference = Folders.Output + "/Name.diff.png";
};
}

TEST_F(Baseline, FailsWhenMissingAndWritesTheImage)
{
  const auto result = this->Compare(MesoTestPicture());
  EXPECT_FALSE(result);
  const std::string message = result.message();
  EXPECT_NE(message.find(this->Kept), std::string::npos) << message;
  EXPECT_NE(message.find(this->Image), std::string::npos) << message;
  EXPECT_TRUE(fs::exists(this->Image));
  EXPECT_FALSE(fs::exists(this->Kept)) << "a baseline must not appear by itself";
}

TEST_F(Baseline, FailsOnADifferenceAndWritesBothPictures)
{
  ASSERT_TRUE(MesoWritePNG(MesoTestPicture(), this->Kept));
  const auto result = this->Compare(Inverted());
  EXPECT_FALSE(result);
  const std::string message = result.message();
  EXPECT_NE(message.find(this->Image), std::string::npos) << message;
  EXPECT_NE(message.find(this->Difference), std::string::npos) << message;
  EXPECT_TRUE(fs::exists(this->Image));
  EXPECT_TRUE(fs::exists(this->Difference));
}

TEST_F(Baseline, PassesAndLeavesNoOldPictures)
{
  ASSERT_TRUE(MesoWritePNG(MesoTestPicture(), this->Kept));
  ASSERT_FALSE(this->Compare(Inverted()));
  EXPECT_TRUE(this->Compare(MesoTestPicture()));
  EXPECT_FALSE(fs::exists(this->Image));
  EXPECT_FALSE(fs::exists(this->Difference));
}

TEST_F(Baseline, FailsOnAnotherSizeWithoutADifferencePicture)
{
  ASSERT_TRUE(MesoWritePNG(MesoTestPicture(), this->Kept));
  const auto small = vtkSmartPointer<vtkImageData>::New();
  small->SetDimensions(10, 10, 1);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  EXPECT_FALSE(this->Compare(small));
  EXPECT_TRUE(fs::exists(this->Image));
  EXPECT_FALSE(fs::exists(this->Difference));
}

TEST_F(Baseline, IsWrittenWhenAsked)
{
  setenv("MESO_UPDATE_BASELINES", "1", 1);
  EXPECT_TRUE(this->Compare(MesoTestPicture()));
  EXPECT_TRUE(this->Compare(Inverted()));
  unsetenv("MESO_UPDATE_BASELINES");
  EXPECT_TRUE(this->Compare(Inverted()));
  EXPECT_FALSE(this->Compare(MesoTestPicture()));
}

TEST_F(Baseline, FailsWithoutAnImage)
{
  EXPECT_FALSE(this->Compare(nullptr));
}

// Baked once, kept, and baked anew where anything that a table depends on is another.
#include "MesoBakeCache.h"
#include "MesoScene.h"
#include "TemporaryFolder.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace
{
vtkSmartPointer<vtkImageData> Image(float value)
{
  vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 2, 1);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (int i = 0; i < 6; ++i)
  {
    values->InsertNextValue(value + float(i));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// A cache in a folder of its own that counts how often it had to bake.
class BakeCache : public testing::Test
{
protected:
  void SetUp() override { setenv("MESO_CACHE", this->Folder.PathOf("kept").c_str(), 1); }
  void TearDown() override { setenv("MESO_CACHE", "", 1); }

  float Get(double option, const std::string& content = "c")
  {
    const MesoBaked baked = MesoBakeOnce(
      "test", { { "option", std::vector<double>{ option } }, { "content", content } },
      [&]
      {
        ++this->Bakes;
        return Image(static_cast<float>(option));
      },
      this->Warnings);
    return static_cast<float>(baked.Table->GetPointData()->GetScalars()->GetTuple1(0));
  }

  std::filesystem::path OnlyFile() const
  {
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder.PathOf("kept")))
    {
      file = entry.path();
    }
    return file;
  }

  TemporaryFolder Folder;
  int Bakes = 0;
  std::vector<std::string> Warnings;
};
}

TEST_F(BakeCache, BakesOnce)
{
  EXPECT_EQ(this->Get(2.), 2.f);
  EXPECT_EQ(this->Get(2.), 2.f);
  EXPECT_EQ(this->Bakes, 1);
  EXPECT_TRUE(this->Warnings.empty());
}

TEST_F(BakeCache, TellsParametersApart)
{
  this->Get(2.);
  EXPECT_EQ(this->Get(3.), 3.f);
  this->Get(2., "d");
  EXPECT_EQ(this->Bakes, 3);
  EXPECT_EQ(this->Get(3.), 3.f);
  EXPECT_EQ(this->Bakes, 3);
}

TEST_F(BakeCache, BakesAnewWhatIsDamaged)
{
  this->Get(2.);
  std::ofstream(this->OnlyFile(), std::ios::app) << "x";
  EXPECT_EQ(this->Get(2.), 2.f);
  EXPECT_EQ(this->Bakes, 2);
  this->Get(2.);
  EXPECT_EQ(this->Bakes, 2);
}

TEST_F(BakeCache, DoesNotTakeAnothersTableForItsOwn)
{
  this->Get(2.);
  const std::filesystem::path file = this->OnlyFile();
  this->Get(3.);
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
  {
    if (entry.path() != file)
    {
      std::filesystem::copy_file(
        file, entry.path(), std::filesystem::copy_options::overwrite_existing);
    }
  }
  EXPECT_EQ(this->Get(3.), 3.f);
  EXPECT_EQ(this->Bakes, 3);
}

TEST_F(BakeCache, WorksWithoutAFolder)
{
  setenv("MESO_CACHE", "", 1);
  EXPECT_EQ(this->Get(2.), 2.f);
  EXPECT_EQ(this->Get(2.), 2.f);
  EXPECT_EQ(this->Bakes, 2);
  EXPECT_TRUE(this->Warnings.empty());
}

TEST_F(BakeCache, SaysWhereItCannotKeep)
{
  this->Folder.Write("kept", "a file, not a folder");
  EXPECT_EQ(this->Get(2.), 2.f);
  ASSERT_EQ(this->Warnings.size(), 1u);
  EXPECT_NE(this->Warnings[0].find("kept"), std::string::npos);
}

TEST_F(BakeCache, KeepsNothingOfABakeThatFails)
{
  EXPECT_THROW(MesoBakeOnce(
                 "test", {}, []() -> vtkSmartPointer<vtkImageData> { throw MesoInputError("no"); },
                 this->Warnings),
    MesoInputError);
  EXPECT_FALSE(std::filesystem::exists(this->Folder.PathOf("kept")));
}

TEST(ContentOf, IsThatOfNumbersAndGrid)
{
  EXPECT_EQ(MesoContentOf(Image(1.f)), MesoContentOf(Image(1.f)));
  EXPECT_NE(MesoContentOf(Image(1.f)), MesoContentOf(Image(2.f)));
  vtkSmartPointer<vtkImageData> turned = Image(1.f);
  turned->SetDimensions(2, 3, 1);
  EXPECT_NE(MesoContentOf(Image(1.f)), MesoContentOf(turned));
}

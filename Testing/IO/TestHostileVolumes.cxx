// Volumes' files that lie, are cut off, lead elsewhere or blow up: each is refused in one line that names the file,
// what in it is wrong and why, before memory is taken; and damaged ones do no harm.

#include "MessageOf.h"
#include "Mutations.h"
#include "TemporaryFolder.h"
#include "TinyTiff.h"

#include "MesoVolumeFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sys/resource.h>

namespace
{
const std::string Twelve("\0\1\2\3\4\5\6\7\10\11\12\13", 12);

std::string Nrrd(const std::string& lines, const std::string& numbers = Twelve)
{
  return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\n" + lines + "\n" +
    numbers;
}

std::string Meta(const std::string& lines, const std::string& data = "LOCAL")
{
  return "NDims = 3\nDimSize = 3 2 2\nElementType = MET_UCHAR\n" + lines +
    "ElementDataFile = " + data + "\n" + Twelve;
}

std::string Vti(const std::string& attributes, const std::string& array = "",
  const std::string& extent = "0 2 0 1 0 1")
{
  return R"(<VTKFile type="ImageData" version="1.0"><ImageData WholeExtent=")" + extent + "\" " +
    attributes + R"(><Piece Extent=")" + extent +
    R"("><PointData Scalars="n"><DataArray type="UInt8" Name="n" format="ascii" )" + array +
    ">0 1 2 3 4 5 6 7 8 9 10 11</DataArray></PointData></Piece></ImageData></VTKFile>";
}

std::string Stack(int images, std::uint32_t width = 3)
{
  std::vector<TinyTiffImage> all;
  for (int k = 0; k < images; ++k)
  {
    all.push_back({ width, 2, 1, Twelve.substr(6 * (k % 2), 6) });
  }
  return TinyTiff(all);
}

std::string Compressed(const std::string& bytes)
{
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  compress(reinterpret_cast<Bytef*>(result.data()), &size,
    reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  result.resize(size);
  return result;
}

/// What is said of a file: one line, which begins with its name.
std::string Said(const std::string& path)
{
  const std::string message = MessageOf([&]() { MesoReadVolumeFile(path); });
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  const bool isNamed = message.compare(0, path.size() + 2, path + ": ") == 0;
  EXPECT_TRUE(isNamed || message == "read without an error") << message;
  return isNamed ? message.substr(path.size() + 2) : message;
}

/// That all of the parts are in what is said.
void ExpectRefusal(
  const std::string& name, const std::string& bytes, const std::vector<std::string>& parts)
{
  const TemporaryFolder folder;
  const std::string said = Said(folder.Write(name, bytes));
  EXPECT_NE(said, "read without an error") << name;
  for (const std::string& part : parts)
  {
    EXPECT_NE(said.find(part), std::string::npos) << part << " is not in: " << said;
  }
}

long PeakMemoryKiB()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

std::size_t Count(std::size_t standard)
{
  const char* asked = std::getenv("MESO_MUTATIONS");
  return asked ? std::strtoul(asked, nullptr, 10) : standard;
}
}

TEST(HostileVolumes, AreGoodWithoutTheLies)
{
  const TemporaryFolder folder;
  const std::pair<const char*, std::string> files[] = { { "a.nrrd", Nrrd("") },
    { "a.mha", Meta("") }, { "a.vti", Vti("") }, { "a.tif", Stack(2) },
    { "\xc3\xa9t\xc3\xa9 \xe6\xb5\xb7.nrrd", Nrrd("content: \xc3\xa9t\xc3\xa9\n") } };
  for (const auto& [name, bytes] : files)
  {
    const auto image = MesoReadVolumeFile(folder.Write(name, bytes));
    ASSERT_EQ(image->GetNumberOfPoints(), 12) << name;
    // Images run from the top, volumes from y = 0.
    const bool isStack = std::string(name) == "a.tif";
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(1), isStack ? 4. : 1.) << name;
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(11), isStack ? 8. : 11.) << name;
  }
}

TEST(HostileVolumes, OfSizesThatAreNone)
{
  for (const char* size : { "3 2 -2", "3 0 2", "3 2", "3 2 2 2", "3 2 2.5", "nan 2 2", "3 2 inf",
         "4097 2 2", "4294967297 1 1", "3 2 x", "", "1e300 1 1" })
  {
    const std::string sizes = std::string("sizes: ") + size + "\n";
    ExpectRefusal("a.nrrd", Nrrd(sizes), { "sizes: '" });
    ExpectRefusal("a.mha", Meta(std::string("DimSize = ") + size + "\n"), { "DimSize: '" });
  }
  for (const char* extent : { "0 -1 0 1 0 1", "0 2 0 1", "0 99999 0 1 0 1", "5 2 0 1 0 1",
         "-9223372036854775808 9223372036854775807 0 1 0 1" })
  {
    ExpectRefusal("a.vti", Vti("", "", extent), { "" });
  }
  ExpectRefusal("a.tif", Stack(2, 70000), { "70000 x 2 pixels" });
  ExpectRefusal("a.tif", Stack(1), { "1 image" });
  ExpectRefusal("a.tif", Stack(2, 0), { "" });
}

TEST(HostileVolumes, ThatHoldLessThanTheySay)
{
  // 2 GiB are said by a hundred bytes: no memory is taken for them.
  const long before = PeakMemoryKiB();
  const std::string large = "sizes: 1024 1024 2000\n";
  ExpectRefusal("a.nrrd", Nrrd(large), { "fewer numbers than the 2097152000" });
  ExpectRefusal("a.nrrd", Nrrd(large + "encoding: gzip\n", Compressed(Twelve)), { "fewer" });
  ExpectRefusal("a.nrrd", Nrrd(large + "encoding: text\n", "1 2 3"), { "fewer" });
  ExpectRefusal("a.nrrd", Nrrd("sizes: 4096 4096 4096\n"), { "2 GiB" });
  ExpectRefusal("a.mha", Meta("DimSize = 1024 1024 2000\n"), { "fewer" });
  ExpectRefusal("a.vti", Vti("", "", "0 1023 0 1023 0 1999"), { "fewer samples" });
  ExpectRefusal("a.vti", Vti("", R"(NumberOfComponents="200000000")"), { "fewer samples" });
  ExpectRefusal("a.vti", Vti("", "NumberOfComponents = '200000000'"), { "fewer samples" });
  std::vector<TinyTiffImage> stack(100, TinyTiffImage{ 4096, 4096, 1, "1" });
  ExpectRefusal("a.tif", TinyTiff(stack), { "fewer samples" });
  stack.resize(2);
  stack[0].Numbers = stack[1].Numbers = std::string(9000, '1');
  ExpectRefusal("a.tif", TinyTiff(stack), { "cannot be read" });
  EXPECT_LT(PeakMemoryKiB() - before, 200000);
  // Cut off within the numbers.
  ExpectRefusal("a.nrrd", Nrrd("", Twelve.substr(1)), { "fewer numbers than the 12" });
  const std::string tiff = Stack(2);
  ExpectRefusal("a.tif", tiff.substr(0, tiff.size() - 1), { "" });
}

TEST(HostileVolumes, WhoseNumbersBlowUp)
{
  // 64 MiB of zeros in 64 KiB: as many are made as are asked for.
  const std::string bomb = Compressed(std::string(std::size_t(64) << 20, '\0'));
  const long before = PeakMemoryKiB();
  ExpectRefusal("a.nrrd", Nrrd("encoding: gzip\n", bomb), { "more than it says" });
  ExpectRefusal("a.nrrd", Nrrd("encoding: gzip\n", Compressed(Twelve.substr(3))), { "fewer" });
  const std::string good = Compressed(Twelve);
  ExpectRefusal("a.nrrd", Nrrd("encoding: gzip\n", good.substr(0, good.size() - 4)), { "damaged" });
  ExpectRefusal("a.nrrd", Nrrd("encoding: gzip\n", "no zlib"), { "damaged" });
  ExpectRefusal("a.nrrd", Nrrd("encoding: text\n", "0 1 2 3 4 5 6 7 8 9 10 11 12"),
    { "more than the 12 numbers" });
  for (const char* wrong : { "256", "-1", "nan", "1e300", "some" })
  {
    ExpectRefusal("a.nrrd",
      Nrrd("encoding: text\n", std::string("0 1 2 3 4 5 6 7 8 9 10 ") + wrong),
      { std::string(wrong) == "some" ? "has 11 numbers" : "number 11 is beyond its type" });
  }
  EXPECT_LT(PeakMemoryKiB() - before, 20000);
  // Lines that are skipped one by one, out of a file of nothing else: a hang where each moves the rest.
  ExpectRefusal("a.nrrd", Nrrd("line skip: 2000000000\n", std::string(1 << 20, '\n')), { "fewer" });
}

TEST(HostileVolumes, WhoseHeadersSayNoSense)
{
  ExpectRefusal("a.nrrd", Nrrd("dimension: 4\n"), { "dimension: '4'" });
  ExpectRefusal("a.nrrd", Nrrd("type: block\n"), { "type: 'block'" });
  ExpectRefusal("a.nrrd", Nrrd("encoding: hex\n"), { "encoding: 'hex'" });
  ExpectRefusal("a.nrrd", Nrrd("type: short\n", Twelve + Twelve), { "endian: ''" });
  ExpectRefusal(
    "a.nrrd", Nrrd("type: short\nendian: middle\n", Twelve + Twelve), { "endian: 'middle'" });
  ExpectRefusal("a.nrrd", Nrrd("byte skip: -2\n"), { "byte skip: '-2'" });
  ExpectRefusal("a.nrrd", Nrrd("byteskip: some\n"), { "byteskip: 'some'" });
  ExpectRefusal("a.nrrd", Nrrd("byte skip: 0.5\n"), { "byte skip: '0.5'" });
  ExpectRefusal("a.nrrd", Nrrd("line skip: -1\n"), { "line skip: '-1'" });
  ExpectRefusal("a.nrrd", Nrrd("byte skip: 1\n"), { "fewer numbers" });
  ExpectRefusal("a.mha", Meta("ElementType = MET_LONG_LONG\n"), { "ElementType: 'MET_LONG" });
  ExpectRefusal("a.mha", Meta("CompressedData = perhaps\n"), { "CompressedData: 'perhaps'" });
  ExpectRefusal("a.mha", Meta("ElementNumberOfChannels = 3\n"), { "one number a sample" });
  ExpectRefusal("a.mha", Meta("HeaderSize = -2\n"), { "HeaderSize: '-2'" });
  for (const char* spacing : { "0 1 1", "1 -1 1", "nan 1 1", "1 1 inf", "1 1", "1 1 1 1", "a b c" })
  {
    ExpectRefusal("a.nrrd", Nrrd(std::string("spacings: ") + spacing + "\n"), { "spacing" });
    ExpectRefusal("a.mha", Meta(std::string("ElementSpacing = ") + spacing + "\n"), { "pacing" });
  }
  ExpectRefusal("a.nrrd", Nrrd("space directions: (1,0,0) (0,0,0) (0,0,1)\n"), { "spacing" });
  ExpectRefusal("a.nrrd", Nrrd("space directions: (1,0,0) none (0,0,1)\n"), { "directions: '" });
  for (const char* spacing : { "0 1 1", "1 -1 1", "nan 1 1", "1 1 1e400" })
  {
    ExpectRefusal("a.vti", Vti(std::string("Spacing=\"") + spacing + "\""), { "Spacing" });
  }
  // A header without an end.
  ExpectRefusal("a.nrrd", "NRRD0004\n" + std::string(std::size_t(4) << 20, 'x'), { "dimension" });
  ExpectRefusal("a.mha", std::string(std::size_t(4) << 20, 'x'), { "without '='" });
}

TEST(HostileVolumes, WhoseNumbersAreElsewhere)
{
  const TemporaryFolder folder;
  folder.Write("n.raw", Twelve);
  folder.Write("long.raw", "header" + Twelve);
  std::filesystem::create_directory(folder.PathOf("below"));
  folder.Write("below/n.raw", Twelve);
  const auto said = [&](const std::string& name, const std::string& more = "")
  {
    const std::string nrrd = Said(folder.Write("a.nhdr", Nrrd("data file: " + name + "\n")));
    const std::string meta = Said(folder.Write("a.mhd", Meta(more, name)));
    if (more.empty())
    {
      const bool isRead = nrrd == "read without an error";
      EXPECT_EQ(isRead, meta == "read without an error") << nrrd << " / " << meta;
      EXPECT_TRUE(isRead || nrrd.find("data file: ") == 0) << nrrd;
      EXPECT_TRUE(isRead || meta.find("ElementDataFile: ") == 0) << meta;
    }
    return meta;
  };
  EXPECT_EQ(said("n.raw"), "read without an error");
  EXPECT_EQ(said("below/n.raw"), "read without an error");
  EXPECT_EQ(said("none.raw"), "ElementDataFile: 'none.raw': there is no such file");
  EXPECT_EQ(said("below"), "ElementDataFile: 'below': is a folder, not a file");
  EXPECT_NE(said("/dev/zero").find("lies outside"), std::string::npos);
  EXPECT_NE(said(folder.PathOf("n.raw")).find("lies outside"), std::string::npos);
  EXPECT_NE(said("../" +
              std::filesystem::path(folder.PathOf("")).parent_path().filename().string() + "/n.raw")
              .find("lies outside"),
    std::string::npos);
  // What comes before the numbers there.
  for (const char* size : { "6", "-1" })
  {
    EXPECT_EQ(
      said("long.raw", std::string("HeaderSize = ") + size + "\n"), "read without an error");
    const auto image = MesoReadVolumeFile(folder.PathOf("a.mhd"));
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(11), 11.) << size;
  }
}

TEST(HostileVolumes, WhoseImagesAreUnlike)
{
  const TinyTiffImage small = { 3, 2, 1, Twelve.substr(0, 6) };
  const TinyTiffImage wide = { 6, 2, 1, Twelve };
  const TinyTiffImage colored = { 2, 2, 3, Twelve };
  ExpectRefusal("a.tif", TinyTiff({ small, wide }), { "image 1 is of another size" });
  ExpectRefusal("a.tif", TinyTiff({ small, small, colored }), { "image 2 is of another size" });
  ExpectRefusal("a.tif", TinyTiff({ colored, colored }), { "3 channels" });
  // Images that go round.
  std::string circle = Stack(3);
  const std::size_t next = 8 + 2 + 12 * 9;
  circle.replace(next, 4, BytesOf(std::uint32_t(8)));
  ExpectRefusal("a.tif", circle, { "" });
}

TEST(HostileVolumes, DoNoHarmDamaged)
{
  const std::pair<std::string, std::string> files[] = { { "a.tif", Stack(3) },
    { "a.nrrd", Nrrd("type: float\nendian: little\nsizes: 3 1 1\n") },
    { "a.nrrd", Nrrd("space directions: (0,3,4) (2,0,0) (0,0,1)\nline skip: 0\n") },
    { "a.mha", Meta("CompressedData = False\nElementSpacing = 1 2 4\nHeaderSize = 0\n") },
    { "a.vti", Vti("Spacing=\"1 2 4\"") } };
  const std::vector<std::string> words = { "nan", "-1", "99999999999", "1e300", "\n\n", ": ", " = ",
    "sizes: ", "DimSize = ", "Extent = \"0 9 0 9 0 9\"", "gzip", "LOCAL", "NumberOfComponents='9'",
    std::string(4, '\xff'), std::string(4, '\0'), "data file: a.nrrd\n", "byte skip: -1\n" };
  std::size_t read = 0;
  const std::size_t count = Count(100);
  for (const auto& [name, bytes] : files)
  {
    const TemporaryFolder folder;
    Mutator mutator(11);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::string path = folder.Write(name, mutator.Damage(bytes, words));
      const std::string message = MessageOf(
        [&]()
        {
          const auto image = MesoReadVolumeFile(path);
          MesoReportVolume(image); // every number can be had
        });
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_EQ(message.find(path) == 0, message != "read without an error") << message;
      read += message == "read without an error" ? 1 : 0;
    }
  }
  EXPECT_GT(read, count / 10);
  EXPECT_LT(read, 4 * count);
}

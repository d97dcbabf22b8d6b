// Bad input of every kind: exit code 1, one line on standard error, nothing on standard output,
// and the very line that Documentation/BadInput.md shows. With MESO_UPDATE_BASELINES=1 the page's
// tables are written anew.

#include "MesoImageFile.h"
#include "MessageOf.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"
#include "TinyGltf.h"
#include "TinyImages.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace
{
const std::string Page = MESO_DOCUMENTATION_DIR "/BadInput.md";
const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string Contents(const std::string& fileName)
{
  std::ostringstream text;
  text << std::ifstream(fileName).rdbuf();
  return text.str();
}

std::string Replaced(std::string text, const std::string& what, const std::string& with)
{
  for (std::size_t place = 0; (place = text.find(what, place)) != std::string::npos;
       place += with.size())
  {
    text.replace(place, what.size(), with);
  }
  return text;
}

class BadInput : public testing::Test
{
protected:
  TemporaryFolder Folder;

  /// Asks for a file of these bytes and adds the answer to the table.
  void Add(const std::string& what, const std::string& name, const std::string& bytes)
  {
    this->Folder.Write(name, bytes);
    this->AddFile(what, name);
  }

  void AddFile(const std::string& what, const std::string& name)
  {
    const std::vector<std::string> before = this->Folder.Names();
    const MesoRun run = RunMeso({ "info", this->Folder.PathOf(name) });
    EXPECT_EQ(run.ExitCode, 1) << what;
    EXPECT_EQ(run.Output, "") << what;
    EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
    EXPECT_EQ(this->Folder.Names().size(), before.size()) << what << ": something was left";
    std::string message = Replaced(run.Messages, this->Folder.PathOf(""), "");
    message = Replaced(Replaced(message, "\n", ""), "|", "\\|");
    this->Table += "| " + what + " | `" + message + "` |\n";
  }

  /// Compares with the part of the page between this section's marks.
  void ExpectInPage(const std::string& section)
  {
    const std::string begin = "<!-- " + section + " -->\n";
    const std::string end = "<!-- end of " + section + " -->\n";
    std::string page = Contents(Page);
    const std::size_t first = page.find(begin);
    const std::size_t last = page.find(end);
    ASSERT_NE(first, std::string::npos);
    ASSERT_NE(last, std::string::npos);
    const std::size_t place = first + begin.size();
    const std::string wanted = "| what | what is said |\n| --- | --- |\n" + this->Table;
    if (std::getenv("MESO_UPDATE_BASELINES"))
    {
      std::ofstream(Page) << page.replace(place, last - place, wanted);
      return;
    }
    EXPECT_EQ(page.substr(place, last - place), wanted);
  }

  std::string Table;
};

std::string Node(const std::string& keys)
{
  return R"({"meso": 1, "nodes": [{)" + keys + "}]}";
}

std::string Relief(const std::string& keys)
{
  return Node(
    R"("mesh": {"shape": "plane"}, "mesostructure": {"technique": "relief", )" + keys + "}");
}
}

TEST_F(BadInput, AnyFile)
{
  this->AddFile("no such file", "none.obj");
  this->AddFile("a folder", ".");
  this->Add("an empty mesh", "empty.ply", "");
  this->Add("an empty image", "empty.png", "");
  this->Add("an empty scene", "empty.json", "");
  this->Add("a name that says nothing", "mesh.xyz", Triangle + "f 1 2 3\n");
  this->Add("a picture named as a mesh", "photo.ply", TinyImages::BytesOf(TinyImages::IndexedPng));
  this->Add("a damaged table", "stone.vdm.vti", "<VTKFile type=\"ImageData\">");
  this->ExpectInPage("any file");
}

TEST_F(BadInput, Meshes)
{
  this->Add("OBJ: an index of no vertex", "m.obj", Triangle + "f 1 2 7\n");
  this->Add("OBJ: a vertex that is not finite", "m.obj", "v 0 nan 0\n" + Triangle + "f 1 2 3\n");
  this->Add("OBJ: vertices alone", "m.obj", Triangle);
  this->Add("OBJ: faces of one position", "m.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  this->Add("PLY: an index of no vertex", "m.ply", ply + "3 0 1 3\n");
  this->Add("PLY: cut off", "m.ply", ply.substr(0, ply.size() - 6));
  this->Add("PLY: a count that cannot be", "m.ply", Replaced(ply, "vertex 3", "vertex 3000000000"));
  this->Add("PLY: a keyword of another format", "m.ply", Replaced(ply, "element face", "facet"));
  this->Add("STL: cut off", "m.stl",
    std::string(80, ' ') + BytesOf(std::uint32_t(12)) + std::string(120, '\0'));
  this->Add(
    "STL: text cut off", "m.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  this->Add("OFF: another dimension", "m.off", "4OFF\n3 1 0\n");
  this->Add("OFF: too few vertices", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  this->Add("VTP: not XML", "m.vtp", "junk");
  this->Add("glTF: a buffer that is not there", "m.gltf", TinyGltfJson(R"("uri": "m.bin", )"));
  this->Add("glTF: nodes in a circle", "m.glb",
    TinyGlb(TinyGltfJson(
      "", R"([{"children": [1]}, {"children": [0]}])", R"("scenes": [{"nodes": [0]}], )")));
  this->Add("glTF: more elements than bytes", "m.glb",
    TinyGlb(Replaced(TinyGltfJson(""), R"("count": 6)", R"("count": 6000)")));
  this->ExpectInPage("meshes");
}

TEST_F(BadInput, Images)
{
  const std::string png = TinyImages::BytesOf(TinyImages::IndexedPng);
  this->Add("not an image", "m.png", "junk");
  this->Add("cut off", "m.png", png.substr(0, png.size() / 2 + 12));
  this->Add("over the limit of size", "m.png", TinyImages::BytesOf(TinyImages::HugePng));
  this->Add("no pixels", "m.png", TinyImages::BytesOf(TinyImages::ZeroPng));
  const std::string plain = Relief(R"("scale": 0.1, "height_map": "h.exr")");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float values[4] = { 0.f, 1.f, nan, 0.5f };
  MesoWriteImage(this->Folder.PathOf("h.exr"), 2, 2, 1, MesoImageHeader::Type::Float, values);
  this->Add("a height that is not finite", "s.json", plain);
  MesoWriteImage(this->Folder.PathOf("r.tif"), 2, 1, 1, MesoImageHeader::Type::Float, values);
  this->Add(
    "a relief map without depth", "s.json", Relief(R"("scale": 0.1, "relief_map": "r.tif")"));
  this->Add("elevations cut off", "m.dem", std::string(1024, ' '));
  this->ExpectInPage("images");
}

TEST_F(BadInput, Volumes)
{
  const std::string nrrd = "NRRD0004\ntype: float\ndimension: 3\nencoding: raw\n";
  const std::string little = nrrd + "endian: little\n";
  const std::string numbers(32, '\0');
  this->Add("NRRD: a size that is none", "v.nrrd", little + "sizes: 2 2 -2\n\n" + numbers);
  this->Add("NRRD: more than the file holds", "v.nrrd", little + "sizes: 999 999 9\n\n" + numbers);
  this->Add("NRRD: no order of bytes", "v.nrrd", nrrd + "sizes: 2 2 2\n\n" + numbers);
  this->Add("NRRD: no distance between samples", "v.nrrd",
    little + "sizes: 2 2 2\nspacings: 1 0 1\n\n" + numbers);
  this->Add("NRRD: numbers elsewhere on the disk", "v.nhdr",
    little + "sizes: 2 2 2\ndata file: ../v.raw\n\n");
  this->Add("MetaImage: numbers that are not there", "v.mhd",
    "NDims = 3\nDimSize = 2 2 2\nElementType = MET_FLOAT\nElementDataFile = v.raw\n");
  this->Add("VTI: no image", "v.vti", "<VTKFile type=\"ImageData\"></VTKFile>");
  std::string nan = BytesOf(std::numeric_limits<float>::quiet_NaN());
  this->Folder.Write("n.nrrd", little + "sizes: 2 2 2\n\n" + nan + numbers.substr(4));
  this->Add("a number that is none", "s.json",
    Node(R"("mesh": {"shape": "plane"}, "mesostructure": {"technique": "shell-sdf", "scale": 1,
      "volume": "n.nrrd"})"));
  this->ExpectInPage("volumes");
}

TEST_F(BadInput, Scenes)
{
  this->Folder.Write("m.stl",
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  this->Add("not JSON", "s.json", "{\n \"meso\": 1,,\n}");
  this->Add("another version", "s.json", R"({"meso": 2})");
  this->Add("no version", "s.json", R"({"nodes": []})");
  this->Add("an unknown key", "s.json", Node(R"("mehs": "m.stl")"));
  this->Add("a key of another place", "s.json", R"({"meso": 1, "tiles": [2, 2]})");
  this->Add("a key given twice", "s.json", R"({"meso": 1, "nodes": [], "nodes": []})");
  this->Add("a wrong type", "s.json", R"({"meso": 1, "nodes": {"mesh": "m.stl"}})");
  this->Add("a wrong number", "s.json", R"({"meso": 1, "camera": {"view_angle": 200}})");
  this->Add("a list too short", "s.json", R"({"meso": 1, "background": [0, 0]})");
  this->Add("an unknown word", "s.json",
    Node(R"("mesh": {"shape": "plane"}, "mesostructure": {"wrap": "mirrored"})"));
  this->Add("no map", "s.json", Relief(R"("scale": 1)"));
  this->Add("a range that does not rise", "s.json",
    Relief(R"("scale": 1, "height_map": {"pattern": "brick"}, "range": [1, 1])"));
  this->Add("relief on a mesh without texture coordinates", "s.json",
    Node(R"("mesh": "m.stl", "mesostructure": {"technique": "relief", "scale": 0.1,
      "height_map": {"pattern": "brick"}})"));
  std::string deep = R"({"meso": 1, "nodes": [)";
  for (int i = 0; i < 40; ++i)
  {
    deep += R"({"children": [)";
  }
  this->Add("nodes nested too deep", "s.json", deep);
  this->ExpectInPage("scenes");
}

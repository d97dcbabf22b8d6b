// Damaged files are read or refused in one line, and nothing else: no crash, no hang, no other kind of
// exception, no memory beyond a few times the file. Seeds are fixed, so that each run is the same;
// MESO_MUTATIONS=N makes N damages of each file in place of the few that a test has time for.

#include "MesoDemFile.h"
#include "MesoGltfFile.h"
#include "MesoImageReport.h"
#include "MesoJson.h"
#include "MesoMeshSurface.h"
#include "MesoObjFile.h"
#include "MesoOffFile.h"
#include "MesoPlyFile.h"
#include "MesoStlFile.h"
#include "MesoVtpFile.h"
#include "MessageOf.h"
#include "Mutations.h"
#include "TemporaryFolder.h"
#include "TinyGltf.h"
#include "TinyImages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

namespace
{
const std::vector<std::string> Words = { "nan", "inf", "-1", "0", "4294967295", "2147483648",
  "99999999999999999999", "1e308", "-", "\n", "\\\n", "/", "#", "{", "}", "[", "]", "\"", ":", ",",
  std::string(4, '\xff'), std::string(4, '\0'), std::string("\0\0\x80\x7f", 4), "f 1 2 3\n",
  "element face 4\n", "property list uchar int vertex_indices\n", "solid", "facet normal 0 0 1",
  "OFF", "\"children\": [0],", "\"mesh\": {\"shape\": \"plane\"},", "<Piece ", "&amp;", "</" };

std::size_t Count(std::size_t standard)
{
  const char* asked = std::getenv("MESO_MUTATIONS");
  return asked ? std::strtoul(asked, nullptr, 10) : standard;
}

using Read = std::function<void(const std::string&)>;

/// Reads each file damaged `count` times.
void Torment(const std::vector<std::string>& files, std::size_t count, const Read& read)
{
  std::size_t refused = 0;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    Mutator mutator(static_cast<std::uint32_t>(i + 1));
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::string bytes = mutator.Damage(files[i], Words);
      const std::string message = MessageOf([&] { read(bytes); });
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
      refused += message == "read without an error" ? 0 : 1;
    }
  }
  EXPECT_GT(refused, count * files.size() / 10) << "hardly anything is checked";
}

Read Surface(MesoMeshFile (*parse)(const std::string&, const std::string&))
{
  return [parse](const std::string& bytes) { MesoMakeSurface(parse(bytes, "m"), "m"); };
}

const std::string Points = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";
const std::string PlyHead = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 2\n"
                            "property list uchar int vertex_indices\n";

std::string BinaryPly(bool isBig)
{
  std::string bytes = PlyHead;
  bytes.replace(bytes.find("ascii"), 5, isBig ? "binary_big_endian" : "binary_little_endian");
  bytes += "property list uchar float texcoord\nend_header\n";
  for (float number : { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.5f })
  {
    bytes += BytesOf(number, isBig);
  }
  for (std::int32_t third : { 2, 3 })
  {
    bytes += '\3' + BytesOf(0, isBig) + BytesOf(third - 1, isBig) + BytesOf(third, isBig) + '\6';
    for (int i = 0; i < 6; ++i)
    {
      bytes += BytesOf(float(i), isBig);
    }
  }
  return bytes;
}
}

TEST(Mutations, Obj)
{
  Torment({ "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
            "f 1/1/1 2/2/1 3/3/1\nf -4//1 -2//1 -1//1\nf 1 2 3 4\n" },
    Count(4000), Surface(&MesoParseObj));
}

TEST(Mutations, Ply)
{
  Torment(
    { PlyHead + "end_header\n" + Points + "3 0 1 2\n3 0 2 3\n", BinaryPly(true), BinaryPly(false) },
    Count(2500), Surface(&MesoParsePly));
}

TEST(Mutations, Stl)
{
  std::string binary(80, ' ');
  binary += BytesOf(std::uint32_t(2));
  for (int facet = 0; facet < 2; ++facet)
  {
    for (int i = 0; i < 12; ++i)
    {
      binary += BytesOf(float((i * 7 + facet) % 5));
    }
    binary += std::string(2, '\0');
  }
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\n";
  Torment(
    { "solid a\n" + facet + facet + "endsolid a\n", binary }, Count(2500), Surface(&MesoParseStl));
}

TEST(Mutations, Off)
{
  Torment({ "OFF\n4 2 0\n" + Points + "3 0 1 2\n3 0 2 3\n",
            "STNOFF 3 1\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n3 0 1 2\n" },
    Count(2500), Surface(&MesoParseOff));
}

TEST(Mutations, Gltf)
{
  const TemporaryFolder folder;
  folder.Write("b.bin", TinyGltfBuffer());
  const std::string name = folder.PathOf("m.gltf");
  Torment({ TinyGlb(), TinyGltfJson(R"("uri": "b.bin", )", R"([{"children": [1, 2]},
     {"mesh": 0, "scale": [-1, 2, 3]}, {"mesh": 0, "rotation": [0, 0, 1, 1]}])") },
    Count(2500),
    [&](const std::string& bytes) { MesoMakeSurface(MesoParseGltf(bytes, name), name); });
}

TEST(Mutations, Vtp)
{
  const std::string head = "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData>"
                           "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><Points>"
                           "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">";
  const std::string cells = "</DataArray></Points><Polys>"
                            "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">"
                            "0 1 2 0 2 3</DataArray>"
                            "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6"
                            "</DataArray></Polys></Piece></PolyData></VTKFile>";
  Torment({ head + Points + cells }, Count(1500), Surface(&MesoParseVtp));
}

TEST(Mutations, Dem)
{
  std::string record(1024, ' ');
  const auto put = [](std::string& text, std::size_t place, const std::string& field)
  { text.replace(place, field.size(), field); };
  put(record, 528, "     2     2     4");
  for (int i = 0; i < 8; ++i)
  {
    put(record, 546 + std::size_t(i) * 24, "   0.000000000000000D+00");
  }
  put(record, 816, "0.300000E+020.300000E+020.100000E+01     1     2");
  std::string profile(1024, ' ');
  put(profile, 0, "     1     1     3     1");
  for (int i = 0; i < 5; ++i)
  {
    put(profile, 24 + std::size_t(i) * 24, "   0.300000000000000D+02");
  }
  put(profile, 144, "    10    20-32767");
  Torment({ record + profile + profile }, Count(4000),
    [](const std::string& bytes) { MesoParseDem(bytes, "m.dem"); });
}

TEST(Mutations, Scene)
{
  Torment({ R"({"meso": 1, "camera": {"position": [0, 0, 5], "view_angle": 30},
    "lights": [{"type": "spot", "position": [1, 2, 3], "cone_angle": 20, "attenuation": [1, 0, 0]}],
    "background": [0, 0.5, 1],
    "nodes": [{"name": "a", "transform": {"rotate": [30, 0, 1, 0], "scale": 2},
      "mesh": {"shape": "torus", "rings": 12}, "material": {"color": [1, 1, 1], "specular": 0.5},
      "mesostructure": {"technique": "relief", "height_map": {"pattern": "brick", "size": [8, 8]},
        "scale": 0.1, "tiles": [2, 2], "quality": "low", "effects": ["shading", "depth"]},
      "children": [{"mesh": "x.obj", "feature_angle": 30}]}]})" },
    Count(6000), [](const std::string& bytes) { MesoParseScene(bytes, "s.json"); });
}

TEST(Mutations, Images)
{
  const TemporaryFolder folder;
  const std::string name = folder.PathOf("m");
  Torment(
    { TinyImages::BytesOf(TinyImages::IndexedPng), TinyImages::BytesOf(TinyImages::OneBitPng),
      TinyImages::BytesOf(TinyImages::HalfTwoPartExr), TinyImages::BytesOf(TinyImages::TiledExr) },
    Count(60),
    [&](const std::string& bytes)
    {
      folder.Write("m", bytes);
      MesoReportImage(name);
    });
}

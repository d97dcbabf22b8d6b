// What the reference cannot show is refused in one line that names the node; what it shows otherwise
// than asked for is counted.

#include "ReferenceWorld.h"

#include <fstream>

namespace
{
std::string MessageOf(const std::string& nodes, MesoReference::Surface surface)
{
  try
  {
    const MesoReference reference(SceneOf(R"("nodes": )" + nodes), surface);
    return "nothing is wrong";
  }
  catch (const MesoInputError& problem)
  {
    return problem.what();
  }
}

void ExpectRefused(const std::string& nodes, const std::vector<std::string>& parts,
  MesoReference::Surface surface = MesoReference::Surface::Mesh)
{
  const std::string message = MessageOf(nodes, surface);
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& part : parts)
  {
    EXPECT_NE(message.find(part), std::string::npos) << part << "\nis not in\n" << message;
  }
}

/// A mesh file in the tests' folder, gone at the end.
class MeshFile
{
public:
  explicit MeshFile(const std::string& text)
    : Name(testing::TempDir() + "meso_reference_" + std::to_string(::getpid()) + ".obj")
  {
    std::ofstream(this->Name) << text;
  }
  ~MeshFile() { std::remove(this->Name.c_str()); }
  MeshFile(const MeshFile&) = delete;
  void operator=(const MeshFile&) = delete;

  std::string Node(const std::string& name = "pot") const
  {
    return R"({"name": ")" + name + R"(", "mesh": ")" + this->Name +
      R"(", "mesostructure": {"technique": "relief", "scale": 0.1,
          "height_map": {"pattern": "step", "position": 0, "low": 0.5}}})";
  }

private:
  std::string Name;
};

/// A square of two triangles; the second's texture coordinates fall into a point.
const char* const SquareWithCollapsedHalf = R"(v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vn 0 0 1
vt 0 0
vt 1 0
vt 1 1
vt 0.5 0.5
f 1/1/1 2/2/1 3/3/1
f 1/4/1 3/4/1 4/4/1
)";
}

TEST(ReferenceRefusals, NameTheNode)
{
  ExpectRefused(
    R"([{}, {"name": "glass", "mesh": {"shape": "plane"}, "material": {"opacity": 0.5}}])",
    { "node 2 'glass'", "translucent" });
  ExpectRefused(R"([{"name": "wire", "mesh": {"shape": "plane"}, "material": {"edges": true}}])",
    { "node 1 'wire'", "edges" });
  ExpectRefused(
    R"([{"name": "flat", "transform": {"scale": [1, 1, 0]}, "mesh": {"shape": "plane"}}])",
    { "node 1 'flat'", "flattens" });
}

TEST(ReferenceRefusals, SmoothNeedsAClosedForm)
{
  const MeshFile file(SquareWithCollapsedHalf);
  ExpectRefused("[" + file.Node("pot") + "]", { "node 1 'pot'", "closed form", "smooth" },
    MesoReference::Surface::Smooth);
  EXPECT_EQ(MessageOf(R"([{"mesh": {"shape": "plane"}}])", MesoReference::Surface::Smooth),
    "nothing is wrong");
}

TEST(ReferenceRefusals, SizesAndSamples)
{
  const MesoReference reference(SceneOf(R"("nodes": [{"mesh": {"shape": "plane"}}])"));
  EXPECT_THROW(reference.Render(0, 5), MesoInputError);
  EXPECT_THROW(reference.Render(5, 20000), MesoInputError);
  EXPECT_THROW(reference.Render(5, 5, 0), MesoInputError);
}

TEST(ReferenceDegenerate, CollapsedChartIsMovedEvenlyAndCounted)
{
  const MeshFile file(SquareWithCollapsedHalf);
  const MesoReference reference(SceneOf(
    R"("camera": {"position": [0, 0, 5], "parallel_scale": 1}, "nodes": [)" + file.Node() + "]"));
  const auto result = reference.Render(40, 40);
  EXPECT_EQ(result.Counters.DegenerateTriangles, 1u);
  EXPECT_EQ(result.Counters.Triangles, 2u);
  bool told = false;
  for (const std::string& warning : reference.GetWarnings())
  {
    told = told || warning.find("1 triangles have no area") != std::string::npos;
  }
  EXPECT_TRUE(told);
  // Both halves lie at the even height of the map.
  EXPECT_NEAR(ValueAt(result.AOVs, "depth", 30, 30), 5.05, 1e-6);
  EXPECT_NEAR(ValueAt(result.AOVs, "depth", 10, 10), 5.05, 1e-6);
  EXPECT_NEAR(ValueAt(result.AOVs, "texcoord.u", 10, 10), 0.5, 1e-6);
}

TEST(ReferenceDegenerate, ChartsTooFarOutAreMovedEvenly)
{
  const MeshFile file(R"(v -1 -1 0
v 1 -1 0
v 1 1 0
vn 0 0 1
vt 0 0
vt 1e30 0
vt 1e30 1e30
f 1/1/1 2/2/1 3/3/1
)");
  const MesoReference reference(SceneOf(
    R"("camera": {"position": [0, 0, 5], "parallel_scale": 1}, "nodes": [)" + file.Node() + "]"));
  const auto result = reference.Render(40, 40);
  EXPECT_EQ(result.Counters.DegenerateTriangles, 1u);
  EXPECT_NEAR(ValueAt(result.AOVs, "depth", 30, 30), 5.05, 1e-6);
}

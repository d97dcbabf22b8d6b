#include "MesoGltfFile.h"

#include "MesoBinaryNumbers.h"
#include "MesoGltfBuffers.h"
#include "MesoGltfTransform.h"
#include "MesoMessage.h"

#include <algorithm>
#include <set>

namespace
{
using Matrix = MesoGltfMatrix;
constexpr MesoSceneRange Whole = { 0., 2147483647., true };
/// Of all nodes' primitives together; what a node shows again counts again.
constexpr std::size_t MostCorners = 100000000;

class Scanner
{
public:
  Scanner(const MesoSceneValue& root, const std::string& fileName, std::string binary)
    : FileName(fileName)
    , Root(root)
    , Buffers(root, fileName, std::move(binary))
  {
    this->File.PlaceName = "face";
  }

  MesoMeshFile Scan()
  {
    const std::string version = this->Root.At("asset").At("version").ToText();
    if (version.compare(0, 2, "2.") != 0)
    {
      this->Root.At("asset").At("version").Fail(
        "glTF " + MesoPrintable(version) + " is not read; 2.0 is");
    }
    this->CheckExtensions();
    this->ListOf("nodes", this->Nodes);
    this->Visited.assign(this->Nodes.size(), false);
    this->PushRoots();
    while (!this->Stack.empty())
    {
      const auto [number, parent] = this->Stack.back();
      this->Stack.pop_back();
      this->VisitNode(number, parent);
    }
    this->Finish();
    return std::move(this->File);
  }

private:
  void ListOf(const char* key, std::vector<MesoSceneValue>& list) const
  {
    this->Root.With(key, [&](const MesoSceneValue& value) { list = value.ToList(); });
  }

  void CheckExtensions() const
  {
    this->Root.With("extensionsRequired",
      [](const MesoSceneValue& names)
      {
        for (const MesoSceneValue& name : names.ToList())
        {
          const std::string text = name.ToText();
          const bool isOfMaterials =
            text.compare(0, 14, "KHR_materials_") == 0 || text.compare(0, 11, "KHR_texture") == 0;
          if (!isOfMaterials && text != "KHR_mesh_quantization" && text != "KHR_lights_punctual")
          {
            name.Fail(
              "the file requires the extension " + MesoPrintable(text) + ", which is not read");
          }
        }
      });
  }

  void PushNodes(const MesoSceneValue& list, const Matrix& parent)
  {
    std::vector<MesoSceneValue> numbers = list.ToList();
    std::reverse(numbers.begin(), numbers.end()); // so that they are taken in the file's order
    for (const MesoSceneValue& number : numbers)
    {
      const auto i = static_cast<std::size_t>(number.ToInteger(Whole));
      if (i >= this->Nodes.size())
      {
        number.Fail("there is no nodes[" + std::to_string(i) + "] (there are " +
          std::to_string(this->Nodes.size()) + ")");
      }
      this->Stack.emplace_back(i, parent);
    }
  }

  void PushRoots()
  {
    std::vector<MesoSceneValue> scenes;
    this->ListOf("scenes", scenes);
    if (!scenes.empty())
    {
      const MesoSceneValue scene = this->Root.Has("scene")
        ? MesoGltfElement(this->Root, "scenes", this->Root.At("scene"))
        : scenes.front();
      scene.With(
        "nodes", [&](const MesoSceneValue& nodes) { this->PushNodes(nodes, MesoGltfIdentity); });
      if (scenes.size() > 1)
      {
        this->File.Notes.push_back(
          "holds " + std::to_string(scenes.size()) + " scenes, of which one is taken");
      }
      return;
    }
    std::vector<bool> isChild(this->Nodes.size());
    for (const MesoSceneValue& node : this->Nodes)
    {
      node.With("children",
        [&](const MesoSceneValue& children)
        {
          for (const MesoSceneValue& child : children.ToList())
          {
            const auto i = static_cast<std::size_t>(child.ToInteger(Whole));
            if (i < isChild.size())
            {
              isChild[i] = true;
            }
          }
        });
    }
    for (std::size_t i = this->Nodes.size(); i-- > 0;)
    {
      if (!isChild[i])
      {
        this->Stack.emplace_back(i, MesoGltfIdentity);
      }
    }
  }

  void VisitNode(std::size_t number, const Matrix& parent)
  {
    const MesoSceneValue& node = this->Nodes[number];
    if (this->Visited[number])
    {
      node.Fail("is reached twice: nodes must make trees");
    }
    this->Visited[number] = true;
    const Matrix matrix = MesoGltfProduct(parent, MesoGltfMatrixOfNode(node));
    if (std::any_of(matrix.begin(), matrix.end(),
          [](double value) { return !(std::abs(value) <= MesoMeshLargestNumber); }))
    {
      node.Fail("its transform is beyond 1e30");
    }
    node.With("mesh",
      [&](const MesoSceneValue& index)
      {
        const MesoSceneValue mesh = MesoGltfElement(this->Root, "meshes", index);
        for (const MesoSceneValue& primitive : mesh.At("primitives").ToList())
        {
          this->AddPrimitive(primitive, matrix);
        }
      });
    node.With("children", [&](const MesoSceneValue& list) { this->PushNodes(list, matrix); });
  }

  void AddPrimitive(const MesoSceneValue& primitive, const Matrix& matrix)
  {
    int mode = 4;
    primitive.With("mode",
      [&](const MesoSceneValue& value) {
        mode = static_cast<int>(value.ToInteger({ 0., 6., true }));
      });
    this->MorphTargets |= primitive.Has("targets");
    if (mode < 4)
    {
      ++this->PointsOrLines;
      return;
    }
    primitive.With("extensions",
      [](const MesoSceneValue& extensions)
      { extensions.Refuse({ "KHR_draco_mesh_compression" }, "compressed meshes are not read"); });
    const MesoSceneValue attributes = primitive.At("attributes");
    const std::size_t first = this->File.Positions.size();
    const std::size_t count = this->AddPositions(attributes, matrix);
    const bool hasNormal = this->AddNormals(attributes, matrix, count);
    const bool hasTexture = this->AddTextureCoordinates(attributes, count);
    for (const char* name : { "TANGENT", "TEXCOORD_1", "COLOR_0", "JOINTS_0", "WEIGHTS_0" })
    {
      if (attributes.Has(name))
      {
        this->UnusedAttributes.insert(name);
      }
    }
    const auto indices = this->Indices(primitive, count);
    const bool isMirrored = MesoGltfDeterminant(matrix) < 0.;
    // Number k of the mode's triangles, as places in the list of indices.
    const std::size_t triangles = mode == 4 ? indices.size() / 3
      : indices.size() < 3                  ? 0
                                            : indices.size() - 2;
    this->LooseIndices += mode == 4 ? indices.size() % 3 : 0;
    if (this->File.Corners.size() + 3 * triangles > MostCorners)
    {
      primitive.Fail("the nodes show more than " + std::to_string(MostCorners / 3) + " triangles");
    }
    for (std::size_t k = 0; k < triangles; ++k)
    {
      std::array<std::size_t, 3> corners = { k, k + 1, k + 2 };
      if (mode == 4)
      {
        corners = { 3 * k, 3 * k + 1, 3 * k + 2 };
      }
      else if (mode == 6)
      {
        corners = { 0, k + 1, k + 2 };
      }
      const bool isTurned = (mode == 5 && k % 2 != 0) != isMirrored;
      if (isTurned)
      {
        std::swap(corners[0], corners[1]);
      }
      for (std::size_t corner : corners)
      {
        const auto offset = static_cast<std::int32_t>(indices[corner]);
        this->File.Corners.push_back({ static_cast<std::int32_t>(first) + offset,
          hasTexture
            ? static_cast<std::int32_t>(this->File.TextureCoordinates.size() - count) + offset
            : -1,
          hasNormal ? static_cast<std::int32_t>(this->File.Normals.size() - count) + offset : -1 });
      }
      this->File.CloseFace(this->File.NumberOfFaces());
    }
  }

  std::size_t AddPositions(const MesoSceneValue& attributes, const Matrix& m)
  {
    const std::vector<double> numbers = this->Buffers.Read(attributes.At("POSITION"), 3);
    if (this->File.Positions.size() + numbers.size() / 3 > MostCorners)
    {
      attributes.Fail("the nodes show more than " + std::to_string(MostCorners) + " vertices");
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3)
    {
      std::array<double, 3> position;
      for (int row = 0; row < 3; ++row)
      {
        position[row] = m[4 * row] * numbers[i] + m[4 * row + 1] * numbers[i + 1] +
          m[4 * row + 2] * numbers[i + 2] + m[4 * row + 3];
        if (!(std::abs(position[row]) <= MesoMeshLargestNumber))
        {
          attributes.Fail("vertex " + std::to_string(i / 3) + " lies beyond 1e30");
        }
      }
      this->File.Positions.push_back(position);
    }
    return numbers.size() / 3;
  }

  bool AddNormals(const MesoSceneValue& attributes, const Matrix& matrix, std::size_t count)
  {
    if (!attributes.Has("NORMAL"))
    {
      return false;
    }
    const std::vector<double> numbers = this->Numbers(attributes, "NORMAL", 3, count);
    const auto c = MesoGltfCofactors(matrix);
    const double sign = MesoGltfDeterminant(matrix) < 0. ? -1. : 1.;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
    {
      std::array<double, 3> normal;
      for (int row = 0; row < 3; ++row)
      {
        normal[row] = sign *
          (c[3 * row] * numbers[i] + c[3 * row + 1] * numbers[i + 1] +
            c[3 * row + 2] * numbers[i + 2]);
      }
      this->File.Normals.push_back(normal);
    }
    return true;
  }

  bool AddTextureCoordinates(const MesoSceneValue& attributes, std::size_t count)
  {
    if (!attributes.Has("TEXCOORD_0"))
    {
      return false;
    }
    const std::vector<double> numbers = this->Numbers(attributes, "TEXCOORD_0", 2, count);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
    {
      this->File.TextureCoordinates.push_back({ numbers[i], 1. - numbers[i + 1] });
    }
    return true;
  }

  std::vector<double> Numbers(
    const MesoSceneValue& attributes, const char* name, std::size_t components, std::size_t count)
  {
    std::vector<double> numbers = this->Buffers.Read(attributes.At(name), components);
    if (numbers.size() != components * count)
    {
      attributes.At(name).Fail("has " + std::to_string(numbers.size() / components) +
        " elements for " + std::to_string(count) + " positions");
    }
    return numbers;
  }

  std::vector<double> Indices(const MesoSceneValue& primitive, std::size_t count)
  {
    std::vector<double> indices;
    if (!primitive.Has("indices"))
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        indices.push_back(static_cast<double>(i));
      }
      return indices;
    }
    const MesoSceneValue place = primitive.At("indices");
    indices = this->Buffers.Read(place, 1);
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      const double index = indices[i];
      if (index != std::floor(index) || index < 0. || index >= static_cast<double>(count))
      {
        place.Fail("index " + std::to_string(i) + ": there is no vertex " + MesoNumberText(index) +
          " (there are " + std::to_string(count) + ", from 0)");
      }
    }
    return indices;
  }

  void Finish()
  {
    std::string unused;
    for (const char* key : { "materials", "images", "skins", "animations", "cameras" })
    {
      const std::size_t count = this->Root.Has(key) ? this->Root.At(key).ToCount() : 0;
      if (count > 0)
      {
        unused +=
          (unused.empty() ? "" : ", ") + std::string(key) + " (" + std::to_string(count) + ")";
      }
    }
    for (const std::string& name : this->UnusedAttributes)
    {
      unused += (unused.empty() ? "" : ", ") + name;
    }
    unused += this->MorphTargets ? std::string(unused.empty() ? "" : ", ") + "morph targets" : "";
    auto& notes = this->File.Notes;
    if (!unused.empty())
    {
      notes.push_back("what is not used: " + unused);
    }
    if (this->PointsOrLines > 0)
    {
      notes.push_back(
        std::to_string(this->PointsOrLines) + " primitives of points or lines are left out");
    }
    if (this->LooseIndices > 0)
    {
      notes.push_back(std::to_string(this->LooseIndices) + " indices make no whole triangle");
    }
    if (this->File.NumberOfFaces() == 0)
    {
      throw MesoInputError(this->FileName + ": holds no faces");
    }
  }

  const std::string& FileName;
  const MesoSceneValue& Root;
  MesoGltfBuffers Buffers;
  std::vector<MesoSceneValue> Nodes;
  std::vector<bool> Visited;
  std::vector<std::pair<std::size_t, Matrix>> Stack;
  std::set<std::string> UnusedAttributes;
  std::size_t PointsOrLines = 0;
  std::size_t LooseIndices = 0;
  bool MorphTargets = false;
  MesoMeshFile File;
};

/// The JSON and the binary chunk of a GLB file.
std::pair<std::string, std::string> SplitBinary(
  const std::string& bytes, const std::string& fileName)
{
  const auto fail = [&](std::size_t position, const std::string& reason)
  { throw MesoInputError(fileName + ": byte " + std::to_string(position) + ": " + reason); };
  constexpr std::size_t header = 12;
  if (bytes.size() < header + 8)
  {
    fail(bytes.size(), "the file ends within its header");
  }
  const auto number = [&](std::size_t position)
  { return MesoBinaryNumber<std::uint32_t>(bytes.data() + position, false); };
  if (number(4) != 2)
  {
    fail(4, "GLB version " + std::to_string(number(4)) + " is not read; 2 is");
  }
  std::pair<std::string, std::string> result;
  std::size_t position = header;
  while (position + 8 <= bytes.size())
  {
    const std::size_t length = number(position);
    const std::uint32_t kind = number(position + 4);
    position += 8;
    if (length > bytes.size() - position)
    {
      fail(position, "a chunk of " + std::to_string(length) + " bytes goes beyond the file's end");
    }
    constexpr std::uint32_t json = 0x4E4F534A;
    constexpr std::uint32_t binary = 0x004E4942;
    if (position == header + 8 && kind != json)
    {
      fail(position - 4, "the first chunk is not JSON");
    }
    if (kind == json && result.first.empty())
    {
      result.first = bytes.substr(position, length);
    }
    else if (kind == binary && result.second.empty())
    {
      result.second = bytes.substr(position, length);
    }
    position += length + (4 - length % 4) % 4;
  }
  return result;
}
}

MesoMeshFile MesoParseGltf(const std::string& bytes, const std::string& fileName)
{
  std::string binary;
  std::string text;
  const bool isBinary = bytes.compare(0, 4, "glTF") == 0;
  if (isBinary)
  {
    std::tie(text, binary) = SplitBinary(bytes, fileName);
  }
  const MesoJsonValue json = MesoParseJson(isBinary ? text : bytes, fileName);
  const MesoSceneSource source = { fileName, true };
  const MesoSceneValue root(json, "", source);
  if (json.Type != MesoJsonValue::Kind::Object)
  {
    root.Fail("is not a glTF file: its JSON is " + std::string(json.TypeName()));
  }
  return Scanner(root, fileName, std::move(binary)).Scan();
}

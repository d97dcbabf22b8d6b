#include "MesoGDMTexture.h"

#include "MesoGDMShape.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstring>

namespace
{
constexpr int ProductsOfTexel = 4;
enum : std::size_t
{
  MainTexture, ///< of weights, or of the whole table
  FunctionTexture
};

int GroupsOf(int rank)
{
  return (rank + ProductsOfTexel - 1) / ProductsOfTexel;
}

/// Four components to a texel; what is beyond the last stays 0.
class Texels
{
public:
  Texels(std::size_t count, int bytesOfValue)
    : BytesOfValue(std::size_t(bytesOfValue))
    , Bytes(count * ProductsOfTexel * this->BytesOfValue, 0)
  {
  }

  /// The components of a group of a tuple.
  void Set(std::size_t texel, const void* tuple, int rank, int group)
  {
    const int first = ProductsOfTexel * group;
    const int count = std::min(ProductsOfTexel, rank - first);
    std::memcpy(this->Bytes.data() + texel * ProductsOfTexel * this->BytesOfValue,
      static_cast<const char*>(tuple) + std::size_t(first) * this->BytesOfValue,
      std::size_t(count) * this->BytesOfValue);
  }

  const void* Get() const { return this->Bytes.data(); }

private:
  std::size_t BytesOfValue;
  std::vector<char> Bytes;
};
}

MesoGDMTexture::MesoGDMTexture()
  : MesoMapTexture(2)
{
}

std::string MesoGDMTexture::SetTable(vtkImageData* table)
{
  this->SetImage(nullptr);
  if (!table)
  {
    return {};
  }
  const std::string problem = MesoGDMTableProblem(table);
  if (!problem.empty())
  {
    return "the table " + problem;
  }
  this->SetImage(table);
  return {};
}

int MesoGDMTexture::GetGroups() const
{
  return this->GetImage() ? GroupsOf(MesoGDMShape::Of(this->GetImage()).Rank) : 0;
}

std::string MesoGDMTexture::Create(vtkOpenGLRenderWindow* window, std::size_t index,
  const std::array<int, 3>& size, int components, int type, const void* texels)
{
  const bool isFlat = size[2] == 1;
  const int limit = isFlat ? vtkTextureObject::GetMaximumTextureSize(window)
                           : vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(size.begin(), size.end()) > limit)
  {
    return "the table takes a texture of " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " x " + std::to_string(size[2]) + " and this device takes " +
      std::to_string(limit) + " a side";
  }
  vtkTextureObject* texture = this->Texture(index);
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  const auto width = static_cast<unsigned int>(size[0]);
  const auto height = static_cast<unsigned int>(size[1]);
  auto* data = const_cast<void*>(texels); // read only
  const bool isMade = isFlat ? texture->Create2DFromRaw(width, height, components, type, data)
                             : texture->Create3DFromRaw(width, height,
                                 static_cast<unsigned int>(size[2]), components, type, data);
  if (!isMade)
  {
    return "the table could not be made a texture";
  }
  const int bytes = type == VTK_UNSIGNED_CHAR ? 1 : type == VTK_UNSIGNED_SHORT ? 2 : 4;
  this->Bytes += std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]) *
    std::size_t(components) * std::size_t(bytes);
  return {};
}

std::string MesoGDMTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  this->Bytes = 0;
  return this->GetGroups() > 0 ? this->UploadFactors(window) : this->UploadWhole(window);
}

std::string MesoGDMTexture::UploadFactors(vtkOpenGLRenderWindow* window)
{
  vtkImageData* table = this->GetImage();
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  const int groups = GroupsOf(shape.Rank);
  vtkDataArray* weights = table->GetPointData()->GetArray("MesoGDMWeights");
  const int type = weights->GetDataType();
  const std::size_t slice = std::size_t(shape.Size[0]) * std::size_t(shape.Size[1]);
  const int slices = shape.Azimuths + 1;
  Texels texels(slice * std::size_t(slices) * std::size_t(groups), weights->GetDataTypeSize());
  std::size_t texel = 0;
  for (int group = 0; group < groups; ++group)
  {
    for (int a = 0; a < slices; ++a)
    {
      const std::size_t first = std::size_t(a % shape.Azimuths) * slice;
      for (std::size_t i = 0; i < slice; ++i)
      {
        texels.Set(
          texel++, weights->GetVoidPointer(vtkIdType(first + i) * shape.Rank), shape.Rank, group);
      }
    }
  }
  vtkTextureObject* texture = this->Texture(MainTexture);
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  const std::string failure = this->Create(window, MainTexture,
    { shape.Size[0], shape.Size[1], groups * slices }, ProductsOfTexel, type, texels.Get());
  if (!failure.empty())
  {
    return failure;
  }

  vtkDataArray* range = table->GetFieldData()->GetArray("MesoGDMWeightRange");
  this->Least.assign(std::size_t(groups), { 0.f, 0.f, 0.f, 0.f });
  this->Span = this->Least;
  for (int r = 0; r < shape.Rank; ++r)
  {
    const double least = range->GetComponent(0, r);
    this->Least[r / ProductsOfTexel][r % ProductsOfTexel] = static_cast<float>(least);
    this->Span[r / ProductsOfTexel][r % ProductsOfTexel] =
      static_cast<float>(range->GetComponent(1, r) - least);
  }

  vtkDataArray* functions = table->GetFieldData()->GetArray("MesoGDMFunctions");
  const int levels = shape.Size[2];
  Texels rows(std::size_t(shape.Polars) * std::size_t(levels) * std::size_t(groups),
    functions->GetDataTypeSize());
  texel = 0;
  for (int group = 0; group < groups; ++group)
  {
    for (int k = 0; k < levels; ++k)
    {
      for (int t = 0; t < shape.Polars; ++t)
      {
        rows.Set(texel++, functions->GetVoidPointer((vtkIdType(t) * levels + k) * shape.Rank),
          shape.Rank, group);
      }
    }
  }
  texture = this->Texture(FunctionTexture);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  return this->Create(window, FunctionTexture, { shape.Polars, levels * groups, 1 },
    ProductsOfTexel, VTK_FLOAT, rows.Get());
}

std::string MesoGDMTexture::UploadWhole(vtkOpenGLRenderWindow* window)
{
  vtkImageData* table = this->GetImage();
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  vtkDataArray* distances = table->GetPointData()->GetArray("MesoGDMDistances");
  const std::array<int, 3> size = { shape.Azimuths * shape.Size[0], shape.Polars * shape.Size[1],
    shape.Size[2] };
  const std::size_t bytes = std::size_t(distances->GetDataTypeSize());
  std::vector<char> texels(
    std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]) * bytes);
  const auto* source = static_cast<const char*>(distances->GetVoidPointer(0));
  for (int a = 0; a < shape.Azimuths; ++a)
  {
    for (int j = 0; j < shape.Size[1]; ++j)
    {
      for (int i = 0; i < shape.Size[0]; ++i)
      {
        for (int t = 0; t < shape.Polars; ++t)
        {
          for (int k = 0; k < shape.Size[2]; ++k)
          {
            const std::size_t row = std::size_t(t) * shape.Size[1] + std::size_t(j);
            const std::size_t column = std::size_t(a) * shape.Size[0] + std::size_t(i);
            std::memcpy(texels.data() +
                ((std::size_t(k) * size[1] + row) * std::size_t(size[0]) + column) * bytes,
              source, bytes);
            source += bytes;
          }
        }
      }
    }
  }
  vtkTextureObject* texture = this->Texture(MainTexture);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const std::string failure =
    this->Create(window, MainTexture, size, 1, distances->GetDataType(), texels.data());
  if (!failure.empty())
  {
    return failure;
  }
  // The second texture is not read; it is there so that the table counts as uploaded.
  const float nothing = 0.f;
  return this->Create(window, FunctionTexture, { 1, 1, 1 }, 1, VTK_FLOAT, &nothing);
}

void MesoGDMTexture::SetUniforms(vtkShaderProgram* program)
{
  if (!this->GetImage())
  {
    return;
  }
  const MesoGDMShape shape = MesoGDMShape::Of(this->GetImage());
  if (program->IsUniformUsed("mesoGDMSize"))
  {
    const float size[3] = { float(shape.Size[0]), float(shape.Size[1]), float(shape.Size[2]) };
    program->SetUniform3f("mesoGDMSize", size);
  }
  if (program->IsUniformUsed("mesoGDMDirections"))
  {
    const int directions[2] = { shape.Azimuths, shape.Polars };
    program->SetUniform2i("mesoGDMDirections", directions);
  }
  if (program->IsUniformUsed("mesoGDMEven"))
  {
    program->SetUniformi("mesoGDMEven", shape.Even ? 1 : 0);
  }
  if (this->GetGroups() > 0)
  {
    this->SetSampler(program, "mesoGDMWeights", MainTexture);
    this->SetSampler(program, "mesoGDMFunctions", FunctionTexture);
    const int groups = this->GetGroups();
    program->SetUniform4fv(
      "mesoGDMLeast", groups, reinterpret_cast<const float(*)[4]>(this->Least.data()));
    program->SetUniform4fv(
      "mesoGDMSpan", groups, reinterpret_cast<const float(*)[4]>(this->Span.data()));
    return;
  }
  this->SetSampler(program, "mesoGDMDistances", MainTexture);
  if (program->IsUniformUsed("mesoGDMLargest"))
  {
    vtkDataArray* distances = this->GetImage()->GetPointData()->GetArray("MesoGDMDistances");
    const bool isFloat = distances->GetDataType() == VTK_FLOAT;
    program->SetUniformf("mesoGDMLargest", isFloat ? 1.f : static_cast<float>(shape.Reach));
  }
}

#include "vtk_glew.h" // must come first

#include "MesoVDMPart.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr int Four = 4;

/// Texels of functions for each polar angle, over the tangents of half of them: so many that they are
/// those of linear interpolation between the angles.
constexpr int HalfTangentsAPolar = 32;

const char* NameOf(MesoVDMPart::Kind kind)
{
  switch (kind)
  {
    case MesoVDMPart::Kind::Weights:
      return "mesoVDMWeights";
    case MesoVDMPart::Kind::Functions:
      return "mesoVDMFunctions";
    case MesoVDMPart::Kind::AngleFunctions:
      return "mesoMVMFunctions";
    case MesoVDMPart::Kind::Table:
      return "mesoVDMTable";
    case MesoVDMPart::Kind::Angles:
      return "mesoVDMAngles";
  }
  return "";
}

void Begin(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int wrap)
{
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(wrap);
  texture->SetWrapT(wrap);
  texture->SetMaxLevel(0);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
}

std::string TooLarge(vtkOpenGLRenderWindow* window, int width, int height, int slices)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (std::max({ width, height, slices }) <= limit)
  {
    return {};
  }
  return "the table of " + std::to_string(width) + " x " + std::to_string(height) + " texels and " +
    std::to_string(slices) + " slices is larger than the " + std::to_string(limit) +
    " that this device takes";
}
}

MesoVDMPart::MesoVDMPart(Kind kind, int group)
  : MesoMapTexture(1)
  , ThisKind(kind)
  , Group(group)
{
}

bool MesoVDMPart::IsPartOf(const std::array<int, 2>& ranks) const
{
  const int first = Four * this->Group;
  switch (this->ThisKind)
  {
    case Kind::Weights:
      return first < std::max(ranks[0], ranks[1]);
    case Kind::Functions:
      return first < ranks[0];
    case Kind::AngleFunctions:
      return first < ranks[1];
    default:
      return ranks[0] == 0;
  }
}

void MesoVDMPart::SetTable(
  vtkImageData* table, const MesoVDMLayout& layout, const std::array<int, 2>& ranks)
{
  vtkImageData* image = this->IsPartOf(ranks) ? table : nullptr;
  if (image != this->GetImage() || ranks != this->Ranks)
  {
    this->Layout = layout;
    this->Ranks = ranks;
    this->SetImage(image);
  }
}

std::array<double, 2> MesoVDMPart::SpanOf(int factor) const
{
  vtkFieldData* data = this->GetImage()->GetFieldData();
  if (factor >= this->GetImage()->GetPointData()->GetScalars()->GetNumberOfComponents())
  {
    return { 0., 0. };
  }
  return { data->GetArray("WeightLow")->GetTuple1(factor),
    data->GetArray("WeightWidth")->GetTuple1(factor) };
}

std::string MesoVDMPart::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  switch (this->ThisKind)
  {
    case Kind::Weights:
      return this->UploadWeights(window);
    case Kind::Functions:
    case Kind::AngleFunctions:
      return this->UploadFunctions(window);
    default:
      return this->UploadSlices(window);
  }
}

std::string MesoVDMPart::UploadWeights(vtkOpenGLRenderWindow* window)
{
  vtkDataArray* weights = this->GetImage()->GetPointData()->GetScalars();
  const int width = this->Layout.Width;
  const int height = this->Layout.Height;
  const int azimuths = this->Layout.Azimuths;
  const std::string problem = TooLarge(window, width, height, azimuths);
  if (!problem.empty())
  {
    return problem;
  }
  const auto rank = std::size_t(weights->GetNumberOfComponents());
  const std::size_t bytes = weights->GetDataTypeSize();
  const std::size_t first = std::size_t(Four) * this->Group;
  const std::size_t count = std::min(std::size_t(Four), rank - first);
  const auto* from = static_cast<const unsigned char*>(weights->GetVoidPointer(0));
  std::vector<unsigned char> texels(this->Layout.Rows() * Four * bytes, 0);
  for (std::size_t row = 0; row < this->Layout.Rows(); ++row)
  {
    std::memcpy(&texels[row * Four * bytes], from + (row * rank + first) * bytes, count * bytes);
  }
  vtkTextureObject* texture = this->Texture();
  Begin(texture, window, vtkTextureObject::Repeat);
  texture->SetWrapR(vtkTextureObject::Repeat);
  texture->SetInternalFormat(bytes > 1 ? GL_RGBA16 : GL_RGBA8);
  if (!texture->Create3DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
        static_cast<unsigned int>(azimuths), Four, weights->GetDataType(), texels.data()))
  {
    return "the table's weights could not be made a texture";
  }
  this->Bytes = texels.size();
  return {};
}

double MesoVDMPart::FunctionAt(
  vtkDataArray* functions, int factor, double place, int curvature) const
{
  const bool ofAngles = this->ThisKind == Kind::AngleFunctions;
  if (factor >= std::min(this->Ranks[ofAngles ? 1 : 0], functions->GetNumberOfComponents()))
  {
    return 0.;
  }
  const int count = ofAngles ? 1 : this->Layout.Polars;
  const int low = std::min(static_cast<int>(place), std::max(count - 2, 0));
  const int high = std::min(low + 1, count - 1);
  const auto at = [&](int polar)
  { return functions->GetComponent(vtkIdType(curvature) * count + polar, factor); };
  const double width = this->SpanOf(factor)[1];
  return (width > 0. ? width : 1.) * (at(low) + (place - low) * (at(high) - at(low)));
}

std::string MesoVDMPart::UploadFunctions(vtkOpenGLRenderWindow* window)
{
  const bool ofAngles = this->ThisKind == Kind::AngleFunctions;
  vtkDataArray* functions =
    this->GetImage()->GetFieldData()->GetArray(ofAngles ? "MVMFunctions" : "VDMFunctions");
  // The largest angles' lie over the curvature alone.
  const int width = ofAngles ? this->Layout.Curvatures : HalfTangentsAPolar * this->Layout.Polars;
  const int height = ofAngles ? 1 : this->Layout.Curvatures;
  std::vector<float> texels;
  texels.reserve(std::size_t(Four) * width * height);
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const double polar = 2. * std::atan((column + 0.5) / width);
      const double place = ofAngles ? 0. : this->Layout.PolarPlace(polar);
      for (int i = 0; i < Four; ++i)
      {
        texels.push_back(static_cast<float>(
          this->FunctionAt(functions, Four * this->Group + i, place, ofAngles ? column : row)));
      }
    }
  }
  vtkTextureObject* texture = this->Texture();
  Begin(texture, window, vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(GL_RGBA32F);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
        Four, VTK_FLOAT, texels.data()))
  {
    return "the table's functions could not be made a texture";
  }
  this->Bytes = texels.size() * sizeof(float);
  return {};
}

std::string MesoVDMPart::UploadSlices(vtkOpenGLRenderWindow* window)
{
  const bool ofAngles = this->ThisKind == Kind::Angles;
  const MesoVDMLayout& layout = this->Layout;
  auto* table = vtkUnsignedShortArray::SafeDownCast(
    this->GetImage()->GetPointData()->GetArray(ofAngles ? "MVM" : "VDM"));
  const int columns = table->GetNumberOfComponents();
  // Of each block of numbers, in fours: the curvature's polar angles, or all curvatures.
  const int blockSize = ofAngles ? layout.Curvatures : layout.Polars;
  const int fours = (blockSize + Four - 1) / Four;
  const int blocks = columns / blockSize * fours;
  const int slices = blocks * (layout.Azimuths + 1);
  const std::string problem = TooLarge(window, layout.Width, layout.Height, slices);
  if (!problem.empty())
  {
    return problem;
  }
  const std::size_t area = std::size_t(layout.Width) * layout.Height;
  const unsigned short* numbers = table->GetPointer(0);
  std::vector<unsigned short> texels(area * slices * Four, 0);
  unsigned short* target = texels.data();
  for (int block = 0; block < blocks; ++block)
  {
    const int first = block / fours * blockSize + block % fours * Four;
    const int count = std::min(Four, blockSize - block % fours * Four);
    for (int azimuth = 0; azimuth <= layout.Azimuths; ++azimuth)
    {
      const unsigned short* source =
        numbers + std::size_t(azimuth % layout.Azimuths) * area * columns + first;
      for (std::size_t i = 0; i < area; ++i, target += Four, source += columns)
      {
        std::copy(source, source + count, target);
      }
    }
  }
  vtkTextureObject* texture = this->Texture();
  Begin(texture, window, vtkTextureObject::Repeat);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(GL_RGBA16);
  if (!texture->Create3DFromRaw(static_cast<unsigned int>(layout.Width),
        static_cast<unsigned int>(layout.Height), static_cast<unsigned int>(slices), Four,
        VTK_UNSIGNED_SHORT, texels.data()))
  {
    return "the table could not be made a texture";
  }
  this->Bytes = texels.size() * sizeof(unsigned short);
  return {};
}

void MesoVDMPart::SetUniforms(vtkShaderProgram* program)
{
  const bool grouped = this->ThisKind != Kind::Table && this->ThisKind != Kind::Angles;
  const std::string suffix = grouped ? std::to_string(this->Group) : "";
  this->SetSampler(program, (NameOf(this->ThisKind) + suffix).c_str());
  const std::string shift = "mesoVDMShift" + suffix;
  if (this->ThisKind == Kind::Weights && program->IsUniformUsed(shift.c_str()))
  {
    float shifts[Four];
    for (int i = 0; i < Four; ++i)
    {
      const std::array<double, 2> span = this->SpanOf(Four * this->Group + i);
      shifts[i] = static_cast<float>(span[1] > 0. ? span[0] / span[1] : span[0]);
    }
    program->SetUniform4f(shift.c_str(), shifts);
  }
}

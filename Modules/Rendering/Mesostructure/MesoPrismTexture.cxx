#include "MesoPrismTexture.h"

#include "MesoMapUpload.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
constexpr int RowsOfPrism = 7; // of the table
constexpr int PrismsInLine = 1024;

/// The table of prisms, as many to a line of the image as suit a texture.
vtkSmartPointer<vtkImageData> ImageOf(vtkDataArray* table)
{
  const vtkIdType rows = table->GetNumberOfTuples();
  const vtkIdType width = std::min<vtkIdType>(rows, vtkIdType(RowsOfPrism) * PrismsInLine);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(width), static_cast<int>((rows + width - 1) / width), 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const auto* given = static_cast<const float*>(table->GetVoidPointer(0));
  std::fill(
    std::copy(given, given + 4 * rows, values), values + 4 * image->GetNumberOfPoints(), 0.f);
  return image;
}

/// Whether a fin of any prism cuts what lies in the shell.
bool HasCutFins(vtkDataArray* table)
{
  constexpr int CutBits = 7 << 3;
  const auto* values = static_cast<const float*>(table->GetVoidPointer(0));
  for (vtkIdType row = RowsOfPrism - 1; row < table->GetNumberOfTuples(); row += RowsOfPrism)
  {
    if ((static_cast<int>(values[4 * row]) & CutBits) != 0)
    {
      return true;
    }
  }
  return false;
}
}

MesoPrismTexture::MesoPrismTexture()
  : MesoMapTexture(1)
{
}

std::string MesoPrismTexture::SetShell(vtkPolyData* shell)
{
  if (shell && shell == this->Shell && this->ShellTime == shell->GetMTime() && this->GetImage())
  {
    return {};
  }
  this->SetImage(nullptr);
  this->Shell = shell;
  if (!shell)
  {
    return {};
  }
  vtkDataArray* table = shell->GetFieldData()->GetArray("MesoPrismTable");
  vtkDataArray* centre = shell->GetFieldData()->GetArray("MesoPrismCentre");
  if (!table || table->GetDataType() != VTK_FLOAT || table->GetNumberOfComponents() != 4 ||
    table->GetNumberOfTuples() == 0 || table->GetNumberOfTuples() % RowsOfPrism != 0 || !centre ||
    centre->GetNumberOfValues() != 3)
  {
    return "the input is no shell of prisms, which vtkMesoPrismShell makes";
  }
  this->SetImage(ImageOf(table));
  this->Ends = HasCutFins(table);
  this->ShellTime = shell->GetMTime();
  centre->GetTuple(0, this->Centre.data());
  return {};
}

std::string MesoPrismTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  int size[3];
  this->GetImage()->GetDimensions(size);
  if (std::max(size[0], size[1]) > vtkTextureObject::GetMaximumTextureSize(window))
  {
    return "the shell has more prisms than this device has room for in a texture";
  }
  if (!MesoUploadTexels(this->Texture(), window, std::size_t(size[0]), std::size_t(size[1]), 4,
        VTK_FLOAT, this->GetImage()->GetScalarPointer()))
  {
    return "the shell's prisms could not be made a texture";
  }
  this->Bytes = std::size_t(4) * size[0] * size[1] * sizeof(float);
  return {};
}

void MesoPrismTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoPrisms");
}

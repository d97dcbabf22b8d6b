#include "vtkMesoImageReader.h"

#include "MesoImageFile.h"
#include "MesoScene.h" // for MesoInputError

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <new>

vtkStandardNewMacro(vtkMesoImageReader);

namespace
{
int ScalarTypeOf(const MesoImageHeader& header)
{
  switch (header.ValueType)
  {
    case MesoImageHeader::Type::UnsignedChar:
      return VTK_UNSIGNED_CHAR;
    case MesoImageHeader::Type::UnsignedShort:
      return VTK_UNSIGNED_SHORT;
    case MesoImageHeader::Type::Float:
      return VTK_FLOAT;
  }
  return VTK_FLOAT;
}

/// `values` has the bottom row first; the message counts rows from the top, as image viewers do.
void CheckFinite(const std::string& fileName, const MesoImageHeader& header, const float* values)
{
  std::size_t count = 0;
  std::size_t first = 0;
  int firstRow = 0;
  const std::size_t rowValues = std::size_t(header.Width) * header.ChannelNames.size();
  for (int row = 0; row < header.Height; ++row)
  {
    const float* line = values + rowValues * std::size_t(header.Height - 1 - row);
    for (std::size_t i = 0; i < rowValues; ++i)
    {
      if (!std::isfinite(line[i]))
      {
        first = count == 0 ? i : first;
        firstRow = count == 0 ? row : firstRow;
        ++count;
      }
    }
  }
  if (count > 0)
  {
    const std::size_t channels = header.ChannelNames.size();
    throw MesoInputError(fileName + ": " + std::to_string(count) +
      " values are not finite (first: channel " + header.ChannelNames[first % channels] +
      " at column " + std::to_string(first / channels) + ", row " + std::to_string(firstRow) +
      " from the top)");
  }
}
}

vtkMesoImageReader::vtkMesoImageReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMesoImageReader::~vtkMesoImageReader()
{
  this->SetFileName(nullptr);
}

int vtkMesoImageReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->ErrorMessage.clear();
  vtkInformation* information = outputVector->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw MesoInputError("vtkMesoImageReader: no file name is set");
    }
    const MesoImageInput input(this->FileName);
    const MesoImageHeader& header = input.Header();
    extent[1] = header.Width - 1;
    extent[3] = header.Height - 1;
    extent[5] = 0;
    vtkDataObject::SetPointDataActiveScalarInfo(
      information, ScalarTypeOf(header), static_cast<int>(header.ChannelNames.size()));
  }
  catch (const MesoInputError& error)
  {
    this->Refuse(error.what());
  }
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  const double origin[3] = { 0., 0., 0. };
  const double spacing[3] = { 1., 1., 1. };
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  return 1;
}

int vtkMesoImageReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  this->Notes.clear();
  this->ChannelNames.clear();
  output->Initialize();
  if (!this->ErrorMessage.empty())
  {
    return 1; // said by RequestInformation
  }
  try
  {
    this->Read(output);
    for (const std::string& note : this->Notes)
    {
      vtkWarningMacro(<< this->FileName << ": " << note);
    }
  }
  catch (const MesoInputError& error)
  {
    output->Initialize();
    this->Refuse(error.what());
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    this->Refuse(std::string(this->FileName) + ": there is not enough memory for this image");
  }
  return 1;
}

void vtkMesoImageReader::Read(vtkImageData* output)
{
  MesoImageInput input(this->FileName);
  const MesoImageHeader& header = input.Header();
  output->SetDimensions(header.Width, header.Height, 1);
  output->AllocateScalars(ScalarTypeOf(header), static_cast<int>(header.ChannelNames.size()));
  input.Read(output->GetScalarPointer(), MesoImageInput::RowOrder::BottomFirst);
  if (header.ValueType == MesoImageHeader::Type::Float)
  {
    CheckFinite(this->FileName, header, static_cast<const float*>(output->GetScalarPointer()));
  }
  this->ChannelNames = header.ChannelNames;
  this->Notes = header.Notes;
}

void vtkMesoImageReader::Refuse(const std::string& message)
{
  this->ErrorMessage = message;
  vtkErrorMacro(<< message);
}

void vtkMesoImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  for (const std::string& note : this->Notes)
  {
    os << indent << "Note: " << note << "\n";
  }
}

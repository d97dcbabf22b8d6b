#include "MesoBakedFile.h"

#include "MesoAtomicFile.h"
#include "MesoChecksum.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <filesystem>
#include <fstream>
#include <limits>

namespace
{
const std::string Prefix = "meso.";
const std::string ParameterPrefix = Prefix + "parameter.";
const std::string KindName = Prefix + "kind";
const std::string FormatName = Prefix + "format";
const std::string ChecksumName = Prefix + "checksum";

bool IsOurs(const std::string& name)
{
  return name.compare(0, Prefix.size(), Prefix) == 0;
}

/// Of everything that the file says but the checksum itself.
std::string ChecksumOf(vtkImageData* table)
{
  MesoChecksum sum;
  sum.AddGrid(table);
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(table->GetPointData()), table->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (MesoArrayName(array) != ChecksumName)
      {
        sum.Add(array);
      }
    }
  }
  return sum.Text();
}

void AddText(vtkFieldData* data, const std::string& name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(text);
  data->AddArray(array);
}

std::string TextOf(vtkFieldData* data, const std::string& name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : std::string();
}

void AddParameter(vtkFieldData* data, const std::string& name, const MesoBakedParameter& parameter)
{
  if (const auto* text = std::get_if<std::string>(&parameter))
  {
    AddText(data, ParameterPrefix + name, *text);
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName((ParameterPrefix + name).c_str());
  for (double number : std::get<std::vector<double>>(parameter))
  {
    array->InsertNextValue(number);
  }
  data->AddArray(array);
}

MesoBakedParameter ParameterOf(vtkAbstractArray* array)
{
  if (auto* text = vtkStringArray::SafeDownCast(array))
  {
    return text->GetNumberOfValues() > 0 ? std::string(text->GetValue(0)) : std::string();
  }
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    numbers.push_back(array->GetVariantValue(i).ToDouble());
  }
  return numbers;
}

/// The reason not to write this, or an empty text.
std::string Problem(const MesoBaked& baked)
{
  if (baked.Kind.empty())
  {
    return "there is no kind";
  }
  if (!baked.Table || baked.Table->GetPointData()->GetNumberOfArrays() == 0)
  {
    return "there is no table";
  }
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(baked.Table->GetPointData()), baked.Table->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (MesoArrayName(array).empty() || IsOurs(MesoArrayName(array)) ||
        array->GetDataType() == VTK_BIT)
      {
        return "a table has no name, a name that begins with \"" + Prefix + "\", or values of bits";
      }
    }
  }
  return {};
}

/// Keeps quiet what VTK's XML parsers say while it lives: they have no observers.
class Silence
{
public:
  Silence()
    : Before(vtkObject::GetGlobalWarningDisplay())
  {
    vtkObject::GlobalWarningDisplayOff();
  }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  int Before;
};

std::string BytesOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// The comment that ends a file of these bytes.
std::string Seal(const std::string& bytes, std::size_t count)
{
  MesoChecksum sum;
  sum.Add(bytes.data(), count);
  return "<!-- meso " + sum.Text() + " -->\n";
}

/// Whether the file ends in the comment that belongs to it.
bool IsSealed(const std::string& fileName)
{
  const std::string bytes = BytesOf(fileName);
  const std::size_t length = Seal({}, 0).size();
  return bytes.size() > length &&
    bytes.compare(bytes.size() - length, length, Seal(bytes, bytes.size() - length)) == 0;
}

/// What is read of the file; null where it is no image of VTK's.
vtkSmartPointer<vtkImageData> ReadTable(const std::string& fileName)
{
  const Silence silence;
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(fileName.c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}
}

void MesoWriteBaked(const std::string& fileName, const MesoBaked& baked)
{
  const std::string problem = Problem(baked);
  if (!problem.empty())
  {
    throw MesoInputError(fileName + ": cannot be written: " + problem);
  }
  vtkNew<vtkImageData> table;
  table->ShallowCopy(baked.Table);
  vtkNew<vtkFieldData> data; // the caller's own stays as it is
  data->ShallowCopy(baked.Table->GetFieldData());
  table->SetFieldData(data);
  AddText(data, KindName, baked.Kind);
  vtkNew<vtkIntArray> format;
  format->SetName(FormatName.c_str());
  format->InsertNextValue(MesoBakedFormat);
  data->AddArray(format);
  for (const auto& [name, parameter] : baked.Parameters)
  {
    AddParameter(data, name, parameter);
  }
  AddText(data, ChecksumName, ChecksumOf(table));

  MesoAtomicFile atomic(fileName);
  const Silence silence;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(table);
  writer->SetFileName(atomic.TemporaryName().c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (writer->Write() == 0 || writer->GetErrorCode() != 0)
  {
    throw MesoInputError(fileName + ": cannot be written");
  }
  const std::string bytes = BytesOf(atomic.TemporaryName());
  std::ofstream file(atomic.TemporaryName(), std::ios::binary | std::ios::app);
  file << Seal(bytes, bytes.size());
  file.close();
  if (!file)
  {
    throw MesoInputError(fileName + ": cannot be written");
  }
  atomic.Commit();
}

MesoBaked MesoReadBaked(const std::string& fileName, const std::string& kind)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(fileName, error))
  {
    throw MesoInputError(fileName + ": there is no such file");
  }
  if (!IsSealed(fileName))
  {
    throw MesoInputError(fileName + ": is no baked file, or it is damaged");
  }
  const vtkSmartPointer<vtkImageData> table = ReadTable(fileName);
  if (!table)
  {
    throw MesoInputError(fileName + ": holds no VTK image");
  }
  vtkFieldData* data = table->GetFieldData();
  MesoBaked baked;
  baked.Kind = TextOf(data, KindName);
  vtkDataArray* format = data->GetArray(FormatName.c_str());
  if (baked.Kind.empty() || !format || format->GetNumberOfValues() != 1)
  {
    throw MesoInputError(fileName + ": does not say \"" + KindName + "\" and its format");
  }
  if (format->GetTuple1(0) != MesoBakedFormat)
  {
    throw MesoInputError(fileName + ": is of format " +
      std::to_string(static_cast<int>(format->GetTuple1(0))) + ", and only " +
      std::to_string(MesoBakedFormat) + " can be read: bake it again");
  }
  if (TextOf(data, ChecksumName) != ChecksumOf(table))
  {
    throw MesoInputError(fileName + ": is damaged: its checksum is not that of its contents");
  }
  if (!kind.empty() && baked.Kind != kind)
  {
    throw MesoInputError(
      fileName + ": holds a baked " + MesoPrintable(baked.Kind) + ", not a " + kind);
  }
  vtkNew<vtkFieldData> others;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = MesoArrayName(array);
    if (!IsOurs(name))
    {
      others->AddArray(array);
    }
    else if (name.compare(0, ParameterPrefix.size(), ParameterPrefix) == 0)
    {
      baked.Parameters[name.substr(ParameterPrefix.size())] = ParameterOf(array);
    }
  }
  table->SetFieldData(others);
  baked.Table = table;
  return baked;
}

#ifndef MesoChecksum_h
#define MesoChecksum_h

#include "vtkAbstractArray.h"
#include "vtkImageData.h"
#include "vtkStringArray.h"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>

/// An array's name, empty where it has none.
inline std::string MesoArrayName(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

/// 64-bit FNV-1a (Fowler, Noll, Vo), published constants.
class MesoChecksum
{
public:
  void Add(const void* bytes, std::size_t count)
  {
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Hash = (this->Hash ^ byte[i]) * 0x100000001b3u;
    }
  }
  /// Its length too, so that two texts cannot stand for two others.
  void Add(const std::string& text)
  {
    this->Add(static_cast<std::int64_t>(text.size()));
    this->Add(text.data(), text.size());
  }
  void Add(std::int64_t number) { this->Add(&number, sizeof(number)); }

  void Add(vtkAbstractArray* array)
  {
    this->Add(MesoArrayName(array));
    this->Add(array->GetDataType());
    this->Add(array->GetNumberOfComponents());
    this->Add(array->GetNumberOfTuples());
    if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
      {
        this->Add(std::string(texts->GetValue(i)));
      }
    }
    else
    {
      this->Add(array->GetVoidPointer(0),
        std::size_t(array->GetNumberOfValues()) * std::size_t(array->GetDataTypeSize()));
    }
  }

  /// The grid's extent and place, without its arrays.
  void AddGrid(vtkImageData* image)
  {
    this->Add(image->GetExtent(), 6 * sizeof(int));
    this->Add(image->GetSpacing(), 3 * sizeof(double));
    this->Add(image->GetOrigin(), 3 * sizeof(double));
  }

  std::string Text() const
  {
    char text[17];
    std::snprintf(text, sizeof(text), "%016" PRIx64, this->Hash);
    return text;
  }

private:
  std::uint64_t Hash = 0xcbf29ce484222325u;
};

#endif

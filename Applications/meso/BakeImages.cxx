#include "BakeImages.h"

#include "MesoImageFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <filesystem>
#include <vector>

void BakeWriteImage(const std::string& fileName, vtkImageData* image, const std::string& array,
  int bits, double factor, double offset)
{
  vtkDataArray* tuples = image->GetPointData()->GetArray(array.c_str());
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  const int components = tuples->GetNumberOfComponents();
  std::vector<float> values;
  values.reserve(std::size_t(width) * height * components);
  for (int row = height - 1; row >= 0; --row) // files begin at the top
  {
    for (int column = 0; column < width; ++column)
    {
      for (int component = 0; component < components; ++component)
      {
        const double value = tuples->GetComponent(vtkIdType(row) * width + column, component);
        values.push_back(static_cast<float>(value * factor + offset));
      }
    }
  }
  using Type = MesoImageHeader::Type;
  const Type type = bits == 8 ? Type::UnsignedChar : bits == 16 ? Type::UnsignedShort : Type::Float;
  MesoWriteImage(fileName, width, height, components, type, values.data());
}

int BakeBitsFor(const std::string& fileName, int bits)
{
  constexpr int Float = 32;
  return std::filesystem::path(fileName).extension() == ".exr" ? Float : bits;
}

#include "vtkMesoMaximumMip.h"

#include "MesoKernels.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkMesoMaximumMip);

namespace
{
struct Level
{
  int Width;
  int Height;
  vtkNew<vtkFloatArray> Maxima;

  Level(int width, int height, const std::string& name)
    : Width(width)
    , Height(height)
  {
    this->Maxima->SetName(name.c_str());
    this->Maxima->SetNumberOfValues(vtkIdType(width) * height);
  }
  float& At(int column, int row)
  {
    return *this->Maxima->GetPointer(vtkIdType(row) * this->Width + column);
  }
};
}

void vtkMesoMaximumMip::Compute(const Map& map, vtkImageData* output)
{
  const MesoKernels::Float::HeightField field(map.Width, map.Height, this->GetWrap(), map.Heights);
  constexpr double PartOfPatches = 0.6; // of the work; what follows halves from level to level
  Level patches(map.Width, map.Height, "Maximum");
  this->ForRows(
    map.Height,
    [&](int first, int end)
    {
      for (int row = first; row < end; ++row)
      {
        for (int column = 0; column < map.Width; ++column)
        {
          patches.At(column, row) =
            std::max(std::max(field.nearHeight(column, row), field.nearHeight(column + 1, row)),
              std::max(field.nearHeight(column, row + 1), field.nearHeight(column + 1, row + 1)));
        }
      }
    },
    0., PartOfPatches);
  output->GetPointData()->SetScalars(patches.Maxima);

  vtkNew<vtkIntArray> sizes;
  sizes->SetName("MaximumSizes");
  sizes->SetNumberOfComponents(2);
  const int first[] = { map.Width, map.Height };
  sizes->InsertNextTypedTuple(first);
  vtkNew<vtkFieldData> levels;
  Level* below = &patches;
  std::vector<std::unique_ptr<Level>> made;
  while ((below->Width > 1 || below->Height > 1) && !this->GetAbortExecute())
  {
    made.push_back(std::make_unique<Level>((below->Width + 1) / 2, (below->Height + 1) / 2,
      "Maximum" + std::to_string(made.size() + 1)));
    Level& level = *made.back();
    const double done = 1. - (1. - PartOfPatches) / double(1 << (made.size() - 1));
    this->ForRows(
      level.Height,
      [&](int firstRow, int end)
      {
        for (int row = firstRow; row < end; ++row)
        {
          const int rows[] = { 2 * row, std::min(2 * row + 1, below->Height - 1) };
          for (int column = 0; column < level.Width; ++column)
          {
            const int columns[] = { 2 * column, std::min(2 * column + 1, below->Width - 1) };
            level.At(column, row) =
              std::max(std::max(below->At(columns[0], rows[0]), below->At(columns[1], rows[0])),
                std::max(below->At(columns[0], rows[1]), below->At(columns[1], rows[1])));
          }
        }
      },
      done, 0.5 * (1. - done));
    levels->AddArray(level.Maxima);
    const int size[] = { level.Width, level.Height };
    sizes->InsertNextTypedTuple(size);
    below = &level;
  }
  levels->AddArray(sizes);
  output->SetFieldData(levels);
}

#include "MesoHeightPyramid.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
/// The texels that one of half as many covers along an axis, and how much of it each is.
struct Cover
{
  int First;
  int Count;
  double Weights[3];
};

std::vector<Cover> CoversOf(int size)
{
  const int half = size / 2;
  std::vector<Cover> covers(static_cast<std::size_t>(half));
  for (int i = 0; i < half; ++i)
  {
    // In units of 1 / half of a texel, in which all ends are whole.
    const int start = i * size;
    const int end = start + size;
    Cover& cover = covers[std::size_t(i)];
    cover.First = start / half;
    cover.Count = (end + half - 1) / half - cover.First; // at most 3
    for (int k = 0; k < cover.Count; ++k)
    {
      const int low = std::max(start, (cover.First + k) * half);
      const int high = std::min(end, (cover.First + k + 1) * half);
      cover.Weights[k] = double(high - low) / size;
    }
  }
  return covers;
}

MesoHeightLevel Halved(int width, int height, const float* heights)
{
  MesoHeightLevel level = { width / 2, height / 2, {} };
  level.Heights.resize(std::size_t(level.Width) * std::size_t(level.Height));
  const std::vector<Cover> columns = CoversOf(width);
  const std::vector<Cover> rows = CoversOf(height);
  vtkSMPTools::For(0, level.Height,
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType row = first; row < end; ++row)
      {
        const Cover& down = rows[std::size_t(row)];
        float* out = level.Heights.data() + row * level.Width;
        for (const Cover& across : columns)
        {
          double sum = 0.;
          for (int j = 0; j < down.Count; ++j)
          {
            const float* in = heights + std::ptrdiff_t(down.First + j) * width + across.First;
            for (int i = 0; i < across.Count; ++i)
            {
              sum += down.Weights[j] * across.Weights[i] * double(in[i]);
            }
          }
          *out++ = static_cast<float>(std::clamp(sum, 0., 1.));
        }
      }
    });
  return level;
}
}

std::vector<MesoHeightLevel> MesoMakeHeightPyramid(int width, int height, const float* heights)
{
  std::vector<MesoHeightLevel> levels;
  while (width > 1 && height > 1)
  {
    levels.push_back(Halved(width, height, heights));
    width = levels.back().Width;
    height = levels.back().Height;
    heights = levels.back().Heights.data();
  }
  return levels;
}

MesoMapSlopes MesoSlopesOfMap(int width, int height, const float* heights)
{
  MesoMapSlopes slopes;
  const auto add = [&](int axis, double step)
  {
    slopes.MeanSquare[axis] += step * step;
    slopes.MeanSize[axis] += std::abs(step);
  };
  for (int row = 0; row < height; ++row)
  {
    const float* here = heights + std::ptrdiff_t(row) * width;
    for (int column = 0; column < width; ++column)
    {
      add(0, column + 1 < width ? double(here[column + 1]) - here[column] : 0.);
      add(1, row + 1 < height ? double(here[column + width]) - here[column] : 0.);
    }
  }
  const double size[2] = { double(width), double(height) };
  for (int axis = 0; axis < 2; ++axis)
  {
    // A step is a texel's, of which there are width x height.
    slopes.MeanSquare[axis] *= size[axis] / size[1 - axis];
    slopes.MeanSize[axis] /= size[1 - axis];
  }
  return slopes;
}

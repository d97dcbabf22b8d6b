#include "MesoPushPull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
/// Values times their weights; a weight is 1 where known, 0 where not, and the mean of those below
/// at coarser levels.
struct Level
{
  int Width;
  int Height;
  std::vector<double> Values; // a texel's components, then its weight

  const double* At(int column, int row, int stride) const
  {
    column = std::clamp(column, 0, this->Width - 1);
    row = std::clamp(row, 0, this->Height - 1);
    return &this->Values[(std::size_t(row) * this->Width + column) * stride];
  }
};

/// Half the size, rounded up: each texel is the sum of its four.
Level Pushed(const Level& fine, int stride)
{
  Level coarse = { (fine.Width + 1) / 2, (fine.Height + 1) / 2, {} };
  coarse.Values.assign(std::size_t(coarse.Width) * coarse.Height * stride, 0.);
  for (int row = 0; row < fine.Height; ++row)
  {
    for (int column = 0; column < fine.Width; ++column)
    {
      const double* from = fine.At(column, row, stride);
      double* to = &coarse.Values[(std::size_t(row / 2) * coarse.Width + column / 2) * stride];
      for (int i = 0; i < stride; ++i)
      {
        to[i] += 0.25 * from[i];
      }
    }
  }
  return coarse;
}

/// What is missing to a weight of 1 comes from the coarser level, read bilinearly.
void Pull(Level& fine, const Level& coarse, int stride)
{
  std::vector<double> read(stride);
  for (int row = 0; row < fine.Height; ++row)
  {
    for (int column = 0; column < fine.Width; ++column)
    {
      double* texel = &fine.Values[(std::size_t(row) * fine.Width + column) * stride];
      const double weight = texel[stride - 1];
      if (weight >= 1.)
      {
        continue;
      }
      const double x = 0.5 * (column + 0.5) - 0.5;
      const double y = 0.5 * (row + 0.5) - 0.5;
      const int left = static_cast<int>(std::floor(x));
      const int below = static_cast<int>(std::floor(y));
      const double weights[2][2] = { { 1. - (x - left), x - left },
        { 1. - (y - below), y - below } };
      std::fill(read.begin(), read.end(), 0.);
      for (int corner = 0; corner < 4; ++corner)
      {
        const double* from = coarse.At(left + corner % 2, below + corner / 2, stride);
        const double part = weights[0][corner % 2] * weights[1][corner / 2];
        for (int i = 0; i < stride; ++i)
        {
          read[i] += part * from[i];
        }
      }
      // The coarser level's own weights are 1 by now, or 0 where nothing at all is known.
      for (int i = 0; i < stride; ++i)
      {
        texel[i] += (1. - weight) * read[i];
      }
    }
  }
}

void Fill(Level& level, int stride)
{
  if (level.Width > 1 || level.Height > 1)
  {
    Level coarse = Pushed(level, stride);
    // A coarse texel of which anything is known counts as known.
    for (std::size_t i = 0; i < coarse.Values.size(); i += stride)
    {
      const double weight = coarse.Values[i + stride - 1];
      for (int k = 0; weight > 0. && k < stride; ++k)
      {
        coarse.Values[i + k] /= weight;
      }
    }
    Fill(coarse, stride);
    Pull(level, coarse, stride);
  }
}
}

void MesoPushPull(
  std::vector<float>& values, int components, const std::vector<bool>& known, int width, int height)
{
  const int stride = components + 1;
  Level level = { width, height, {} };
  level.Values.assign(known.size() * stride, 0.);
  for (std::size_t texel = 0; texel < known.size(); ++texel)
  {
    if (known[texel])
    {
      std::copy_n(&values[texel * components], components, &level.Values[texel * stride]);
      level.Values[texel * stride + components] = 1.;
    }
  }
  Fill(level, stride);
  for (std::size_t texel = 0; texel < known.size(); ++texel)
  {
    if (!known[texel] && level.Values[texel * stride + components] > 0.)
    {
      std::transform(&level.Values[texel * stride], &level.Values[texel * stride] + components,
        &values[texel * components], [](double value) { return static_cast<float>(value); });
    }
  }
}

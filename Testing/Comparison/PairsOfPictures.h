#ifndef PairsOfPictures_h
#define PairsOfPictures_h

#include "MesoPicture.h"

#include <cstdint>
#include <functional>

/// Pictures of 32 x 24 whose figures of error were computed by other programs.
class PairsOfPictures
{
public:
  static constexpr int Width = 32;
  static constexpr int Height = 24;

  static MesoPicture Of(const std::function<int(int x, int y, int channel)>& byte)
  {
    MesoPicture picture;
    picture.Width = Width;
    picture.Height = Height;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          picture.Rgb.push_back(static_cast<float>(byte(x, y, channel)) / 255.f);
        }
      }
    }
    return picture;
  }

  static MesoPicture Constant(int red, int green, int blue)
  {
    return Of(
      [&](int, int, int channel) { return channel == 0 ? red : (channel == 1 ? green : blue); });
  }

  /// A disc of radius 6 in front of a ramp.
  static MesoPicture Smooth(int shift, int blue)
  {
    return Of(
      [&](int x, int y, int channel)
      {
        const int dx = x - 16 - shift;
        const int dy = y - 12;
        const int disc[3] = { 200, 60, 30 };
        const int ramp[3] = { 8 * x, 10 * y, blue };
        return (dx * dx + dy * dy <= 36 ? disc : ramp)[channel];
      });
  }

  static MesoPicture Noisy(std::uint32_t seed)
  {
    return Of(
      [&](int, int, int)
      {
        seed = (seed * 1103515245u + 12345u) & 0x7fffffffu;
        return static_cast<int>((seed >> 16) & 255u);
      });
  }

  static std::size_t At(int x, int y) { return std::size_t(y) * Width + x; }
};

#endif

#ifndef HandMadeAOVs_h
#define HandMadeAOVs_h

#include "MesoExr.h"

#include <algorithm>
#include <functional>
#include <string>

/**
 * Channels and attributes as `meso render --aov all` writes them, made by hand. At first every pixel
 * is covered by object 1 at the depth 5 with a normal along z and no shadow.
 */
class HandMadeAOVs
{
public:
  HandMadeAOVs(int width, int height)
  {
    this->Image.Width = width;
    this->Image.Height = height;
    this->Image.ChannelNames = { "coverage", "depth", "texcoord.u", "texcoord.v", "normal.x",
      "normal.y", "normal.z", "object", "shadow.0", "relief" };
    this->Image.Data.assign(std::size_t(width) * height * this->Image.ChannelNames.size(), 0.f);
    this->Fill("coverage", 1.f);
    this->Fill("depth", 5.f);
    this->Fill("normal.z", 1.f);
    this->Fill("object", 1.f);
    this->Describe(1, 0.1, 128, 64);
    auto& attributes = this->Image.Attributes;
    for (const char* axis : { ".x", ".y", ".z" })
    {
      for (const char* name : { "meso.light.0.towards", "meso.camera.position",
             "meso.camera.forward", "meso.camera.right", "meso.camera.up" })
      {
        attributes[name + std::string(axis)] = 0.;
      }
    }
    attributes["meso.light.0.towards.z"] = 1.;
    attributes["meso.camera.forward.z"] = -1.;
    attributes["meso.camera.right.x"] = 1.;
    attributes["meso.camera.up.y"] = 1.;
    attributes["meso.camera.parallel"] = 0.;
  }

  void Describe(int number, double scale, int mapWidth, int mapHeight)
  {
    const std::string prefix = "meso." + std::to_string(number) + ".";
    this->Image.Attributes[prefix + "name"] = "object " + std::to_string(number);
    this->Image.Attributes[prefix + "scale"] = scale;
    this->Image.Attributes[prefix + "map_width"] = double(mapWidth);
    this->Image.Attributes[prefix + "map_height"] = double(mapHeight);
  }

  float& At(const std::string& channel, int column, int row)
  {
    const auto& names = this->Image.ChannelNames;
    const std::size_t index = std::find(names.begin(), names.end(), channel) - names.begin();
    return this->Image.Data[(std::size_t(row) * this->Image.Width + column) * names.size() + index];
  }

  void Fill(const std::string& channel, float value)
  {
    this->Fill(channel, [value](int, int) { return value; });
  }

  void Fill(const std::string& channel, const std::function<float(int column, int row)>& value)
  {
    for (int row = 0; row < this->Image.Height; ++row)
    {
      for (int column = 0; column < this->Image.Width; ++column)
      {
        this->At(channel, column, row) = value(column, row);
      }
    }
  }

  /// Adds a channel, 0 everywhere.
  void AddChannel(const std::string& channel)
  {
    MesoExrImage wider = this->Image;
    wider.ChannelNames.push_back(channel);
    wider.Data.clear();
    const std::size_t count = this->Image.ChannelNames.size();
    for (std::size_t i = 0; i < this->Image.Data.size(); i += count)
    {
      const auto first = this->Image.Data.begin() + std::ptrdiff_t(i);
      wider.Data.insert(wider.Data.end(), first, first + std::ptrdiff_t(count));
      wider.Data.push_back(0.f);
    }
    this->Image = wider;
  }

  /// Gives a channel another name, so that it is not found.
  void Hide(const std::string& channel)
  {
    std::replace(this->Image.ChannelNames.begin(), this->Image.ChannelNames.end(), channel,
      "hidden " + channel);
  }

  /// A pixel that nothing covers is 0 in every channel.
  void Uncover(int column, int row)
  {
    for (const std::string& channel : this->Image.ChannelNames)
    {
      this->At(channel, column, row) = 0.f;
    }
  }

  /// Covers just the pixels that the function is true for.
  void CoverOnly(const std::function<bool(int column, int row)>& covered)
  {
    for (int row = 0; row < this->Image.Height; ++row)
    {
      for (int column = 0; column < this->Image.Width; ++column)
      {
        if (!covered(column, row))
        {
          this->Uncover(column, row);
        }
      }
    }
  }

  MesoExrImage Image;
};

#endif

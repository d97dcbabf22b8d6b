#include "MesoAOVs.h"

#include "MesoScene.h" // for MesoInputError

#include <algorithm>
#include <cmath>

namespace
{
/// A channel's values; empty where the image does not have it.
std::vector<float> Channel(const MesoExrImage& image, const std::string& name)
{
  const auto& names = image.ChannelNames;
  const auto found = std::find(names.begin(), names.end(), name);
  std::vector<float> values;
  if (found != names.end())
  {
    const std::size_t count = names.size();
    values.resize(image.Data.size() / count);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = image.Data[i * count + (found - names.begin())];
    }
  }
  return values;
}

template <std::size_t N>
void TakeGroup(const MesoExrImage& image, const std::string& group,
  const std::array<const char*, N>& parts, std::array<std::vector<float>, N>& values)
{
  std::string missing;
  std::size_t found = 0;
  for (std::size_t i = 0; i < N; ++i)
  {
    const std::string name = group + "." + parts[i];
    values[i] = Channel(image, name);
    found += values[i].empty() ? 0 : 1;
    missing = values[i].empty() ? name : missing;
  }
  if (found > 0 && found < N)
  {
    throw MesoInputError("the channel " + missing + " is missing beside its fellows");
  }
}

template <typename T>
std::optional<T> Attribute(const MesoExrAttributes& attributes, const std::string& name)
{
  const auto found = attributes.find(name);
  if (found == attributes.end())
  {
    return std::nullopt;
  }
  if (!std::holds_alternative<T>(found->second))
  {
    throw MesoInputError("the attribute " + name + " is of the wrong kind");
  }
  return std::get<T>(found->second);
}

std::optional<std::array<double, 3>> Vector(
  const MesoExrAttributes& attributes, const std::string& name)
{
  const auto x = Attribute<double>(attributes, name + ".x");
  const auto y = Attribute<double>(attributes, name + ".y");
  const auto z = Attribute<double>(attributes, name + ".z");
  if (!x || !y || !z)
  {
    return std::nullopt;
  }
  return std::array<double, 3>{ *x, *y, *z };
}

/// Numbers of objects: those that any attribute "meso.<number>." speaks of.
std::map<int, MesoAOVObject> Objects(const MesoExrAttributes& attributes)
{
  std::map<int, MesoAOVObject> objects;
  for (const auto& attribute : attributes)
  {
    int number = 0;
    if (std::sscanf(attribute.first.c_str(), "meso.%d.", &number) != 1 || objects.count(number))
    {
      continue;
    }
    const std::string prefix = "meso." + std::to_string(number) + ".";
    MesoAOVObject& object = objects[number];
    object.Name = Attribute<std::string>(attributes, prefix + "name").value_or("");
    object.Scale = Attribute<double>(attributes, prefix + "scale").value_or(0.) *
      Attribute<double>(attributes, prefix + "world_units").value_or(1.);
    object.MapWidth =
      static_cast<int>(Attribute<double>(attributes, prefix + "map_width").value_or(0.));
    object.MapHeight =
      static_cast<int>(Attribute<double>(attributes, prefix + "map_height").value_or(0.));
  }
  return objects;
}

std::vector<MesoAOVLight> Lights(const MesoExrAttributes& attributes, std::size_t count)
{
  std::vector<MesoAOVLight> lights;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string prefix = "meso.light." + std::to_string(i) + ".";
    MesoAOVLight light;
    const auto position = Vector(attributes, prefix + "position");
    const auto direction = Vector(attributes, prefix + "towards");
    if (!position && !direction)
    {
      return {};
    }
    light.Positional = position.has_value();
    light.Place = position ? *position : *direction;
    lights.push_back(light);
  }
  return lights;
}

std::optional<MesoAOVCamera> Camera(const MesoExrAttributes& attributes)
{
  const std::string prefix = "meso.camera.";
  const auto position = Vector(attributes, prefix + "position");
  const auto forward = Vector(attributes, prefix + "forward");
  const auto right = Vector(attributes, prefix + "right");
  const auto up = Vector(attributes, prefix + "up");
  const auto parallel = Attribute<double>(attributes, prefix + "parallel");
  if (!position || !forward || !right || !up || !parallel)
  {
    return std::nullopt;
  }
  return MesoAOVCamera{ *position, *forward, *right, *up, *parallel != 0. };
}

void CheckChannel(bool inTruth, bool inTest, const std::string& channel,
  const std::string& truthName, const std::string& testName)
{
  if (inTruth != inTest)
  {
    throw MesoInputError((inTruth ? testName : truthName) + ": the channel " + channel +
      " is missing, which " + (inTruth ? truthName : testName) + " has");
  }
}
}

std::array<double, 3> MesoAOVs::PointAt(std::size_t pixel) const
{
  const double depth = this->Depth[pixel];
  const std::size_t column = pixel % this->Width;
  const std::size_t row = pixel / this->Width;
  const double spread = this->Camera->Parallel ? 1. : depth;
  const double x = spread * (2. * (column + 0.5) / this->Width - 1.);
  const double y = spread * (1. - 2. * (row + 0.5) / this->Height);
  std::array<double, 3> point;
  for (int i = 0; i < 3; ++i)
  {
    point[i] = this->Camera->Position[i] + depth * this->Camera->Forward[i] +
      x * this->Camera->Right[i] + y * this->Camera->Up[i];
  }
  return point;
}

MesoAOVs MesoAOVsOfImage(const MesoExrImage& image)
{
  MesoAOVs aovs;
  aovs.Width = image.Width;
  aovs.Height = image.Height;
  aovs.Coverage = Channel(image, "coverage");
  if (aovs.Coverage.empty())
  {
    throw MesoInputError("the channel coverage is missing");
  }
  aovs.Depth = Channel(image, "depth");
  TakeGroup<2>(image, "texcoord", { "u", "v" }, aovs.Texcoord);
  TakeGroup<3>(image, "normal", { "x", "y", "z" }, aovs.Normal);
  aovs.Object = Channel(image, "object");
  aovs.Base = Channel(image, "base");
  for (std::vector<float> shadow = Channel(image, "shadow.0"); !shadow.empty();
       shadow = Channel(image, "shadow." + std::to_string(aovs.Shadows.size())))
  {
    aovs.Shadows.push_back(shadow);
  }
  const std::size_t channels = image.ChannelNames.size();
  aovs.NotANumber.resize(aovs.NumberOfPixels());
  for (std::size_t i = 0; i < image.Data.size(); ++i)
  {
    if (!std::isfinite(image.Data[i]))
    {
      aovs.NotANumber[i / channels] = true;
    }
  }
  aovs.Objects = Objects(image.Attributes);
  aovs.Lights = Lights(image.Attributes, aovs.Shadows.size());
  aovs.Camera = Camera(image.Attributes);
  return aovs;
}

void MesoCheckComparable(const MesoAOVs& truth, const std::string& truthName, const MesoAOVs& test,
  const std::string& testName)
{
  if (truth.Width != test.Width || truth.Height != test.Height)
  {
    throw MesoInputError(testName + ": the size is " + std::to_string(test.Width) + "x" +
      std::to_string(test.Height) + ", that of " + truthName + " " + std::to_string(truth.Width) +
      "x" + std::to_string(truth.Height));
  }
  const auto check = [&](bool inTruth, bool inTest, const std::string& channel)
  { CheckChannel(inTruth, inTest, channel, truthName, testName); };
  check(!truth.Depth.empty(), !test.Depth.empty(), "depth");
  check(!truth.Texcoord[0].empty(), !test.Texcoord[0].empty(), "texcoord.u");
  check(!truth.Normal[0].empty(), !test.Normal[0].empty(), "normal.x");
  check(!truth.Object.empty(), !test.Object.empty(), "object");
  for (std::size_t i = 0; i < std::max(truth.Shadows.size(), test.Shadows.size()); ++i)
  {
    check(i < truth.Shadows.size(), i < test.Shadows.size(), "shadow." + std::to_string(i));
  }
  if (truth.Objects.size() != test.Objects.size())
  {
    throw MesoInputError(testName + ": the number of objects is " +
      std::to_string(test.Objects.size()) + ", that of " + truthName + " " +
      std::to_string(truth.Objects.size()));
  }
  const auto bad = std::find(truth.NotANumber.begin(), truth.NotANumber.end(), true);
  if (bad != truth.NotANumber.end())
  {
    const std::size_t pixel = bad - truth.NotANumber.begin();
    throw MesoInputError(truthName + ": the pixel in column " +
      std::to_string(pixel % truth.Width) + " of row " + std::to_string(pixel / truth.Width) +
      " holds NaN or Inf, so this is no truth");
  }
}

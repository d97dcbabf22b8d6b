#include "MesoScene.h"

#include "MesoFileBytes.h"
#include "MesoMessage.h"
#include "MesoSceneMesostructure.h"
#include "MesoSceneSurface.h"
#include "MesoSceneValue.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::size_t MostClippingPlanes = 6; // what VTK draws
constexpr double Pi = 3.14159265358979323846;

MesoVector3 Subtract(const MesoVector3& a, const MesoVector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Length(const MesoVector3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

double SineBetween(const MesoVector3& a, const MesoVector3& b)
{
  const MesoVector3 cross = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  return Length(cross) / (Length(a) * Length(b));
}

MesoSceneCamera ReadCamera(const MesoSceneValue& value)
{
  value.CheckKeys("camera");
  MesoSceneCamera camera;
  const auto vector = [&](const char* key, MesoVector3& target)
  { value.With(key, [&](const MesoSceneValue& numbers) { target = numbers.ToNumbers<3>(); }); };
  vector("position", camera.Position);
  vector("focal_point", camera.FocalPoint);
  value.With("view_up", [&](const MesoSceneValue& up) { camera.ViewUp = up.ToDirection(); });
  value.With("view_angle",
    [&](const MesoSceneValue& angle) {
      camera.ViewAngle = angle.ToNumber({ 0., 180., false });
    });
  value.With("parallel_scale",
    [&](const MesoSceneValue& scale)
    { camera.ParallelScale = scale.ToNumber(MesoSceneRanges::Positive); });
  value.With("clipping_range",
    [&](const MesoSceneValue& range)
    {
      camera.ClippingRange = range.ToNumbers<2>(MesoSceneRanges::Positive);
      if (!((*camera.ClippingRange)[0] < (*camera.ClippingRange)[1]))
      {
        range.Fail("the near distance must be less than the far one");
      }
    });
  const MesoVector3 view = Subtract(camera.FocalPoint, camera.Position);
  if (!(Length(view) > 0.))
  {
    value.Fail("position and focal_point must differ");
  }
  constexpr double least = 1e-6; // below it the view's axes are noise in single precision
  if (SineBetween(view, camera.ViewUp) < least)
  {
    value.Fail("view_up must not lie along the view");
  }
  return camera;
}

void ReadLightPlacement(const MesoSceneValue& value, MesoSceneLight& light)
{
  using Kind = MesoSceneLight::Kind;
  const auto refuse = [&](const std::vector<std::string>& keys, const char* kind)
  { value.Refuse(keys, std::string("is not a key of a ") + kind + " light"); };
  switch (light.Type)
  {
    case Kind::Headlight:
      refuse({ "direction", "position", "focal_point", "cone_angle", "exponent", "attenuation",
               "coordinates" },
        "headlight");
      break;
    case Kind::Directional:
      refuse({ "position", "focal_point", "cone_angle", "exponent", "attenuation" }, "directional");
      break;
    case Kind::Point:
      refuse({ "direction", "focal_point", "cone_angle", "exponent" }, "point");
      break;
    case Kind::Spot:
      refuse({ "direction" }, "spot");
      break;
  }
  value.With("direction",
    [&](const MesoSceneValue& direction) { light.Direction = direction.ToDirection(); });
  value.With(
    "position", [&](const MesoSceneValue& position) { light.Position = position.ToNumbers<3>(); });
  value.With(
    "focal_point", [&](const MesoSceneValue& point) { light.FocalPoint = point.ToNumbers<3>(); });
  if (light.Type == Kind::Spot && !(Length(Subtract(light.FocalPoint, light.Position)) > 0.))
  {
    value.Fail("position and focal_point must differ");
  }
  value.With("cone_angle",
    [&](const MesoSceneValue& angle) {
      light.ConeAngle = angle.ToNumber({ 0., 90., false });
    });
  // vtkLight clamps the exponent to 128 without a word.
  value.With("exponent",
    [&](const MesoSceneValue& exponent) {
      light.Exponent = exponent.ToNumber({ 0., 128., true });
    });
  value.With("attenuation",
    [&](const MesoSceneValue& attenuation)
    {
      light.Attenuation = attenuation.ToNumbers<3>(MesoSceneRanges::NotNegative);
      if (light.Attenuation == MesoVector3{ 0., 0., 0. })
      {
        attenuation.Fail("one of the three must be more than 0");
      }
    });
  value.With("coordinates",
    [&](const MesoSceneValue& name)
    {
      const std::string word = name.ToText();
      light.InCameraCoordinates = word == "camera";
      if (word != "camera" && word != "world")
      {
        name.FailChoice("coordinate system", word, { "world", "camera" }, {});
      }
    });
}

std::optional<MesoSceneLight::Kind> LightKindFromName(const std::string& name)
{
  using Kind = MesoSceneLight::Kind;
  static const std::map<std::string, Kind> kinds = { { "headlight", Kind::Headlight },
    { "directional", Kind::Directional }, { "point", Kind::Point }, { "spot", Kind::Spot } };
  const auto found = kinds.find(name);
  return found == kinds.end() ? std::optional<Kind>() : found->second;
}

MesoSceneLight ReadLight(const MesoSceneValue& value)
{
  value.CheckKeys("light");
  MesoSceneLight light;
  value.With("type",
    [&](const MesoSceneValue& name)
    {
      light.Type = name.ToChoice<MesoSceneLight::Kind>(
        "light", &LightKindFromName, { "headlight", "directional", "point", "spot" });
    });
  ReadLightPlacement(value, light);
  value.With("color",
    [&](const MesoSceneValue& color)
    { light.Color = color.ToNumbers<3>(MesoSceneRanges::NotNegative); });
  value.With("intensity",
    [&](const MesoSceneValue& intensity)
    { light.Intensity = intensity.ToNumber(MesoSceneRanges::NotNegative); });
  value.With("shadow", [&](const MesoSceneValue& shadow) { light.Shadow = shadow.ToBoolean(); });
  return light;
}

/// Rotation by `degrees` about a unit axis (Rodrigues), columns scaled, translation beside it.
std::array<double, 16> Compose(
  const MesoVector3& translate, double degrees, const MesoVector3& axis, const MesoVector3& scale)
{
  const double c = std::cos(degrees * Pi / 180.);
  const double s = std::sin(degrees * Pi / 180.);
  const auto [x, y, z] = axis;
  const double rotation[3][3] = { { c + x * x * (1. - c), x * y * (1. - c) - z * s,
                                    x * z * (1. - c) + y * s },
    { y * x * (1. - c) + z * s, c + y * y * (1. - c), y * z * (1. - c) - x * s },
    { z * x * (1. - c) - y * s, z * y * (1. - c) + x * s, c + z * z * (1. - c) } };
  std::array<double, 16> matrix = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = rotation[row][column] * scale[column];
    }
    matrix[4 * row + 3] = translate[row];
  }
  return matrix;
}

std::array<double, 16> ReadTransform(const MesoSceneValue& value)
{
  value.CheckKeys("transform");
  if (value.Has("matrix"))
  {
    value.Refuse({ "translate", "rotate", "scale" }, "there is a matrix already");
    const auto matrix = value.At("matrix").ToNumbers<16>();
    if (matrix[12] != 0. || matrix[13] != 0. || matrix[14] != 0. || matrix[15] != 1.)
    {
      value.At("matrix").Fail("the last row must be 0, 0, 0, 1 (matrices are row-major)");
    }
    return matrix;
  }
  MesoVector3 translate = { 0., 0., 0. };
  MesoVector3 axis = { 0., 0., 1. };
  MesoVector3 scale = { 1., 1., 1. };
  double degrees = 0.;
  value.With(
    "translate", [&](const MesoSceneValue& numbers) { translate = numbers.ToNumbers<3>(); });
  value.With("rotate",
    [&](const MesoSceneValue& numbers)
    {
      const auto rotate = numbers.ToNumbers<4>();
      degrees = rotate[0];
      const double length = std::hypot(rotate[1], rotate[2], rotate[3]);
      if (length < std::numeric_limits<double>::min())
      {
        numbers.Fail("the axis (the last three of [angle, x, y, z]) must not be 0");
      }
      axis = { rotate[1] / length, rotate[2] / length, rotate[3] / length };
    });
  value.With("scale",
    [&](const MesoSceneValue& numbers)
    {
      scale.fill(numbers.IsNumber() ? numbers.ToNumber() : 1.);
      scale = numbers.IsNumber() ? scale : numbers.ToNumbers<3>();
    });
  return Compose(translate, degrees, axis, scale);
}

MesoSceneNode ReadNode(const MesoSceneValue& value)
{
  value.CheckKeys("node");
  MesoSceneNode node;
  value.With("name", [&](const MesoSceneValue& name) { node.Name = name.ToText(); });
  value.With(
    "transform", [&](const MesoSceneValue& transform) { node.Matrix = ReadTransform(transform); });
  value.With("mesh", [&](const MesoSceneValue& mesh) { node.Mesh = MesoReadSceneMesh(mesh); });
  if (!node.Mesh)
  {
    value.Refuse({ "feature_angle", "subdivide", "part", "material", "mesostructure" },
      "there is no mesh beside it that it is of");
  }
  value.With("feature_angle",
    [&](const MesoSceneValue& angle) {
      node.Mesh->FeatureAngle = angle.ToNumber({ 0., 180., true });
    });
  value.With("part", [&](const MesoSceneValue& part) { node.Part = MesoReadScenePart(part); });
  value.With("subdivide",
    [&](const MesoSceneValue& times)
    {
      if (node.Mesh->File.empty())
      {
        times.Fail("is for mesh files; a built-in shape has finer numbers of its own");
      }
      node.Mesh->Subdivide = static_cast<int>(times.ToInteger({ 0., 6., true }));
    });
  value.With("material",
    [&](const MesoSceneValue& material) { node.Material = MesoReadSceneMaterial(material); });
  value.With("mesostructure",
    [&](const MesoSceneValue& options) { MesoReadSceneMesostructure(options, node); });
  if (node.Material.ColorBy && node.Material.ColorBy->IsHeight() && !node.Map)
  {
    value.At("material")
      .At("color_by")
      .Fail("height is that of a height_map or a depth_map, and the node has none");
  }
  if (node.Material.Contours && !node.Map)
  {
    value.At("material")
      .At("contours")
      .Fail("contour lines are those of a height_map or a depth_map, and the node has none");
  }
  value.With("children",
    [&](const MesoSceneValue& children)
    {
      for (const MesoSceneValue& child : children.ToList())
      {
        node.Children.push_back(ReadNode(child));
      }
    });
  return node;
}

MesoScene ReadScene(const MesoSceneValue& value, const std::string& fileName)
{
  if (value.Has("meso"))
  {
    const double version = value.At("meso").ToNumber();
    if (version != 1.)
    {
      value.At("meso").Fail(
        "scene format " + MesoNumberText(version) + " is not known; this program reads format 1");
    }
  }
  value.CheckKeys("scene");
  value.At("meso");
  MesoScene scene;
  scene.File = fileName;
  value.With("camera", [&](const MesoSceneValue& camera) { scene.Camera = ReadCamera(camera); });
  value.With("lights",
    [&](const MesoSceneValue& lights)
    {
      scene.Lights.clear();
      for (const MesoSceneValue& light : lights.ToList())
      {
        scene.Lights.push_back(ReadLight(light));
      }
    });
  value.With("background",
    [&](const MesoSceneValue& color)
    { scene.Background = color.ToNumbers<3>(MesoSceneRanges::Fraction); });
  value.With("clipping_planes",
    [&](const MesoSceneValue& planes)
    {
      for (const MesoSceneValue& plane : planes.ToList())
      {
        const auto parts = plane.ToList(2);
        scene.ClippingPlanes.push_back({ parts[0].ToNumbers<3>(), parts[1].ToDirection() });
      }
      if (scene.ClippingPlanes.size() > MostClippingPlanes)
      {
        planes.Fail("at most " + std::to_string(MostClippingPlanes) + " planes can be drawn");
      }
    });
  value.With("nodes",
    [&](const MesoSceneValue& nodes)
    {
      for (const MesoSceneValue& node : nodes.ToList())
      {
        scene.Nodes.push_back(ReadNode(node));
      }
    });
  return scene;
}

MesoScene ParseScene(const std::string& text, const MesoSceneSource& source)
{
  const MesoJsonValue root = MesoParseJson(text, source.FileName);
  return ReadScene(MesoSceneValue(root, "", source), source.FileName);
}
}

MesoScene MesoReadScene(const std::string& fileName)
{
  const std::string text = MesoReadBytes(fileName, MesoLargestSceneFile, "a scene file");
  return ParseScene(text, { fileName, true });
}

MesoScene MesoParseScene(const std::string& text, const std::string& fileName)
{
  return ParseScene(text, { fileName, false });
}

#include "FiguresJson.h"

#include <cmath>

namespace
{
using Json = nlohmann::ordered_json;

Json NumberOrNull(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

Json PixelOf(const MesoErrorSpread& spread, int width)
{
  return spread.Count == 0 ? Json()
                           : Json({ spread.WorstPixel % width, spread.WorstPixel / width });
}

const char* DepthUnit(bool inScale)
{
  return inScale ? "D" : "world unit";
}
}

Json JsonOfError(const MesoImageError& error)
{
  Json json;
  for (const MesoFigure& figure : MesoFiguresOfError(error))
  {
    const bool count = figure.Unit == "pixels" && std::isfinite(figure.Value);
    json[figure.Name] =
      count ? Json(static_cast<long long>(figure.Value)) : NumberOrNull(figure.Value);
  }
  if (!error.Geometry)
  {
    return json;
  }
  json["depth_unit"] = DepthUnit(error.Geometry->DepthInScale);
  json["worst_depth"] = PixelOf(error.Geometry->Depth, error.Width);
  json["worst_texcoord"] = PixelOf(error.Geometry->Texcoord, error.Width);
  json["objects"] = Json::array();
  for (const MesoObjectError& object : error.Geometry->Objects)
  {
    json["objects"].push_back({ { "number", object.Number }, { "name", object.Name },
      { "depth_unit", DepthUnit(object.DepthInScale) },
      { "depth_rms", NumberOrNull(object.Depth.Rms) },
      { "depth_p95", NumberOrNull(object.Depth.P95) },
      { "depth_max", NumberOrNull(object.Depth.Maximum) },
      { "texcoord_p50", NumberOrNull(object.Texcoord.P50) },
      { "texcoord_p95", NumberOrNull(object.Texcoord.P95) },
      { "texcoord_p99", NumberOrNull(object.Texcoord.P99) },
      { "texcoord_max", NumberOrNull(object.Texcoord.Maximum) } });
  }
  return json;
}

Json JsonOfMilliseconds(const MesoMilliseconds& milliseconds)
{
  return { { "median", milliseconds.Median }, { "min", milliseconds.Minimum },
    { "max", milliseconds.Maximum } };
}

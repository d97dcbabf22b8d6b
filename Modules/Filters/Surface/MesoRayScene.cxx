#include "MesoRayScene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{
constexpr double Padding = 1e-6; // of the unit ball
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct FloatBox
{
  float Low[3];
  float High[3];
};

/// What a geometry's callbacks are handed.
struct Geometry
{
  int Number;
  std::vector<MesoBox> Boxes;       // in world space, until the scene's ball is known
  std::vector<FloatBox> FloatBoxes; // in the unit ball
  std::vector<glm::dvec3> Points;
  std::vector<std::array<std::uint32_t, 3>> Triangles;
};

/// The context of a ray, which Embree hands back to the callbacks.
struct Context
{
  RTCIntersectContext Embree; // must be first
  MesoRayQuery* Query;
  double TEntry; // where the float ray begins, in the query's t
  double PerT;   // unit of the float ray's t in the query's t
};

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The end of a float ray that reaches the query's end, and a little further.
float FloatEnd(const Context& context)
{
  return context.Query->Done
    ? -std::numeric_limits<float>::infinity()
    : static_cast<float>((context.Query->TMax - context.TEntry) / context.PerT + 2. * Padding);
}

void BoundsOf(const RTCBoundsFunctionArguments* arguments)
{
  const auto& box =
    static_cast<const Geometry*>(arguments->geometryUserPtr)->FloatBoxes[arguments->primID];
  arguments->bounds_o->lower_x = box.Low[0];
  arguments->bounds_o->lower_y = box.Low[1];
  arguments->bounds_o->lower_z = box.Low[2];
  arguments->bounds_o->upper_x = box.High[0];
  arguments->bounds_o->upper_y = box.High[1];
  arguments->bounds_o->upper_z = box.High[2];
}

void IntersectPrimitive(const RTCIntersectFunctionNArguments* arguments)
{
  if (arguments->valid[0] == 0)
  {
    return;
  }
  auto* context = reinterpret_cast<Context*>(arguments->context);
  const auto* geometry = static_cast<const Geometry*>(arguments->geometryUserPtr);
  context->Query->Test(geometry->Number, arguments->primID);
  RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
  float& end = RTCRayN_tfar(ray, arguments->N, 0);
  end = std::min(end, FloatEnd(*context));
}

void FilterTriangle(const RTCFilterFunctionNArguments* arguments)
{
  if (arguments->valid[0] == 0)
  {
    return;
  }
  auto* context = reinterpret_cast<Context*>(arguments->context);
  const auto* geometry = static_cast<const Geometry*>(arguments->geometryUserPtr);
  const double t = context->TEntry +
    static_cast<double>(RTCRayN_tfar(arguments->ray, arguments->N, 0)) * context->PerT;
  const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
    RTCRayN_dir_y(arguments->ray, arguments->N, 0), RTCRayN_dir_z(arguments->ray, arguments->N, 0));
  const glm::vec3 normal(RTCHitN_Ng_x(arguments->hit, arguments->N, 0),
    RTCHitN_Ng_y(arguments->hit, arguments->N, 0), RTCHitN_Ng_z(arguments->hit, arguments->N, 0));
  const bool taken = context->Query->TestTriangle(geometry->Number,
    RTCHitN_primID(arguments->hit, arguments->N, 0), t, glm::dot(normal, direction) < 0.f);
  arguments->valid[0] = taken ? -1 : 0;
}
}

struct MesoRayScene::Implementation
{
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  std::vector<std::unique_ptr<Geometry>> Geometries;
  glm::dvec3 Centre = glm::dvec3(0.);
  double Radius = 1.;
  std::atomic<std::int64_t> Bytes{ 0 };

  static bool CountMemory(void* self, ssize_t bytes, bool)
  {
    static_cast<Implementation*>(self)->Bytes += bytes;
    return true;
  }
  glm::dvec3 ToBall(const glm::dvec3& point) const { return (point - this->Centre) / this->Radius; }
  void FindBall();
  void Attach(Geometry& geometry);
  void Check(const char* what) const
  {
    const RTCError error = rtcGetDeviceError(this->Device);
    if (error != RTC_ERROR_NONE)
    {
      throw std::runtime_error(std::string("the ray tracer could not ") + what +
        (error == RTC_ERROR_OUT_OF_MEMORY ? ": out of memory" : ""));
    }
  }
};

MesoRayScene::MesoRayScene()
  : Inside(std::make_unique<Implementation>())
{
  this->Inside->Device = rtcNewDevice(nullptr);
  if (!this->Inside->Device)
  {
    throw std::runtime_error("the ray tracer could not be started");
  }
  rtcSetDeviceMemoryMonitorFunction(
    this->Inside->Device, Implementation::CountMemory, this->Inside.get());
}

MesoRayScene::~MesoRayScene()
{
  if (this->Inside->Scene)
  {
    rtcReleaseScene(this->Inside->Scene);
  }
  rtcReleaseDevice(this->Inside->Device);
}

int MesoRayScene::AddPrimitives(
  std::size_t count, const std::function<MesoBox(std::size_t primitive)>& boxOf)
{
  auto geometry = std::make_unique<Geometry>();
  geometry->Number = static_cast<int>(this->Inside->Geometries.size());
  geometry->Boxes.reserve(count);
  for (std::size_t primitive = 0; primitive < count; ++primitive)
  {
    geometry->Boxes.push_back(boxOf(primitive));
  }
  this->Inside->Geometries.push_back(std::move(geometry));
  return this->Inside->Geometries.back()->Number;
}

int MesoRayScene::AddTriangles(
  const std::vector<glm::dvec3>& points, std::vector<std::array<std::uint32_t, 3>> triangles)
{
  auto geometry = std::make_unique<Geometry>();
  geometry->Number = static_cast<int>(this->Inside->Geometries.size());
  geometry->Points = points;
  geometry->Triangles = std::move(triangles);
  this->Inside->Geometries.push_back(std::move(geometry));
  return this->Inside->Geometries.back()->Number;
}

void MesoRayScene::Implementation::FindBall()
{
  glm::dvec3 low(Infinity);
  glm::dvec3 high(-Infinity);
  for (const auto& geometry : this->Geometries)
  {
    for (const MesoBox& box : geometry->Boxes)
    {
      if (IsFinite(box.Low) && IsFinite(box.High))
      {
        low = glm::min(low, box.Low);
        high = glm::max(high, box.High);
      }
    }
    for (const glm::dvec3& point : geometry->Points)
    {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  if (low.x <= high.x)
  {
    this->Centre = 0.5 * (low + high);
    const double radius = 0.5 * glm::length(high - low);
    this->Radius = radius > 0. ? radius : 1.;
  }
}

void MesoRayScene::Implementation::Attach(Geometry& geometry)
{
  RTCGeometry handle = nullptr;
  if (geometry.Triangles.empty())
  {
    // What is not finite becomes an empty box, which Embree leaves out.
    constexpr float Least = std::numeric_limits<float>::infinity();
    geometry.FloatBoxes.assign(
      geometry.Boxes.size(), { { Least, Least, Least }, { -Least, -Least, -Least } });
    for (std::size_t i = 0; i < geometry.Boxes.size(); ++i)
    {
      const glm::dvec3 low = this->ToBall(geometry.Boxes[i].Low);
      const glm::dvec3 high = this->ToBall(geometry.Boxes[i].High);
      if (IsFinite(low) && IsFinite(high))
      {
        for (int k = 0; k < 3; ++k)
        {
          geometry.FloatBoxes[i].Low[k] = static_cast<float>(low[k] - Padding);
          geometry.FloatBoxes[i].High[k] = static_cast<float>(high[k] + Padding);
        }
      }
    }
    geometry.Boxes = {};
    handle = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(handle, static_cast<unsigned int>(geometry.FloatBoxes.size()));
    rtcSetGeometryBoundsFunction(
      handle, [](const RTCBoundsFunctionArguments* arguments) { BoundsOf(arguments); }, nullptr);
    rtcSetGeometryIntersectFunction(handle, IntersectPrimitive);
  }
  else
  {
    handle = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(handle, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), geometry.Points.size()));
    auto* corners =
      static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(handle, RTC_BUFFER_TYPE_INDEX, 0,
        RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), geometry.Triangles.size()));
    this->Check("hold the triangles");
    for (std::size_t i = 0; i < geometry.Points.size(); ++i)
    {
      const glm::dvec3 point = this->ToBall(geometry.Points[i]);
      for (int k = 0; k < 3; ++k)
      {
        points[3 * i + k] = static_cast<float>(point[k]);
      }
    }
    std::copy_n(geometry.Triangles[0].data(), 3 * geometry.Triangles.size(), corners);
    geometry.Points = {};
    geometry.Triangles = {};
    rtcSetGeometryIntersectFilterFunction(handle, FilterTriangle);
  }
  rtcSetGeometryUserData(handle, &geometry);
  rtcCommitGeometry(handle);
  rtcAttachGeometry(this->Scene, handle);
  rtcReleaseGeometry(handle);
}

void MesoRayScene::Commit()
{
  Implementation& inside = *this->Inside;
  inside.FindBall();
  inside.Scene = rtcNewScene(inside.Device);
  rtcSetSceneFlags(inside.Scene, RTC_SCENE_FLAG_ROBUST);
  for (auto& geometry : inside.Geometries)
  {
    inside.Attach(*geometry);
  }
  rtcCommitScene(inside.Scene);
  inside.Check("build its hierarchy");
}

void MesoRayScene::Trace(MesoRayQuery& query) const
{
  const Implementation& inside = *this->Inside;
  // Where the ray enters and leaves the ball, which is taken a little too large.
  const glm::dvec3 origin = inside.ToBall(query.Origin);
  const glm::dvec3 direction = query.Direction / inside.Radius;
  const double speed = glm::length(direction);
  const double nearest = -glm::dot(origin, direction) / (speed * speed);
  const glm::dvec3 off = origin + nearest * direction;
  constexpr double BallRadius = 1.01;
  const double half = BallRadius * BallRadius - glm::dot(off, off);
  if (!(half > 0.))
  {
    return;
  }
  const double reach = std::sqrt(half) / speed;
  const double from = std::max(query.TMin, nearest - reach);
  if (!(from <= std::min(query.TMax, nearest + reach)))
  {
    return;
  }
  // The point of entry from the ball's middle, not from the origin, which may be far away.
  const glm::dvec3 entry = off + (from - nearest) * direction;

  Context context;
  rtcInitIntersectContext(&context.Embree);
  context.Query = &query;
  context.TEntry = from;
  context.PerT = 1. / speed;
  RTCRayHit ray;
  ray.ray.org_x = static_cast<float>(entry.x);
  ray.ray.org_y = static_cast<float>(entry.y);
  ray.ray.org_z = static_cast<float>(entry.z);
  ray.ray.dir_x = static_cast<float>(direction.x / speed);
  ray.ray.dir_y = static_cast<float>(direction.y / speed);
  ray.ray.dir_z = static_cast<float>(direction.z / speed);
  ray.ray.tnear = 0.f;
  ray.ray.tfar = std::min(FloatEnd(context), 4.f);
  ray.ray.time = 0.f;
  ray.ray.mask = ~0u;
  ray.ray.id = 0;
  ray.ray.flags = 0;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(inside.Scene, &context.Embree, &ray);
}

double MesoRayScene::Rounding() const
{
  return Padding * this->Inside->Radius;
}

std::size_t MesoRayScene::MemoryBytes() const
{
  std::size_t bytes = static_cast<std::size_t>(std::max<std::int64_t>(0, this->Inside->Bytes));
  for (const auto& geometry : this->Inside->Geometries)
  {
    bytes += geometry->FloatBoxes.size() * sizeof(FloatBox);
  }
  return bytes;
}

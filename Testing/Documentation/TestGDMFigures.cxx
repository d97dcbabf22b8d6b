// The drawings of Documentation/Techniques/GDM.md: Wang2004, Figures 2 to 6, in sections. What they show is computed as
// the technique does it, and asserted.

#include "MesoBaseline.h"
#include "MesoTestScene.h"
#include "MesoVolumeRay.h"

#include "vtkAutoInit.h"
#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextItem.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2)

namespace
{
using Point = std::array<double, 2>;

enum class Ink
{
  Black,
  Grey,
  Red,
  Blue,
  Green,
  Solid
};

/// Lines, dots and letters in pixels.
class Drawing : public vtkContextItem
{
public:
  static Drawing* New();
  vtkTypeMacro(Drawing, vtkContextItem);

  std::function<void(Drawing&)> Content;

  bool Paint(vtkContext2D* painter) override
  {
    this->Painter = painter;
    painter->GetTextProp()->SetFontSize(14);
    painter->GetTextProp()->SetColor(0., 0., 0.);
    this->Content(*this);
    return true;
  }

  void Line(const Point& from, const Point& to, Ink ink, float width = 2.f, bool isDashed = false)
  {
    this->Take(ink, width, isDashed);
    this->Painter->DrawLine(static_cast<float>(from[0]), static_cast<float>(from[1]),
      static_cast<float>(to[0]), static_cast<float>(to[1]));
  }
  void Path(const std::vector<Point>& points, Ink ink, float width = 2.f, bool isDashed = false)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      this->Line(points[i - 1], points[i], ink, width, isDashed);
    }
  }
  void Arrow(const Point& from, const Point& to, Ink ink, float width = 2.f)
  {
    this->Line(from, to, ink, width);
    const double angle = std::atan2(to[1] - from[1], to[0] - from[0]);
    constexpr double head = 9.;
    for (const double side : { -0.4, 0.4 })
    {
      this->Line(to,
        { to[0] - head * std::cos(angle + side), to[1] - head * std::sin(angle + side) }, ink,
        width);
    }
  }
  void Dot(const Point& at, Ink ink, float radius = 4.f)
  {
    this->Take(ink, 1.f, false);
    this->Painter->DrawEllipse(
      static_cast<float>(at[0]), static_cast<float>(at[1]), radius, radius);
  }
  void Disc(const Point& at, double radius)
  {
    this->Dot(at, Ink::Solid, static_cast<float>(radius));
  }
  void Box(const Point& low, const Point& high)
  {
    this->Take(Ink::Solid, 1.f, false);
    this->Painter->DrawRect(static_cast<float>(low[0]), static_cast<float>(low[1]),
      static_cast<float>(high[0] - low[0]), static_cast<float>(high[1] - low[1]));
  }
  void Text(const Point& at, const char* text)
  {
    this->Painter->DrawString(static_cast<float>(at[0]), static_cast<float>(at[1]), text);
  }

private:
  void Take(Ink ink, float width, bool isDashed)
  {
    constexpr unsigned char colors[][3] = { { 0, 0, 0 }, { 150, 150, 150 }, { 200, 40, 40 },
      { 31, 119, 180 }, { 40, 140, 60 }, { 222, 205, 170 } };
    const unsigned char* color = colors[static_cast<int>(ink)];
    this->Painter->GetPen()->SetColor(color[0], color[1], color[2], 255);
    this->Painter->GetPen()->SetWidth(width);
    this->Painter->GetPen()->SetLineType(isDashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
    this->Painter->GetBrush()->SetColor(color[0], color[1], color[2], 255);
  }

  vtkContext2D* Painter = nullptr;
};
vtkStandardNewMacro(Drawing);

testing::AssertionResult Matches(
  const char* name, int width, int height, const std::function<void(Drawing&)>& content)
{
  MesoTestScene scene(width, height);
  scene.Renderer->RemoveActor(scene.Actor);
  scene.Window->SetMultiSamples(4);
  scene.Renderer->SetBackground(1., 1., 1.);
  vtkNew<Drawing> drawing;
  drawing->Content = content;
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(drawing);
  scene.Renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(scene.Renderer);
  return MesoCompareWithBaseline(
    MesoGrabWindow(scene.Window), name, MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER });
}

/// Two round bars along y in a shell one tile wide and half a tile deep.
MesoVolumeField Bars()
{
  constexpr int columns = 128;
  constexpr int slices = 64;
  std::vector<float> values;
  for (int k = 0; k < slices; ++k)
  {
    for (int row = 0; row < 2; ++row)
    {
      for (int i = 0; i < columns; ++i)
      {
        const double x = (i + 0.5) / columns;
        const double z = 0.5 * (k + 0.5) / slices;
        values.push_back(static_cast<float>(
          std::min(std::hypot(x - 0.3, z - 0.3) - 0.11, std::hypot(x - 0.72, z - 0.14) - 0.11)));
      }
    }
  }
  return { { columns, 2, slices }, 0.5, values };
}

/// Where a section of Bars() is drawn.
struct Section
{
  Point Origin;
  double Tile; ///< pixels

  Point At(double x, double z) const
  {
    return { this->Origin[0] + x * this->Tile, this->Origin[1] + z * this->Tile };
  }
  void Draw(Drawing& drawing) const
  {
    for (const Point& middle : { Point{ 0.3, 0.3 }, Point{ 0.72, 0.14 } })
    {
      drawing.Disc(this->At(middle[0], middle[1]), 0.11 * this->Tile);
    }
    for (const double z : { 0., 0.5 })
    {
      drawing.Line(this->At(0., z), this->At(1., z), Ink::Black, 1.f);
    }
  }
};

MesoVolumeRay::Hit Cast(const MesoVolumeField& field, const Point& from, double degrees)
{
  const double angle = degrees * std::acos(-1.) / 180.;
  return MesoVolumeRay(field).Cast(
    { from[0], 0.5, from[1] / 0.5 }, { std::cos(angle), 0., std::sin(angle) }, 8.);
}

Point Along(const Point& from, double degrees, double distance)
{
  const double angle = degrees * std::acos(-1.) / 180.;
  return { from[0] + distance * std::cos(angle), from[1] + distance * std::sin(angle) };
}
}

TEST(GDMFigures, DistancesInThreeCases)
{
  const MesoVolumeField field = Bars();
  const Point starts[3] = { { 0.08, 0.06 }, { 0.5, 0.08 }, { 0.72, 0.14 } };
  const double degrees[3] = { 40., 62., 150. };
  const auto meets = Cast(field, starts[0], degrees[0]);
  const auto leaves = Cast(field, starts[1], degrees[1]);
  const auto inside = Cast(field, starts[2], degrees[2]);
  EXPECT_TRUE(meets.IsHit);
  EXPECT_NEAR(std::hypot(Along(starts[0], 40., meets.Distance)[0] - 0.3,
                Along(starts[0], 40., meets.Distance)[1] - 0.3),
    0.11, 1e-3);
  EXPECT_FALSE(leaves.IsHit);
  EXPECT_NEAR(Along(starts[1], 62., leaves.Distance)[1], 0.5, 1e-9); // to the plane (section 4.1)
  EXPECT_EQ(inside.Distance, 0.);
  const double distances[3] = { meets.Distance, leaves.Distance, inside.Distance };
  EXPECT_TRUE(Matches("GDMFigureDistances", 420, 230,
    [&](Drawing& drawing)
    {
      const Section section = { { 20., 20. }, 380. };
      section.Draw(drawing);
      const char* const names[3] = { "d: to the solid", "d: to the plane", "d = 0" };
      for (int i = 0; i < 3; ++i)
      {
        const Point from = section.At(starts[i][0], starts[i][1]);
        const Point end = Along(starts[i], degrees[i], distances[i]);
        const Point far = Along(starts[i], degrees[i], std::max(distances[i], 0.15));
        drawing.Arrow(from, section.At(far[0], far[1]), i == 2 ? Ink::Grey : Ink::Blue);
        drawing.Dot(from, Ink::Black);
        drawing.Dot(section.At(end[0], end[1]), Ink::Red);
        drawing.Text({ from[0] + (i == 2 ? -18. : 8.), from[1] - 19. }, names[i]);
      }
    }));
}

namespace
{
double Cross(const Point& a, const Point& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// A prism in section: bottom and top of two neighbouring corners.
struct Slab
{
  Point Bottom[2];
  Point Top[2];

  Point At(double u, double z) const
  {
    Point p{};
    for (int i = 0; i < 2; ++i)
    {
      p[i] = (1. - u) * ((1. - z) * this->Bottom[0][i] + z * this->Top[0][i]) +
        u * ((1. - z) * this->Bottom[1][i] + z * this->Top[1][i]);
    }
    return p;
  }
  /// (u, z) of a point, by Newton's steps.
  Point PlaceOf(const Point& p) const
  {
    Point place = { 0.5, 0.5 };
    for (int step = 0; step < 20; ++step)
    {
      constexpr double h = 1e-6;
      const Point here = this->At(place[0], place[1]);
      const Point u = this->At(place[0] + h, place[1]);
      const Point z = this->At(place[0], place[1] + h);
      const Point du = { (u[0] - here[0]) / h, (u[1] - here[1]) / h };
      const Point dz = { (z[0] - here[0]) / h, (z[1] - here[1]) / h };
      const Point off = { p[0] - here[0], p[1] - here[1] };
      place[0] += Cross(off, dz) / Cross(du, dz);
      place[1] += Cross(du, off) / Cross(du, dz);
    }
    return place;
  }
};
}

TEST(GDMFigures, ARayInObjectSpaceAndInTextureSpace)
{
  // Four corners of a round base, extruded along their normals.
  constexpr double radius = 170.;
  constexpr double thickness = 80.;
  const Point centre = { 160., -65. };
  std::vector<Slab> slabs(3);
  for (int i = 0; i < 3; ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const double angle = (130. - 27. * (i + side)) * std::acos(-1.) / 180.;
      const Point normal = { std::cos(angle), std::sin(angle) };
      for (int k = 0; k < 2; ++k)
      {
        slabs[i].Bottom[side][k] = centre[k] + radius * normal[k];
        slabs[i].Top[side][k] = centre[k] + (radius + thickness) * normal[k];
      }
    }
  }
  const Point eye = { 20., 196. };
  const Point end = { 320., 94. };
  const auto onRay = [&](double t) {
    return Point{ eye[0] + t * (end[0] - eye[0]), eye[1] + t * (end[1] - eye[1]) };
  };
  // Its way through each prism: where it is inside.
  std::vector<std::vector<Point>> ways(3);
  std::vector<std::array<Point, 2>> crossings(3);
  constexpr int steps = 3000;
  for (int i = 0; i < 3; ++i)
  {
    for (int step = 0; step <= steps; ++step)
    {
      const Point p = onRay(double(step) / steps);
      const Point place = slabs[i].PlaceOf(p);
      if (place[0] >= 0. && place[0] <= 1. && place[1] >= 0. && place[1] <= 1.)
      {
        crossings[i][ways[i].empty() ? 0 : 1] = p;
        ways[i].push_back({ i + place[0], place[1] });
      }
    }
    ASSERT_GT(ways[i].size(), 10u) << i;
  }
  // One way ends where the next begins, and the middle one bends away from the straight one.
  EXPECT_NEAR(ways[0].back()[0], 1., 0.02);
  EXPECT_NEAR(ways[0].back()[1], ways[1].front()[1], 0.02);
  const std::vector<Point>& way = ways[1];
  const Point chord = { way.back()[0] - way.front()[0], way.back()[1] - way.front()[1] };
  double bend = 0.;
  for (const Point& place : way)
  {
    const Point off = { place[0] - way.front()[0], place[1] - way.front()[1] };
    bend = std::max(bend, std::abs(Cross(chord, off)) / std::hypot(chord[0], chord[1]));
  }
  EXPECT_GT(bend, 0.01);
  EXPECT_LT(bend, 0.2);
  EXPECT_TRUE(Matches("GDMFigureSpaces", 640, 240,
    [&](Drawing& drawing)
    {
      for (int i = 0; i < 3; ++i)
      {
        const Slab& slab = slabs[i];
        drawing.Path({ slab.Bottom[0], slab.Bottom[1] }, Ink::Black, 3.f);
        drawing.Path({ slab.Bottom[1], slab.Top[1], slab.Top[0], slab.Bottom[0] }, Ink::Black, 1.f);
      }
      drawing.Arrow(eye, end, Ink::Grey, 1.f);
      const auto texture = [](const Point& place) {
        return Point{ 370. + 85. * place[0], 70. + 85. * place[1] };
      };
      for (int i = 0; i < 4; ++i)
      {
        drawing.Line(texture({ double(i), 0. }), texture({ double(i), 1. }), Ink::Black, 1.f);
      }
      drawing.Line(texture({ 0., 0. }), texture({ 3., 0. }), Ink::Black, 3.f);
      drawing.Line(texture({ 0., 1. }), texture({ 3., 1. }), Ink::Black, 1.f);
      constexpr Ink inks[3] = { Ink::Blue, Ink::Red, Ink::Green };
      for (int i = 0; i < 3; ++i)
      {
        drawing.Line(crossings[i][0], crossings[i][1], inks[i], 3.f);
        std::vector<Point> curve;
        for (const Point& place : ways[i])
        {
          curve.push_back(texture(place));
        }
        drawing.Path(curve, Ink::Grey, 1.f);
        drawing.Line(curve.front(), curve.back(), inks[i], 2.f);
        for (const Point& p : { crossings[i][0], crossings[i][1], curve.front(), curve.back() })
        {
          drawing.Dot(p, Ink::Black, 3.f);
        }
      }
      drawing.Text({ 105., 10. }, "object space");
      drawing.Text({ 440., 10. }, "texture space");
    }));
}

TEST(GDMFigures, WhereARayLeavesByAFin)
{
  // A fin of two triangles in section, bent outward (convex: both planes must still be ahead) and inward.
  struct Fin
  {
    Point Ends[3];
  };
  const Fin fins[2] = { { { { 250., 30. }, { 285., 105. }, { 250., 180. } } },
    { { { 270., 30. }, { 225., 105. }, { 270., 180. } } } };
  const Point from = { 60., 150. };
  const Point through = { 300., 45. };
  std::array<std::array<double, 2>, 2> planes{};
  std::array<double, 2> exits{};
  for (int which = 0; which < 2; ++which)
  {
    for (int half = 0; half < 2; ++half)
    {
      const Point& a = fins[which].Ends[half];
      const Point& b = fins[which].Ends[half + 1];
      const Point along = { b[0] - a[0], b[1] - a[1] };
      planes[which][half] = Cross({ a[0] - from[0], a[1] - from[1] }, along) /
        Cross({ through[0] - from[0], through[1] - from[1] }, along);
    }
    exits[which] =
      which == 0 ? std::min(planes[0][0], planes[0][1]) : std::max(planes[1][0], planes[1][1]);
    // The exit lies on the fin itself, not on a plane beyond it.
    const double y = from[1] + exits[which] * (through[1] - from[1]);
    const bool isLower = exits[which] == planes[which][0];
    EXPECT_EQ(y <= 105., isLower) << which;
  }
  EXPECT_TRUE(Matches("GDMFigureExit", 640, 220,
    [&](Drawing& drawing)
    {
      for (int which = 0; which < 2; ++which)
      {
        const double shift = 320. * which;
        const auto at = [&](const Point& p) { return Point{ p[0] + shift, p[1] }; };
        const auto onRay = [&](double t) {
          return at({ from[0] + t * (through[0] - from[0]), from[1] + t * (through[1] - from[1]) });
        };
        const Point* ends = fins[which].Ends;
        drawing.Path(
          { at(ends[0]), at({ 90., 30. }), at({ 90., 180. }), at(ends[2]) }, Ink::Black, 1.f);
        for (int half = 0; half < 2; ++half)
        {
          const Point& a = ends[half];
          const Point& b = ends[half + 1];
          drawing.Line(at({ a[0] - 0.5 * (b[0] - a[0]), a[1] - 0.5 * (b[1] - a[1]) }),
            at({ b[0] + 0.5 * (b[0] - a[0]), b[1] + 0.5 * (b[1] - a[1]) }), Ink::Grey, 1.f, true);
          drawing.Line(at(a), at(b), Ink::Black, 3.f);
        }
        drawing.Arrow(at(from), onRay(1.05), Ink::Grey, 1.f);
        drawing.Line(
          onRay((90. - from[0]) / (through[0] - from[0])), onRay(exits[which]), Ink::Blue, 3.f);
        for (const double t : planes[which])
        {
          drawing.Dot(onRay(t), t == exits[which] ? Ink::Red : Ink::Grey);
        }
        drawing.Text({ 100. + shift, 6. },
          which == 0 ? "bent outward: the first plane" : "bent inward: the last plane");
      }
    }));
}

TEST(GDMFigures, ShadowByTheSameTable)
{
  const MesoVolumeField field = Bars();
  // From the lower bar towards a light at the upper left, and from the upper one.
  constexpr double light = 148.;
  const Point hits[2] = { { 0.72 + 0.112 * std::cos(2.6), 0.14 + 0.112 * std::sin(2.6) },
    { 0.3 + 0.112 * std::cos(2.), 0.3 + 0.112 * std::sin(2.) } };
  const auto blocked = Cast(field, hits[0], light);
  const auto lit = Cast(field, hits[1], light);
  EXPECT_TRUE(blocked.IsHit);
  EXPECT_FALSE(lit.IsHit);
  EXPECT_TRUE(Matches("GDMFigureShadow", 420, 230,
    [&](Drawing& drawing)
    {
      const Section section = { { 20., 20. }, 380. };
      section.Draw(drawing);
      for (int i = 0; i < 2; ++i)
      {
        const double distance = i == 0 ? blocked.Distance : lit.Distance;
        const double toPlane = (0.5 - hits[i][1]) / std::sin(light * std::acos(-1.) / 180.);
        const Point from = section.At(hits[i][0], hits[i][1]);
        const Point plane = Along(hits[i], light, toPlane);
        const Point end = Along(hits[i], light, distance);
        drawing.Line(from, section.At(plane[0], plane[1]), Ink::Grey, 1.f, true);
        drawing.Arrow(from, section.At(end[0], end[1]), i == 0 ? Ink::Red : Ink::Green);
        drawing.Dot(from, Ink::Black);
        drawing.Text({ from[0] - (i == 0 ? 34. : 40.), from[1] - (i == 0 ? 26. : 26.) },
          i == 0 ? "T: d(T, L) is less" : "T: lit");
      }
      drawing.Text({ 30., 40. }, "L: to the light");
    }));
}

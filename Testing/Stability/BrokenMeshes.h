#ifndef BrokenMeshes_h
#define BrokenMeshes_h

/**
 * @file BrokenMeshes.h
 * @brief Meshes that files and programs come with, sound and broken, each by name.
 *
 * All are in double and have texture coordinates.
 */

#include "SurfaceArrays.h"

#include "vtkFloatArray.h"

#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>

using Positions = std::vector<MesoVector>;
using Coordinates = std::vector<std::array<double, 2>>;
using Cells = std::vector<std::vector<vtkIdType>>;

/// A mesh as lists, to be broken before it is made.
struct MeshLists
{
  Positions Points;
  Coordinates TCoords;
  Cells Polygons;

  vtkSmartPointer<vtkPolyData> Make() const
  {
    return MakeMesh(this->Points, this->TCoords, this->Polygons);
  }
  vtkIdType Add(const MesoVector& point, double u, double v)
  {
    this->Points.push_back(point);
    this->TCoords.push_back({ u, v });
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }
};

/// n x n squares, cut in two, of a surface that bends in both directions, over [-1,1] x [-1,1].
inline MeshLists WavyGrid(int n = 8)
{
  MeshLists grid;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = 2. * i / n - 1.;
      const double y = 2. * j / n - 1.;
      grid.Add(
        { x, y, 0.3 * std::sin(2. * x + 0.3) * std::cos(1.5 * y) }, double(i) / n, double(j) / n);
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType p = j * (n + 1) + i;
      grid.Polygons.push_back({ p, p + 1, p + n + 2 });
      grid.Polygons.push_back({ p, p + n + 2, p + n + 1 });
    }
  }
  return grid;
}

/// `sides` triangles around one point, `height` above the rim; `waves` makes the rim bend.
inline MeshLists Fan(int sides, double height, double waves = 0.)
{
  MeshLists fan;
  fan.Add({ 0., 0., height }, 0.5, 0.5);
  for (int i = 0; i < sides; ++i)
  {
    const double a = 2. * std::acos(-1.) * i / sides;
    fan.Add({ std::cos(a), std::sin(a), waves * std::cos(2. * a) }, 0.5 + 0.5 * std::cos(a),
      0.5 + 0.5 * std::sin(a));
    fan.Polygons.push_back({ 0, 1 + i, 1 + (i + 1) % sides });
  }
  return fan;
}

/// Every triangle with points of its own.
inline MeshLists Soup(const MeshLists& mesh)
{
  MeshLists soup;
  for (const auto& polygon : mesh.Polygons)
  {
    soup.Polygons.emplace_back();
    for (const vtkIdType point : polygon)
    {
      soup.Polygons.back().push_back(
        soup.Add(mesh.Points[point], mesh.TCoords[point][0], mesh.TCoords[point][1]));
    }
  }
  return soup;
}

inline MeshLists Moved(MeshLists mesh, const std::function<MesoVector(const MesoVector&)>& move)
{
  for (MesoVector& point : mesh.Points)
  {
    point = move(point);
  }
  return mesh;
}

inline MeshLists Scaled(double factor)
{
  return Moved(WavyGrid(), [factor](const MesoVector& p) { return MesoScaled(p, factor); });
}

using Chart = std::function<std::array<double, 2>(double u, double v)>;

inline MeshLists Charted(const Chart& chart)
{
  MeshLists mesh = WavyGrid();
  for (auto& coordinate : mesh.TCoords)
  {
    coordinate = chart(coordinate[0], coordinate[1]);
  }
  return mesh;
}

inline MeshLists Cube(bool shared)
{
  MeshLists cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.Add({ double(i & 1), double(i >> 1 & 1), double(i >> 2) }, i & 1, (i >> 1 & 1) ^ (i >> 2));
  }
  cube.Polygons = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 } };
  return shared ? cube : Soup(cube);
}

/// Random triangles over random points, some of them equal, some of equal place.
inline MeshLists Noise(unsigned int seed)
{
  std::mt19937 random(seed);
  const auto number = [&](int size) { return static_cast<int>(random() % unsigned(size)); };
  MeshLists mesh;
  const int places = 5; // so few that lines, planes and equal points are frequent
  for (int i = 0; i < 60; ++i)
  {
    mesh.Add({ double(number(places)), double(number(places)), 0.5 * number(places) },
      0.25 * number(places), 0.25 * number(places));
  }
  for (int i = 0; i < 200; ++i)
  {
    mesh.Polygons.push_back({ number(60), number(60), number(60) });
  }
  return mesh;
}

/// What the arrays must say of a mesh beyond being finite.
enum class Knowledge
{
  Any,         ///< nothing more
  None,        ///< no point has a curvature or a quadric
  NoCurvature, ///< no point has a curvature; three neighbours may give a quadric
  Plane,       ///< no curvature and no quadric that is not 0
  Sides,       ///< planes at creases: the same, but quadrics only where normals are split
  Most         ///< most points have a curvature and a quadric
};

struct BrokenMesh
{
  std::string Name;
  Knowledge Known;
  std::function<vtkSmartPointer<vtkPolyData>()> Make;
};

// GoogleTest puts it into the test's name, which must not change from run to run.
inline void PrintTo(const BrokenMesh& mesh, std::ostream* stream)
{
  *stream << mesh.Name;
}

inline std::vector<BrokenMesh> BrokenMeshes()
{
  std::vector<BrokenMesh> meshes;
  const auto add = [&](const std::string& name, Knowledge known, const auto& make) {
    meshes.push_back({ name, known, [make] { return make().Make(); } });
  };
  using K = Knowledge;

  // Little or nothing.
  add("Empty", K::None, [] { return MeshLists(); });
  add("PointsAlone", K::None,
    []
    {
      MeshLists mesh = WavyGrid();
      mesh.Polygons.clear();
      return mesh;
    });
  add("OneTriangle", K::Plane,
    []
    {
      MeshLists mesh = WavyGrid(1);
      mesh.Polygons.resize(1);
      return mesh;
    });
  add("OneSquare", K::NoCurvature,
    []
    {
      MeshLists mesh = WavyGrid(1);
      mesh.Polygons = { { 0, 1, 3, 2 } };
      return mesh;
    });

  // Cells of every kind.
  add("ConcavePentagons", K::Any,
    []
    {
      MeshLists mesh;
      for (int i = 0; i < 6; ++i)
      {
        const double x = 0.4 * i;
        const vtkIdType p = mesh.Add({ x, 0., 0. }, x, 0.);
        mesh.Add({ x + 0.4, 0., 0. }, x + 0.4, 0.);
        mesh.Add({ x + 0.4, 1., 0.1 * i }, x + 0.4, 1.);
        mesh.Add({ x + 0.2, 0.3, 0.05 }, x + 0.2, 0.3);
        mesh.Add({ x, 1., 0.1 * i }, x, 1.);
        mesh.Polygons.push_back({ p, p + 1, p + 2, p + 3, p + 4 });
      }
      return mesh;
    });
  meshes.push_back({ "Strips", K::Most,
    []
    {
      const auto mesh = WavyGrid().Make();
      vtkNew<vtkCellArray> strips;
      for (vtkIdType j = 0; j < 8; ++j)
      {
        strips->InsertNextCell(18);
        for (vtkIdType i = 0; i <= 8; ++i)
        {
          strips->InsertCellPoint(9 * (j + 1) + i);
          strips->InsertCellPoint(9 * j + i);
        }
      }
      mesh->SetPolys(nullptr);
      mesh->SetStrips(strips);
      return mesh;
    } });
  meshes.push_back({ "VerticesAndLinesBeside", K::Most,
    []
    {
      const auto mesh = WavyGrid().Make();
      vtkNew<vtkCellArray> vertices;
      vertices->InsertNextCell({ 0 });
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 1, 2 });
      mesh->SetVerts(vertices);
      mesh->SetLines(lines);
      return mesh;
    } });

  // Triangles that are none, or there twice.
  add("DegenerateTriangles", K::Most,
    []
    {
      MeshLists mesh = WavyGrid();
      for (vtkIdType i = 0; i < 40; ++i)
      {
        mesh.Polygons.push_back({ i, i, i + 1 });
        mesh.Polygons.push_back({ i, i, i });
      }
      mesh.Polygons.push_back({ 0, 0 });
      mesh.Polygons.push_back({ 5 });
      return mesh;
    });
  add("DuplicateTriangles", K::Any,
    []
    {
      MeshLists mesh = WavyGrid();
      const Cells once = mesh.Polygons;
      mesh.Polygons.insert(mesh.Polygons.end(), once.begin(), once.end());
      return mesh;
    });
  add("TrianglesFromBothSides", K::Any,
    []
    {
      MeshLists mesh = WavyGrid();
      for (const auto& polygon : Cells(mesh.Polygons))
      {
        mesh.Polygons.push_back({ polygon[2], polygon[1], polygon[0] });
      }
      return mesh;
    });
  add("FlippedWinding", K::Any,
    []
    {
      MeshLists mesh = WavyGrid();
      for (std::size_t i = 0; i < mesh.Polygons.size(); i += 3)
      {
        std::swap(mesh.Polygons[i][0], mesh.Polygons[i][1]);
      }
      return mesh;
    });

  // Points.
  add("IsolatedPoints", K::Most,
    []
    {
      MeshLists mesh = WavyGrid();
      mesh.Add({ 5., 5., 5. }, 0.5, 0.5);
      mesh.Add({ 0., 0., 0. }, 0., 0.);
      return mesh;
    });
  add("TriangleSoup", K::Most, [] { return Soup(WavyGrid()); });
  add("PointsInOnePlace", K::None,
    [] {
      return Moved(WavyGrid(), [](const MesoVector&) { return MesoVector{ 1., 2., 3. }; });
    });
  add("PointsOnOneLine", K::None,
    []
    {
      return Moved(WavyGrid(),
        [](const MesoVector& p) {
          return MesoVector{ p[0] + 0.3 * p[1], 2. * p[0] + 0.6 * p[1], 0. };
        });
    });

  // Edges and vertices that are no manifold.
  add("SheetsAtOneEdge", K::Any,
    []
    {
      MeshLists mesh;
      for (int sheet = 0; sheet < 5; ++sheet)
      {
        const double a = 1.2 * sheet;
        const vtkIdType first = static_cast<vtkIdType>(mesh.Points.size());
        const MeshLists grid = WavyGrid(4);
        for (std::size_t i = 0; i < grid.Points.size(); ++i)
        {
          const MesoVector& p = grid.Points[i];
          const double r = p[0] + 1.; // 0 along the common edge
          mesh.Add(
            { r * std::cos(a), r * std::sin(a), p[1] }, grid.TCoords[i][0], grid.TCoords[i][1]);
        }
        for (const auto& polygon : grid.Polygons)
        {
          mesh.Polygons.push_back({ first + polygon[0], first + polygon[1], first + polygon[2] });
        }
      }
      return mesh;
    });
  add("ConesAtOneTip", K::Any,
    []
    {
      MeshLists mesh = Fan(12, 0.);
      const MeshLists other = Fan(12, 0.);
      for (std::size_t i = 1; i < other.Points.size(); ++i)
      {
        mesh.Points[i][2] = -1.;
        mesh.Add({ other.Points[i][0], other.Points[i][1], 1. }, 0.1, 0.2 + 0.01 * double(i));
      }
      for (const auto& polygon : other.Polygons)
      {
        mesh.Polygons.push_back({ 0, polygon[2] + 12, polygon[1] + 12 });
      }
      return mesh;
    });
  add("OneRowOfSquares", K::Any,
    []
    {
      MeshLists mesh = WavyGrid();
      mesh.Polygons.resize(16);
      return mesh;
    });

  // Charts.
  add("NoTextureArea", K::Most,
    [] {
      return Charted([](double, double) { return std::array<double, 2>{ 0.3, 0.7 }; });
    });
  add("TextureOnALine", K::Most,
    [] {
      return Charted([](double u, double v) { return std::array<double, 2>{ u + v, u + v }; });
    });
  add("MirroredHalf", K::Most,
    []
    {
      return Charted(
        [](double u, double v) {
          return std::array<double, 2>{ std::abs(u - 0.5), v };
        });
    });
  add("OverlappingCharts", K::Most,
    []
    {
      return Charted(
        [](double u, double v) {
          return std::array<double, 2>{ std::fmod(4. * u, 1.), v * v };
        });
    });
  add("StretchedChart", K::Most,
    [] {
      return Charted([](double u, double v) { return std::array<double, 2>{ 1e6 * u, 1e-6 * v }; });
    });
  add("FarChart", K::Most,
    [] {
      return Charted([](double u, double v) { return std::array<double, 2>{ u + 1e6, v - 1e6 }; });
    });
  add("HugeChart", K::Most,
    []
    {
      return Charted(
        [](double u, double v) {
          return std::array<double, 2>{ 1e30 * u, 1e30 * v };
        });
    });
  add("SeamEverywhere", K::Most,
    []
    {
      MeshLists mesh = Soup(WavyGrid());
      for (std::size_t i = 0; i < mesh.TCoords.size(); ++i)
      {
        mesh.TCoords[i][0] += 0.37 * static_cast<double>(i / 3 % 7); // a chart a triangle
      }
      return mesh;
    });

  // Valences.
  add("Tetrahedron", K::NoCurvature,
    []
    {
      MeshLists mesh = Fan(3, 1.);
      mesh.Polygons.push_back({ 3, 2, 1 });
      return mesh;
    });
  add("ValenceThree", K::Any,
    []
    {
      MeshLists mesh = WavyGrid();
      for (auto& polygon : Cells(mesh.Polygons))
      {
        MesoVector middle = { 0., 0., 0. };
        for (const vtkIdType point : polygon)
        {
          middle = MesoSum(middle, MesoScaled(mesh.Points[point], 1. / 3.));
        }
        const vtkIdType p = mesh.Add(middle, middle[0], middle[1]);
        mesh.Polygons.push_back({ polygon[0], polygon[1], p });
        mesh.Polygons.push_back({ polygon[1], polygon[2], p });
        mesh.Polygons.push_back({ polygon[2], polygon[0], p });
      }
      mesh.Polygons.erase(mesh.Polygons.begin(), mesh.Polygons.begin() + 128);
      return mesh;
    });
  add("ValenceHundred", K::Any, [] { return Fan(100, 0.3, 0.1); });
  add("ValenceHundredFlat", K::Plane, [] { return Fan(100, 0.); });

  // Creases.
  add("Cube", K::Sides, [] { return Cube(true); });
  add("CubeOfSeparateSides", K::Sides, [] { return Cube(false); });
  add("NeedleFan", K::Any,
    []
    {
      return Moved(Fan(16, 0.2, 0.1),
        [](const MesoVector& p) {
          return MesoVector{ p[0], 1e-7 * p[1], p[2] };
        });
    });

  // Sizes.
  for (const double scale : { 1e-6, 1e6, 1e-18, 1e18 })
  {
    add("Scale" +
        std::to_string(std::lround(std::log10(scale)))
          .replace(0, scale < 1. ? 1 : 0, scale < 1. ? "Minus" : ""),
      K::Most, [scale] { return Scaled(scale); });
  }
  // Curvatures of 1e40: doubles hold them, floats do not.
  add("CurvaturesBeyondFloat", K::Any, [] { return Scaled(1e-40); });
  add("TooLargeToSquare", K::Any, [] { return Scaled(1e200); });
  add("TooSmallToSquare", K::Any, [] { return Scaled(1e-200); });
  add("Denormal", K::Any, [] { return Scaled(1e-312); });
  add("FarFromTheOrigin", K::Most,
    [] {
      return Moved(WavyGrid(), [](const MesoVector& p) { return MesoSum(p, { 1e6, -1e6, 1e6 }); });
    });
  add("SizesSideBySide", K::Any,
    []
    {
      return Moved(WavyGrid(),
        [](const MesoVector& p) {
          return MesoVector{ std::copysign(std::pow(10., 8. * std::abs(p[0])) - 1., p[0]), p[1],
            p[2] };
        });
    });
  for (unsigned int seed = 1; seed <= 8; ++seed)
  {
    add("Noise" + std::to_string(seed), K::Any, [seed] { return Noise(seed); });
  }
  return meshes;
}

/// The same mesh with positions and texture coordinates in float.
inline vtkSmartPointer<vtkPolyData> InFloat(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("uv");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh->GetPoint(i));
    coordinates->SetTuple(i, mesh->GetPointData()->GetTCoords()->GetTuple(i));
  }
  copy->SetPoints(points);
  copy->GetPointData()->SetTCoords(coordinates);
  return copy;
}

#endif

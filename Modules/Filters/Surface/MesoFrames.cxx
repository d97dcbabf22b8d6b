#include "MesoFrames.h"

#include "MesoFirstEqual.h"

#include <algorithm>

namespace
{
// Means of directions that are shorter, relative to the mean of their lengths, say nothing.
constexpr double ShortestMean = 1. / 16.;
// Derivatives that differ by more, relative to their length, are those of different charts.
constexpr double LargestSeamDifference = 0.5;
// Sine of the angle between the axes under which a float's inverse of the frame is noise.
constexpr double LeastSine = 1e-6;

/// A triangle's dp/du and dp/dv. Determinant is 0 where it has none.
struct Derivatives
{
  MesoVector U = { 0., 0., 0. };
  MesoVector V = { 0., 0., 0. };
  double Determinant = 0.;
};

Derivatives MakeDerivatives(const MesoFramesInput& input, std::int64_t triangle)
{
  const auto& corners = input.Mesh.Triangles[triangle];
  const auto& p = input.Mesh.Positions;
  const auto& t = input.TextureCoordinates;
  const MesoVector edge1 = MesoDifference(p[corners[1]], p[corners[0]]);
  const MesoVector edge2 = MesoDifference(p[corners[2]], p[corners[0]]);
  const double u1 = t[corners[1]][0] - t[corners[0]][0];
  const double v1 = t[corners[1]][1] - t[corners[0]][1];
  const double u2 = t[corners[2]][0] - t[corners[0]][0];
  const double v2 = t[corners[2]][1] - t[corners[0]][1];
  const double determinant = u1 * v2 - u2 * v1;
  // u and v are held against rounding apart: a chart may be a thousand times longer than wide.
  double largestU = 0.;
  double largestV = 0.;
  for (std::int64_t corner : corners)
  {
    largestU = std::max(largestU, std::abs(t[corner][0]));
    largestV = std::max(largestV, std::abs(t[corner][1]));
  }
  const double noise = input.TextureRounding *
    (largestU * (std::abs(v1) + std::abs(v2)) + largestV * (std::abs(u1) + std::abs(u2)));
  Derivatives result;
  if (std::abs(determinant) > noise && std::isfinite(determinant))
  {
    result.Determinant = determinant;
    result.U =
      MesoScaled(MesoDifference(MesoScaled(edge1, v2), MesoScaled(edge2, v1)), 1. / determinant);
    result.V =
      MesoScaled(MesoDifference(MesoScaled(edge2, u1), MesoScaled(edge1, u2)), 1. / determinant);
  }
  return result;
}

MesoVector Projected(const MesoVector& vector, const MesoVector& normal)
{
  return MesoDifference(vector, MesoScaled(normal, MesoDot(vector, normal)));
}

bool AreNear(const MesoVector& a, const MesoVector& b)
{
  return MesoLength(MesoDifference(a, b)) <
    LargestSeamDifference * std::max(MesoLength(a), MesoLength(b));
}

/// Unit vector at right angles to the unit vector `normal`.
MesoVector AnyTangent(const MesoVector& normal)
{
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    axis = std::abs(normal[k]) < std::abs(normal[axis]) ? k : axis;
  }
  MesoVector direction = { 0., 0., 0. };
  direction[axis] = 1.;
  const MesoVector tangent = Projected(direction, normal);
  return MesoScaled(tangent, 1. / MesoLength(tangent));
}

/// What the triangles of one frame add up to.
struct FrameSum
{
  MesoVector U = { 0., 0., 0. };
  MesoVector V = { 0., 0., 0. };
  double LengthU = 0.; ///< of the vectors before they were projected and added
  double LengthV = 0.;
  double Angle = 0.;
};

class FrameMaker
{
public:
  explicit FrameMaker(const MesoFramesInput& input)
    : Input(input)
    , Points(static_cast<std::int64_t>(input.Mesh.Positions.size()))
    , Corners(input.Mesh.NumberOfCorners())
    , Measures(MesoMeasureTriangles(input.Mesh))
    , Charts(input.Mesh.NumberOfCorners())
  {
  }

  MesoFrames Make()
  {
    this->ChooseNormals();
    this->ChooseHands();
    this->JoinCharts();
    this->JoinCornersWithoutFrame();
    this->SplitPoints();
    this->AddUp();
    this->MakeAxes();
    return std::move(this->Frames);
  }

private:
  std::int64_t PointOf(std::int64_t c) const { return this->Input.Mesh.PointOf(c); }

  bool AllNormalsGiven() const
  {
    return !this->Input.Normals.empty() &&
      std::all_of(this->Input.Normals.begin(), this->Input.Normals.end(),
        [](const MesoVector& normal) { return MesoLength(normal) > 0.; });
  }

  /// Given normals are groups of their own, a point each, after those that were made.
  void ChooseNormals()
  {
    if (this->AllNormalsGiven())
    {
      this->Normals.Group.resize(this->Corners);
    }
    else
    {
      this->Normals = MesoMakeCornerNormals(
        this->Input.Mesh, this->Measures, this->Input.SplitNormals, this->Input.FeatureAngle);
    }
    if (this->Input.Normals.empty())
    {
      return;
    }
    const auto made = static_cast<std::int64_t>(this->Normals.Normals.size());
    for (const MesoVector& normal : this->Input.Normals)
    {
      const double length = MesoLength(normal);
      this->Normals.Normals.push_back(length > 0. ? MesoScaled(normal, 1. / length) : normal);
    }
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      if (MesoLength(this->Input.Normals[this->PointOf(c)]) > 0.)
      {
        this->Normals.Group[c] = made + this->PointOf(c);
      }
    }
  }

  const MesoVector& NormalOf(std::int64_t c) const
  {
    return this->Normals.Normals[this->Normals.Group[c]];
  }

  /// Hand is 1 or -1 where a corner contributes to a frame, right-handed or left-handed, else 0.
  void ChooseHands()
  {
    this->Hand.assign(this->Corners, 0);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      const MesoTriangleMeasure& measure = this->Measures[c / 3];
      if (measure.Area > 0.)
      {
        const double hand = MakeDerivatives(this->Input, c / 3).Determinant *
          MesoDot(measure.Normal, this->NormalOf(c));
        this->Hand[c] = hand > 0. ? 1 : hand < 0. ? -1 : 0;
      }
    }
  }

  void JoinCharts()
  {
    const MesoTriangleMesh& mesh = this->Input.Mesh;
    std::vector<bool> used(mesh.Triangles.size());
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      used[c / 3] = used[c / 3] || this->Hand[c] != 0;
    }
    const std::vector<std::int64_t> partner = MesoPairHalfEdges(mesh, used);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      if (partner[c] < c) // none, or seen from its other side
      {
        continue;
      }
      const std::int64_t next = MesoTriangleMesh::Next(c);
      std::int64_t other = partner[c];
      std::int64_t otherNext = MesoTriangleMesh::Next(other);
      if (mesh.VertexOf(c) != mesh.VertexOf(other))
      {
        std::swap(other, otherNext);
      }
      if (this->ChartRunsOn({ c, next }, { other, otherNext }))
      {
        this->JoinIfAlike(c, other);
        this->JoinIfAlike(next, otherNext);
      }
    }
  }

  /// Whether the texture coordinates continue from one triangle's edge to the other's.
  bool ChartRunsOn(
    const std::array<std::int64_t, 2>& here, const std::array<std::int64_t, 2>& there) const
  {
    bool equal = true;
    for (std::size_t k = 0; k < 2; ++k)
    {
      double shift[2];
      double largest = 0.;
      for (std::size_t end = 0; end < 2; ++end)
      {
        const double a = this->Input.TextureCoordinates[this->PointOf(here[end])][k];
        const double b = this->Input.TextureCoordinates[this->PointOf(there[end])][k];
        shift[end] = b - a;
        largest = std::max({ largest, std::abs(a), std::abs(b) });
        equal = equal && a == b;
      }
      if (std::abs(shift[1] - shift[0]) > 4. * this->Input.TextureRounding * largest)
      {
        return false;
      }
    }
    if (equal)
    {
      return true;
    }
    const Derivatives a = MakeDerivatives(this->Input, here[0] / 3);
    const Derivatives b = MakeDerivatives(this->Input, there[0] / 3);
    return AreNear(a.U, b.U) && AreNear(a.V, b.V);
  }

  void JoinIfAlike(std::int64_t a, std::int64_t b)
  {
    if (this->Hand[a] != 0 && this->Hand[a] == this->Hand[b] &&
      this->NormalOf(a) == this->NormalOf(b))
    {
      this->Charts.Join(a, b);
    }
  }

  /// Corners that do not contribute join the first at their point and with their normal that does,
  /// so as to make no points.
  void JoinCornersWithoutFrame()
  {
    if (std::find(this->Hand.begin(), this->Hand.end(), 0) == this->Hand.end())
    {
      return;
    }
    std::vector<std::array<double, 2>> keys(this->Corners);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      keys[c] = { static_cast<double>(this->PointOf(c)),
        static_cast<double>(this->Normals.Group[c]) };
    }
    const std::vector<std::int64_t> first = MesoFirstEqual(keys);
    std::vector<std::int64_t> leader(this->Corners, -1);
    for (std::int64_t c = this->Corners - 1; c >= 0; --c)
    {
      if (this->Hand[c] != 0)
      {
        leader[first[c]] = c;
      }
    }
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      if (this->Hand[c] == 0)
      {
        this->Charts.Join(c, leader[first[c]] < 0 ? first[c] : leader[first[c]]);
      }
    }
  }

  /// Makes a point of each combination of point and chart. The first keeps the point's number.
  void SplitPoints()
  {
    std::vector<std::array<double, 2>> keys(this->Corners);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      keys[c] = { static_cast<double>(this->PointOf(c)),
        static_cast<double>(this->Charts.Find(c)) };
    }
    const std::vector<std::int64_t> first = MesoFirstEqual(keys);
    this->StartPoints();
    std::vector<bool> taken(this->Points, false);
    std::vector<std::int64_t> pointOfFirst(this->Corners, -1);
    std::vector<std::int64_t> numberOfChart(this->Corners, -1);
    std::int64_t charts = 0;
    this->Frames.Triangles.resize(this->Input.Mesh.Triangles.size());
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      std::int64_t& point = pointOfFirst[first[c]];
      if (first[c] == c)
      {
        point = this->PointOf(c);
        if (taken[point])
        {
          this->Frames.Source.push_back(point);
          this->Frames.Normals.emplace_back();
          this->SumOfPoint.push_back(-1);
          point = static_cast<std::int64_t>(this->Frames.Source.size()) - 1;
        }
        else
        {
          taken[point] = true;
        }
        std::int64_t& number = numberOfChart[this->Charts.Find(c)];
        number = number < 0 ? charts++ : number;
        this->Frames.Normals[point] = this->NormalOf(c);
        this->SumOfPoint[point] = number;
      }
      this->Frames.Triangles[c / 3][c % 3] = point;
    }
    this->Sums.resize(charts);
  }

  /// The points of the input, as they are where no triangle uses them.
  void StartPoints()
  {
    this->Frames.Source.resize(this->Points);
    this->Frames.Normals.assign(this->Points, { 0., 0., 1. });
    this->SumOfPoint.assign(this->Points, -1);
    for (std::int64_t point = 0; point < this->Points; ++point)
    {
      this->Frames.Source[point] = point;
      if (!this->Input.Normals.empty())
      {
        const MesoVector& normal = this->Input.Normals[point];
        const double length = MesoLength(normal);
        if (length > 0.)
        {
          this->Frames.Normals[point] = MesoScaled(normal, 1. / length);
        }
      }
    }
  }

  void AddUp()
  {
    double area = 0.;
    double textureArea = 0.;
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      if (this->Hand[c] == 0)
      {
        continue;
      }
      const Derivatives derivatives = MakeDerivatives(this->Input, c / 3);
      const std::int64_t point = this->Frames.Triangles[c / 3][c % 3];
      this->Add(derivatives, this->Measures[c / 3].Angles[c % 3], this->Frames.Normals[point],
        this->Sums[this->SumOfPoint[point]]);
      area += this->Measures[c / 3].Area;
      textureArea += 0.5 * std::abs(derivatives.Determinant);
    }
    this->MeanScale = textureArea > 0. && area > 0. ? std::sqrt(area / textureArea) : 1.;
  }

  static void Add(
    const Derivatives& derivatives, double angle, const MesoVector& normal, FrameSum& sum)
  {
    sum.U = MesoSum(sum.U, MesoScaled(Projected(derivatives.U, normal), angle));
    sum.V = MesoSum(sum.V, MesoScaled(Projected(derivatives.V, normal), angle));
    sum.LengthU += angle * MesoLength(derivatives.U);
    sum.LengthV += angle * MesoLength(derivatives.V);
    sum.Angle += angle;
  }

  void MakeAxes()
  {
    const std::size_t size = this->Frames.Source.size();
    this->Frames.Tangents.resize(size);
    this->Frames.Bitangents.resize(size);
    this->Frames.Scales.resize(size);
    this->Frames.Valid.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::int64_t number = this->SumOfPoint[i];
      const FrameSum sum = number < 0 ? FrameSum() : this->Sums[number];
      const MesoVector& normal = this->Frames.Normals[i];
      const double u = MesoLength(sum.U);
      const double v = MesoLength(sum.V);
      bool valid = u > ShortestMean * sum.LengthU && v > ShortestMean * sum.LengthV &&
        std::isfinite(u) && std::isfinite(v);
      if (valid)
      {
        this->Frames.Tangents[i] = MesoScaled(sum.U, 1. / u);
        this->Frames.Bitangents[i] = MesoScaled(sum.V, 1. / v);
        this->Frames.Scales[i] = { u / sum.Angle, v / sum.Angle };
        const double sine =
          MesoDot(MesoCross(this->Frames.Tangents[i], this->Frames.Bitangents[i]), normal);
        valid = std::abs(sine) > LeastSine;
      }
      if (!valid)
      {
        this->Frames.Tangents[i] = AnyTangent(normal);
        this->Frames.Bitangents[i] = MesoCross(normal, this->Frames.Tangents[i]);
        this->Frames.Scales[i] = { this->MeanScale, this->MeanScale };
      }
      this->Frames.Valid[i] = valid;
    }
  }

  const MesoFramesInput& Input;
  const std::int64_t Points;
  const std::int64_t Corners;
  const std::vector<MesoTriangleMeasure> Measures;
  MesoCornerNormals Normals;
  MesoCornerSets Charts;
  std::vector<signed char> Hand;        ///< by corner
  std::vector<std::int64_t> SumOfPoint; ///< by point of the result, into Sums; -1 in no triangle
  std::vector<FrameSum> Sums;
  double MeanScale = 1.;
  MesoFrames Frames;
};
}

MesoFrames MesoMakeFrames(const MesoFramesInput& input)
{
  return FrameMaker(input).Make();
}

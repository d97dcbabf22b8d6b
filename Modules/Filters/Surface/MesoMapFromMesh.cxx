#include "MesoMapFromMesh.h"

namespace
{
using Corners = std::array<std::int64_t, 3>;

MesoVector Mixed(const std::vector<MesoVector>& values, const Corners& corners,
  const std::array<double, 3>& weights)
{
  MesoVector sum = { 0., 0., 0. };
  for (int k = 0; k < 3; ++k)
  {
    sum = MesoSum(sum, MesoScaled(values[corners[k]], weights[k]));
  }
  return sum;
}

/// Unit, or the fallback where there is no direction.
MesoVector Directed(const MesoVector& v, const MesoVector& fallback)
{
  const double length = MesoLength(v);
  return length > 0. ? MesoScaled(v, 1. / length) : fallback;
}

MesoVector FacetNormal(const std::vector<MesoVector>& positions, const Corners& corners)
{
  const MesoVector& a = positions[corners[0]];
  return MesoCross(
    MesoDifference(positions[corners[1]], a), MesoDifference(positions[corners[2]], a));
}

/// At right angles to a unit normal.
MesoVector Flat(const MesoVector& v, const MesoVector& normal)
{
  return MesoDifference(v, MesoScaled(normal, MesoDot(v, normal)));
}

/// Coordinates of a vector in three directions, of which the third is at right angles to the others.
MesoVector InFrame(
  const MesoVector& v, const MesoVector& t, const MesoVector& b, const MesoVector& n)
{
  const double cosine = MesoDot(t, b);
  const double sine2 = 1. - cosine * cosine;
  const double alongT = MesoDot(v, t);
  const double alongB = MesoDot(v, b);
  if (!(sine2 > 1e-12)) // no frame: the directions are one
  {
    return { 0., 0., 1. };
  }
  return { (alongT - cosine * alongB) / sine2, (alongB - cosine * alongT) / sine2, MesoDot(v, n) };
}
}

MesoMapFromMesh::MesoMapFromMesh(const MesoFitInput& base,
  const std::vector<MesoTexturePoint>& baseCoordinates, const MesoFitInput& detail,
  const std::vector<MesoTexturePoint>& detailCoordinates, const Options& options)
  : Base(base)
  , BaseCoordinates(baseCoordinates)
  , Detail(detail)
  , Chosen(options)
  , Texels(MesoCoverTexels(baseCoordinates, base.Mesh.Triangles, options.Width, options.Height))
{
  if (options.ByTexture)
  {
    this->DetailTexels =
      MesoCoverTexels(detailCoordinates, detail.Mesh.Triangles, options.Width, options.Height);
  }
  else
  {
    this->Projection = std::make_unique<MesoDetailProjection>(detail.Mesh);
  }
}

MesoMapFromMesh::BasePoint MesoMapFromMesh::BaseAt(std::size_t texel) const
{
  const Corners& corners = this->Base.Mesh.Triangles[this->Texels.Triangle[texel]];
  const MesoTexturePoint& a = this->BaseCoordinates[corners[0]];
  const MesoTexturePoint& b = this->BaseCoordinates[corners[1]];
  const MesoTexturePoint& c = this->BaseCoordinates[corners[2]];
  const auto weights = this->Texels.WeightsOf(texel);
  BasePoint point;
  point.Position = Mixed(this->Base.Mesh.Positions, corners, weights);
  const MesoVector facet =
    Directed(FacetNormal(this->Base.Mesh.Positions, corners), { 0., 0., 1. });
  point.Normal = this->Chosen.GeometricNormals
    ? facet
    : Directed(Mixed(this->Base.Normals, corners, weights), facet);
  // dp/du and dp/dv of the triangle, up to a positive factor each.
  const MesoVector alongB =
    MesoDifference(this->Base.Mesh.Positions[corners[1]], this->Base.Mesh.Positions[corners[0]]);
  const MesoVector alongC =
    MesoDifference(this->Base.Mesh.Positions[corners[2]], this->Base.Mesh.Positions[corners[0]]);
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const double sign = area < 0. ? -1. : 1.;
  const MesoVector alongU = MesoScaled(
    MesoDifference(MesoScaled(alongB, c[1] - a[1]), MesoScaled(alongC, b[1] - a[1])), sign);
  const MesoVector alongV = MesoScaled(
    MesoDifference(MesoScaled(alongC, b[0] - a[0]), MesoScaled(alongB, c[0] - a[0])), sign);
  point.Tangent = Directed(Flat(alongU, point.Normal), { 1., 0., 0. });
  point.Bitangent = Directed(Flat(alongV, point.Normal), { 1., 0., 0. });
  return point;
}

MesoVector MesoMapFromMesh::DetailNormal(
  std::int64_t triangle, const std::array<double, 3>& weights) const
{
  const Corners& corners = this->Detail.Mesh.Triangles[triangle];
  return Directed(Mixed(this->Detail.Normals, corners, weights),
    Directed(FacetNormal(this->Detail.Mesh.Positions, corners), { 0., 0., 1. }));
}

MesoMapFromMesh::Texel MesoMapFromMesh::Look(std::size_t number) const
{
  Texel texel;
  if (this->Texels.Triangle[number] < 0)
  {
    return texel;
  }
  const BasePoint base = this->BaseAt(number);
  texel.Position = base.Position;
  texel.Found = Void;
  if (this->Chosen.ByTexture)
  {
    texel.Triangle = this->DetailTexels.Triangle[number];
    if (texel.Triangle < 0)
    {
      return texel;
    }
    const Corners& corners = this->Detail.Mesh.Triangles[texel.Triangle];
    texel.Weights = this->DetailTexels.WeightsOf(number);
    const MesoVector way =
      MesoDifference(Mixed(this->Detail.Mesh.Positions, corners, texel.Weights), base.Position);
    texel.Displacement = MesoDot(way, base.Normal);
    texel.Drift = MesoLength(Flat(way, base.Normal));
    texel.Found = Met;
  }
  else
  {
    const auto hit = this->Projection->Find(base.Position, base.Normal, this->Chosen.Reach);
    if (!hit)
    {
      return texel;
    }
    texel.Displacement = hit->Distance;
    texel.Triangle = hit->Triangle;
    texel.Weights = hit->Weights;
    texel.Found = hit->Crossings > 1 ? Fold : Met;
  }
  texel.NormalObject = this->DetailNormal(texel.Triangle, texel.Weights);
  texel.Normal = InFrame(texel.NormalObject, base.Tangent, base.Bitangent, base.Normal);
  return texel;
}

bool MesoMapFromMesh::Jumps(const Texel& a, const Texel& b) const
{
  if (a.Triangle < 0 || b.Triangle < 0)
  {
    return false;
  }
  const double step = MesoLength(MesoDifference(a.Position, b.Position));
  return std::abs(a.Displacement - b.Displacement) > this->Chosen.SlopeLimit * step;
}

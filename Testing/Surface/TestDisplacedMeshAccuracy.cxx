// vtkMesoDisplacedMesh against the surface that is true: closed forms, the surface evaluated a second
// time at random places, and the normal of a smooth surface with all its terms.

#include "DicedMeshes.h"

#include "MesoShape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace
{
const double Pi = std::acos(-1.);

struct Relief
{
  vtkSmartPointer<vtkImageData> Map;
  double Scale;
  std::array<double, 2> Tiles;
  double Reference = 1.;
};

vtkSmartPointer<vtkPolyData> Dice(vtkPolyData* mesh, const Relief& relief, double facets)
{
  vtkNew<vtkMesoDisplacedMesh> filter;
  filter->SetInputData(mesh);
  filter->SetHeightMapData(relief.Map);
  filter->SetScale(relief.Scale);
  filter->SetReference(relief.Reference);
  filter->SetTiles(relief.Tiles[0], relief.Tiles[1]);
  filter->SetFacetsPerTexel(facets);
  filter->Update();
  return filter->GetOutput();
}

/// q over a base whose charts cover the texture once, so that (u, v) says which triangle is meant.
class Truth
{
public:
  Truth(vtkPolyData* base, const Relief& relief)
    : Base(base)
    , Triangles(TrianglesOf(base))
    , Texture(TextureOf(relief.Map, MesoWrap::Repeat))
    , Given(relief)
  {
  }

  MesoVector At(double u, double v) const
  {
    for (const auto& t : this->Triangles)
    {
      std::array<double, 2> uv[3];
      for (int k = 0; k < 3; ++k)
      {
        const MesoVector tuple = TupleOf(this->Base, "TextureCoordinates", t[k]);
        uv[k] = { tuple[0], tuple[1] };
      }
      const auto area = [](const auto& a, const auto& b, const auto& c)
      { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
      const std::array<double, 2> at = { u, v };
      const double whole = area(uv[0], uv[1], uv[2]);
      const double w[3] = { area(at, uv[1], uv[2]) / whole, area(uv[0], at, uv[2]) / whole,
        area(uv[0], uv[1], at) / whole };
      if (std::min({ w[0], w[1], w[2] }) < -1e-12)
      {
        continue;
      }
      MesoVector p = { 0., 0., 0. };
      MesoVector n = { 0., 0., 0. };
      for (int k = 0; k < 3; ++k)
      {
        p = MesoSum(p, MesoScaled(PositionOf(this->Base, t[k]), w[k]));
        n = MesoSum(n, MesoScaled(TupleOf(this->Base, "Normals", t[k]), w[k]));
      }
      const double h =
        this->Texture.sampleHeight({ u * this->Given.Tiles[0], v * this->Given.Tiles[1] });
      const double above = (h - this->Given.Reference) * this->Given.Scale;
      return MesoSum(p, MesoScaled(n, above / MesoLength(n)));
    }
    ADD_FAILURE() << "no triangle at " << u << " " << v;
    return { 0., 0., 0. };
  }

private:
  vtkPolyData* Base;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  MesoHeightTexture<double> Texture;
  Relief Given;
};

/// Mean distances to the truth at random places: of all, and of those in facets that no line of
/// texel centres crosses.
struct Distances
{
  double All = 0.;
  double Smooth = 0.;
  int NumberSmooth = 0;

  Distances(vtkPolyData* diced, const Truth& truth, const Relief& relief, int samples)
  {
    const auto triangles = TrianglesOf(diced);
    std::mt19937 random(3);
    const auto number = [&]() { return static_cast<double>(random()) / 4294967296.; };
    for (int sample = 0; sample < samples; ++sample)
    {
      const auto& t = triangles[random() % triangles.size()];
      double a = number();
      double b = number();
      if (a + b > 1.)
      {
        a = 1. - a;
        b = 1. - b;
      }
      const double w[3] = { 1. - a - b, a, b };
      MesoVector position = { 0., 0., 0. };
      MesoVector uv = { 0., 0., 0. };
      std::array<double, 4> span = { 1e9, -1e9, 1e9, -1e9 }; // of the facet, in texels
      for (int k = 0; k < 3; ++k)
      {
        position = MesoSum(position, MesoScaled(PositionOf(diced, t[k]), w[k]));
        const MesoVector corner = TupleOf(diced, "TextureCoordinates", t[k]);
        uv = MesoSum(uv, MesoScaled(corner, w[k]));
        for (int axis = 0; axis < 2; ++axis)
        {
          const double texel =
            corner[axis] * relief.Tiles[axis] * relief.Map->GetDimensions()[axis] - 0.5;
          span[2 * axis] = std::min(span[2 * axis], texel);
          span[2 * axis + 1] = std::max(span[2 * axis + 1], texel);
        }
      }
      const double distance = DistanceOf(position, truth.At(uv[0], uv[1]));
      const bool smooth = std::floor(span[0] + 1e-9) >= std::floor(span[1] - 1e-9) &&
        std::floor(span[2] + 1e-9) >= std::floor(span[3] - 1e-9);
      this->All += distance / samples;
      this->Smooth += smooth ? distance : 0.;
      this->NumberSmooth += smooth ? 1 : 0;
    }
    this->Smooth /= std::max(1, this->NumberSmooth);
  }
};

double DegreesBetween(const MesoVector& a, const MesoVector& b)
{
  return std::atan2(MesoLength(MesoCross(a, b)), MesoDot(a, b)) * 180. / Pi;
}
}

TEST(DisplacedMeshAccuracy, HeightZeroIsTheBaseMovedByD)
{
  for (const char* shape : { "torus", "sphere", "cylinder", "plane" })
  {
    const auto base = ShapeMesh(shape, {});
    const auto diced = Dice(base, { ConstantMap(0.), 0.25, { 1., 1. } }, 0.1);
    ASSERT_EQ(diced->GetNumberOfPolys(), base->GetNumberOfPolys()) << shape;
    for (vtkIdType i = 0; i < base->GetNumberOfPoints(); ++i)
    {
      const MesoVector n = TupleOf(base, "Normals", i);
      const MesoVector q = MesoSum(PositionOf(base, i), MesoScaled(n, -0.25));
      EXPECT_LT(DistanceOf(PositionOf(diced, i), q), 1e-14) << shape;
      EXPECT_EQ(TupleOf(diced, "MesoRelief", i)[0], 1.);
    }
  }
}

TEST(DisplacedMeshAccuracy, HeightOneIsTheBaseWithItsNormals)
{
  const auto base = ShapeMesh("torus", {});
  const auto diced = Dice(base, { ConstantMap(1.), 0.25, { 1., 1. } }, 0.1);
  ASSERT_EQ(diced->GetNumberOfPoints(), base->GetNumberOfPoints());
  for (vtkIdType i = 0; i < base->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(PositionOf(diced, i), PositionOf(base, i));
    EXPECT_LT(DistanceOf(TupleOf(diced, "Normals", i), TupleOf(base, "Normals", i)), 1e-12);
    EXPECT_EQ(TupleOf(diced, "MesoRelief", i)[0], 0.);
  }
}

TEST(DisplacedMeshAccuracy, PlaneHasTheClosedForm)
{
  const Relief relief = { PatternMap("smooth", 32), 0.2, { 2., 1. } };
  const auto texture = TextureOf(relief.Map, MesoWrap::Repeat);
  const auto diced = Dice(ShapeMesh("plane", { { "size", { 3., 2. } } }), relief, 1.7);
  EXPECT_GT(diced->GetNumberOfPoints(), 1000);
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    const MesoVector uv = TupleOf(diced, "TextureCoordinates", i);
    const MesoVector p = PositionOf(diced, i);
    const double s = 2. * uv[0];
    const double t = uv[1];
    const double h = texture.sampleHeight({ s, t });
    EXPECT_NEAR(p[0], 3. * (uv[0] - 0.5), 1e-14);
    EXPECT_NEAR(p[1], 2. * (uv[1] - 0.5), 1e-14);
    EXPECT_NEAR(p[2], (h - 1.) * 0.2, 1e-14);
    EXPECT_NEAR(TupleOf(diced, "MesoRelief", i)[0], 1. - h, 1e-14);
    // Bilinear interpolation of central differences is the central difference of the interpolation.
    const double texel = 1. / 32.;
    const double hs =
      (texture.sampleHeight({ s + texel, t }) - texture.sampleHeight({ s - texel, t })) / 2. * 32.;
    const double ht =
      (texture.sampleHeight({ s, t + texel }) - texture.sampleHeight({ s, t - texel })) / 2. * 32.;
    MesoVector normal = { -0.2 * hs * 2. / 3., -0.2 * ht / 2., 1. };
    normal = MesoScaled(normal, 1. / MesoLength(normal));
    EXPECT_LT(DistanceOf(TupleOf(diced, "Normals", i), normal), 1e-12);
  }
}

TEST(DisplacedMeshAccuracy, PointsLieOnTheSurface)
{
  const auto base = ShapeMesh("torus", { { "rings", { 9. } }, { "sides", { 6. } } });
  const Relief relief = { PatternMap("noise", 16), 0.2, { 2., 1. } };
  const Truth truth(base, relief);
  const auto diced = Dice(base, relief, 1.3);
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    const MesoVector uv = TupleOf(diced, "TextureCoordinates", i);
    EXPECT_LT(DistanceOf(PositionOf(diced, i), truth.At(uv[0], uv[1])), 1e-12);
  }
}

TEST(DisplacedMeshAccuracy, ErrorFallsFourfold)
{
  // Edges of 2 and 3 texels, so that their numbers of segments double exactly.
  const auto base = ShapeMesh("torus", { { "rings", { 6. } }, { "sides", { 4. } } });
  const Relief relief = { PatternMap("smooth", 12), 0.2, { 1., 1. } };
  const Truth truth(base, relief);
  double before[2] = { 0., 0. };
  for (double facets : { 2., 4., 8., 16. })
  {
    const Distances now(Dice(base, relief, facets), truth, relief, 4000);
    std::printf("%2g facets a texel: mean distance %.2e D, in facets without crease %.2e D\n",
      facets, now.All / relief.Scale, now.Smooth / relief.Scale);
    EXPECT_GT(now.NumberSmooth, 500);
    if (before[0] > 0.)
    {
      // 4000 samples give the means to about 3 %, their ratio to 5 %.
      EXPECT_NEAR(before[0] / now.All, 4., 0.6) << facets;
      EXPECT_NEAR(before[1] / now.Smooth, 4., 0.6) << facets;
    }
    before[0] = now.All;
    before[1] = now.Smooth;
  }
  EXPECT_LT(before[0], 2e-4 * relief.Scale);
}

class NormalOfDisplacedMesh : public testing::TestWithParam<double>
{
};

TEST_P(NormalOfDisplacedMesh, HasAllTerms)
{
  // A fine base and map stand for the smooth torus and pattern: the normal is that of
  // Q = P + (h - r) D N by central differences. D is half the tube, so that the change of N counts.
  const MesoShape shape("torus");
  const MesoPattern pattern("smooth", 1);
  const double scale = 0.2;
  const double reference = GetParam();
  const auto base = ShapeMesh("torus", { { "rings", { 128. } }, { "sides", { 96. } } });
  const auto diced = Dice(base, { PatternMap("smooth", 256), scale, { 3., 1. }, reference }, 0.2);
  const auto surface = [&](double u, double v)
  {
    const MesoShapePoint point = shape.At(u, v);
    const double h = pattern.At(3. * u, v);
    return MesoSum(point.Position, MesoScaled(point.Normal, (h - reference) * scale));
  };
  double worst = 0.;
  double sum = 0.;
  int count = 0;
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); i += 7)
  {
    const MesoVector uv = TupleOf(diced, "TextureCoordinates", i);
    const double u = 0.5 + (uv[0] - 0.5) * (1. - 1e-4); // off the chart's edge
    const double v = 0.5 + (uv[1] - 0.5) * (1. - 1e-4);
    const double e = 1e-5;
    const MesoVector qu = MesoDifference(surface(u + e, v), surface(u - e, v));
    const MesoVector qv = MesoDifference(surface(u, v + e), surface(u, v - e));
    const double degrees = DegreesBetween(TupleOf(diced, "Normals", i), MesoCross(qu, qv));
    worst = std::max(worst, degrees);
    sum += degrees;
    ++count;
  }
  EXPECT_GT(count, 1000);
  // What the finite base and map leave: without the change of N the mean is above 5 degrees.
  EXPECT_LT(sum / count, 0.2);
  EXPECT_LT(worst, 1.5);
}

INSTANTIATE_TEST_SUITE_P(References, NormalOfDisplacedMesh, testing::Values(1., 0.));

TEST(DisplacedMeshAccuracy, SphereMovedEvenlyIsASphere)
{
  const auto sphere = ShapeMesh("sphere", { { "radius", { 2. } } });
  for (double reference : { 0., 0.25, 1. })
  {
    const auto diced = Dice(sphere, { ConstantMap(0.625), 0.4, { 1., 1. }, reference }, 0.01);
    const double radius = 2. + (0.625 - reference) * 0.4; // 0.625 and its texels are exact in float
    ASSERT_EQ(diced->GetNumberOfPolys(), sphere->GetNumberOfPolys());
    for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(MesoLength(PositionOf(diced, i)), radius, 1e-14);
      ASSERT_NEAR(TupleOf(diced, "MesoRelief", i)[0], 0.375, 1e-15);
    }
  }
}

TEST(DisplacedMeshAccuracy, MirroredAndShearedChartsHaveTheSameSurface)
{
  // The plane under three charts; the map is what the chart puts there, so a mirrored chart with the
  // mirrored map is the same surface.
  const std::vector<MesoVector> square = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
    { 0., 1., 0. } };
  const auto map = PatternMap("smooth", 24);
  const auto mirrored =
    MakeMap(24, 24, [&](int i, int j) { return map->GetScalarComponentAsFloat(23 - i, j, 0, 0); });
  const auto straight = Dice(MakeMesh(square, { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } },
                               { { 0, 1, 2 }, { 0, 2, 3 } }),
    { map, 0.1, { 1., 1. } }, 1.);
  const auto turned = Dice(MakeMesh(square, { { 1., 0. }, { 0., 0. }, { 0., 1. }, { 1., 1. } },
                             { { 0, 1, 2 }, { 0, 2, 3 } }),
    { mirrored, 0.1, { 1., 1. } }, 1.);
  ASSERT_EQ(straight->GetNumberOfPoints(), turned->GetNumberOfPoints());
  for (vtkIdType i = 0; i < straight->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT(DistanceOf(PositionOf(straight, i), PositionOf(turned, i)), 1e-12);
    EXPECT_LT(DistanceOf(TupleOf(straight, "Normals", i), TupleOf(turned, "Normals", i)), 1e-10);
  }
  // Sheared: u = x + y / 2, v = y.
  const Relief relief = { map, 0.1, { 1., 1. } };
  const auto sheared = Dice(MakeMesh(square, { { 0., 0. }, { 1., 0. }, { 1.5, 1. }, { 0.5, 1. } },
                              { { 0, 1, 2 }, { 0, 2, 3 } }),
    relief, 1.);
  const auto texture = TextureOf(map, MesoWrap::Repeat);
  const double texel = 1. / 24.;
  for (vtkIdType i = 0; i < sheared->GetNumberOfPoints(); ++i)
  {
    const MesoVector p = PositionOf(sheared, i);
    const double u = p[0] + 0.5 * p[1];
    const double hu =
      12. * (texture.sampleHeight({ u + texel, p[1] }) - texture.sampleHeight({ u - texel, p[1] }));
    const double hv =
      12. * (texture.sampleHeight({ u, p[1] + texel }) - texture.sampleHeight({ u, p[1] - texel }));
    MesoVector normal = { -0.1 * hu, -0.1 * (0.5 * hu + hv), 1. };
    normal = MesoScaled(normal, 1. / MesoLength(normal));
    EXPECT_LT(DistanceOf(TupleOf(sheared, "Normals", i), normal), 1e-10);
  }
}

// A ray through a prism: entered and left where the faces are, with fins that bend either way, and between
// neighbours without a gap or an overlap; places in the prism are found again, and normals stand on it.

#include "KernelTypes.h"

#include <array>
#include <cmath>

template <typename Kernels>
class PrismKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec3;
  using Kernel = typename Kernels::PrismGeometry;
  using Shape = typename Kernel::Prism;
  using Span = typename Kernel::PrismSpan;

  /// Over the triangle (0, 0), (1, 0), (0, 1), one high.
  static Shape Straight()
  {
    Shape p;
    p.Bottom0 = Vec3(0., 0., 0.);
    p.Bottom1 = Vec3(1., 0., 0.);
    p.Bottom2 = Vec3(0., 1., 0.);
    p.Rise0 = p.Rise1 = p.Rise2 = Vec3(0., 0., 1.);
    p.Flags = 0;
    return p;
  }

  /// The same with corners and rises moved by up to `amount`, fins cut at random.
  Shape Bent(double amount)
  {
    Shape p = Straight();
    for (Vec3* v : { &p.Bottom0, &p.Bottom1, &p.Bottom2, &p.Rise0, &p.Rise1, &p.Rise2 })
    {
      *v += this->Around(amount);
    }
    p.Flags = static_cast<int>(this->Random(0., 7.999));
    return p;
  }

  Vec3 Around(double amount)
  {
    const Real x = this->Random(-amount, amount);
    const Real y = this->Random(-amount, amount);
    return Vec3(x, y, this->Random(-amount, amount));
  }

  auto Exits(const Shape& p, const Vec3& origin, const Vec3& direction)
  {
    std::pair<glm::vec<4, Real>, glm::vec<4, Real>> exits;
    this->K.prismExits(p, origin, direction, exits.first, exits.second);
    return exits;
  }

  static Vec3 PointOf(const Shape& p, const Vec3& place)
  {
    const Real b0 = 1 - place.x - place.y;
    return b0 * (p.Bottom0 + place.z * p.Rise0) + place.x * (p.Bottom1 + place.z * p.Rise1) +
      place.y * (p.Bottom2 + place.z * p.Rise2);
  }

  /// How often the prism's eight triangles wind around a point, in double (van Oosterom, Strackee 1983).
  static double WindingAround(const Shape& p, const glm::dvec3& point)
  {
    const std::array<glm::dvec3, 6> c = { glm::dvec3(p.Bottom0), glm::dvec3(p.Bottom1),
      glm::dvec3(p.Bottom2), glm::dvec3(p.Bottom0) + glm::dvec3(p.Rise0),
      glm::dvec3(p.Bottom1) + glm::dvec3(p.Rise1), glm::dvec3(p.Bottom2) + glm::dvec3(p.Rise2) };
    double angle = 0.;
    const auto add = [&](int i, int j, int k)
    {
      const glm::dvec3 a = c[i] - point;
      const glm::dvec3 b = c[j] - point;
      const glm::dvec3 d = c[k] - point;
      const double la = glm::length(a);
      const double lb = glm::length(b);
      const double ld = glm::length(d);
      angle += 2. *
        std::atan2(glm::dot(a, glm::cross(b, d)),
          la * lb * ld + glm::dot(a, b) * ld + glm::dot(b, d) * la + glm::dot(d, a) * lb);
    };
    add(0, 2, 1);
    add(3, 4, 5);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if ((p.Flags >> k) & 1)
      {
        add(k, next, k + 3);
        add(next, next + 3, k + 3);
      }
      else
      {
        add(k, next, next + 3);
        add(k, next + 3, k + 3);
      }
    }
    return angle / (4. * 3.14159265358979323846);
  }

  Kernel K;
};

TYPED_TEST_SUITE(PrismKernel, BothKernels, KernelNames);

TYPED_TEST(PrismKernel, FacesOfAStraightPrism)
{
  using Vec3 = typename TestFixture::Vec3;
  const auto p = this->Straight();
  const auto down = this->K.prismSpan(p, Vec3(0.25, 0.25, 3.), Vec3(0., 0., -1.), 0.);
  EXPECT_EQ(down.Enter, 2.);
  EXPECT_EQ(down.Leave, 3.);
  EXPECT_EQ(down.Face, 1);
  const auto up = this->K.prismSpan(p, Vec3(0.25, 0.25, -1.), Vec3(0., 0., 2.), 0.);
  EXPECT_EQ(up.Enter, 0.5);
  EXPECT_EQ(up.Leave, 1.);
  EXPECT_EQ(up.Face, 0);
  const auto along = this->K.prismSpan(p, Vec3(-1., 0.25, 0.5), Vec3(1., 0., 0.), 0.);
  EXPECT_EQ(along.Enter, 1.);
  EXPECT_NEAR(along.Leave, 1.75, 1e-6);
  EXPECT_EQ(along.Face, 4);
  const auto back = this->K.prismSpan(p, Vec3(2., 0.25, 0.5), Vec3(-1., 0., 0.), 0.);
  EXPECT_NEAR(back.Enter, 1.25, 1e-6);
  EXPECT_EQ(back.Face, 3);
  const auto front = this->K.prismSpan(p, Vec3(0.25, -1., 0.5), Vec3(0., 1., 0.), 0.);
  EXPECT_EQ(front.Enter, 1.);
  EXPECT_EQ(front.Face, 2);
  // Beside it, before a fin that it runs along with.
  const auto beside = this->K.prismSpan(p, Vec3(0.25, -0.1, 3.), Vec3(0., 0., -1.), 0.);
  EXPECT_LT(beside.Leave, beside.Enter);
}

TYPED_TEST(PrismKernel, IsWhatItsTrianglesEnclose)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  int inside = 0;
  int checked = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto p = this->Bent(0.2);
    const Vec3 through =
      this->PointOf(p, Vec3(0.3, 0.3, this->Random(-0.2, 1.2))) + this->Around(0.4);
    const Vec3 direction = this->Around(1.);
    const Vec3 origin = through - Real(3) * direction;
    for (int j = 0; j < 20; ++j)
    {
      const Real t = this->Random(2., 4.);
      const double winding =
        this->WindingAround(p, glm::dvec3(origin) + double(t) * glm::dvec3(direction));
      const auto span = this->K.prismSpan(p, origin, direction, t);
      if (std::abs(t - span.Enter) < 1e-4 || std::abs(t - span.Leave) < 1e-4)
      {
        continue; // on a face
      }
      const bool within = span.Enter <= t && t <= span.Leave;
      ASSERT_EQ(within, winding > 0.5) << i << ", " << j << ": " << winding;
      inside += within ? 1 : 0;
      ++checked;
    }
  }
  EXPECT_GT(inside, checked / 20);
  EXPECT_LT(inside, checked / 2);
}

TYPED_TEST(PrismKernel, TurnedRoundItIsTheSame)
{
  using Vec3 = typename TestFixture::Vec3;
  for (int i = 0; i < 500; ++i)
  {
    const auto p = this->Bent(0.2);
    auto turned = p;
    std::swap(turned.Bottom1, turned.Bottom2);
    std::swap(turned.Rise1, turned.Rise2);
    // Fin 0 of the one is fin 2 of the other, seen from the other end.
    turned.Flags = ((p.Flags & 1) ? 0 : 4) + ((p.Flags & 2) ? 0 : 2) + ((p.Flags & 4) ? 0 : 1);
    const Vec3 origin = this->Around(3.);
    const Vec3 direction = Vec3(0.3, 0.3, 0.5) - origin;
    const auto one = this->K.prismSpan(p, origin, direction, 1.);
    const auto other = this->K.prismSpan(turned, origin, direction, 1.);
    EXPECT_NEAR(one.Enter, other.Enter, 1e4 * this->Epsilon);
    EXPECT_NEAR(one.Leave, other.Leave, 1e4 * this->Epsilon);
  }
}

TYPED_TEST(PrismKernel, LeavesWhereTheNeighbourIsEntered)
{
  using Vec3 = typename TestFixture::Vec3;
  int crossed = 0;
  for (int i = 0; i < 5000; ++i)
  {
    // Two prisms at the fin between corners 1 and 2, cut alike.
    auto p = this->Bent(0.2);
    auto q = p;
    q.Bottom0 = Vec3(1., 1., 0.) + this->Around(0.1);
    q.Rise0 = Vec3(0., 0., 1.) + this->Around(0.2);
    std::swap(q.Bottom1, q.Bottom2);
    std::swap(q.Rise1, q.Rise2);
    q.Flags = (p.Flags & 2) ? 0 : 2;
    const Vec3 from = this->PointOf(p, Vec3(0.3, 0.2, this->Random(0.1, 0.9)));
    const Vec3 to = this->PointOf(q, Vec3(0.2, 0.3, this->Random(0.1, 0.9)));
    const auto before = this->K.prismSpan(p, from, to - from, 0.);
    const auto after = this->K.prismSpan(q, from, to - from, 1.);
    if (before.Enter <= 0. && before.Leave >= 0. && after.Face == 3 && after.Enter <= 1. &&
      before.Leave < 1.)
    {
      ASSERT_EQ(before.Leave, after.Enter) << i;
      ++crossed;
    }
  }
  EXPECT_GT(crossed, 4000);
}

TYPED_TEST(PrismKernel, FinsThatBendInwardCanBeCrossedTwice)
{
  using Vec3 = typename TestFixture::Vec3;
  // The top of the fin over the edge from corner 0 to 1 leans in at one end: its triangles bend inward.
  auto p = this->Straight();
  p.Rise0 = Vec3(0., 0.5, 1.);
  p.Flags = 0; // from the bottom of corner 0 to the top of corner 1
  const Vec3 middle = this->PointOf(p, Vec3(0.5, 0., 0.5));
  const auto convex = this->K.prismSpan(p, middle - Vec3(0., 2., 0.), Vec3(0., 1., 0.), 2.);
  p.Flags = 1;
  const auto concave = this->K.prismSpan(p, middle - Vec3(0., 2., 0.), Vec3(0., 1., 0.), 2.);
  // The two ways to cut the bilinear fin lie on both sides of it.
  EXPECT_LT(std::min(convex.Enter, concave.Enter), 2.);
  EXPECT_GT(std::max(convex.Enter, concave.Enter), 2.);
  p.Flags = convex.Enter > concave.Enter ? 0 : 1; // the one that bends inward
  // A ray along the fin: in at one end, out in the middle where the fin bends in, and in again.
  int twice = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 from = Vec3(-0.5, this->Random(-0.2, 0.4), this->Random(0., 1.));
    const Vec3 to = Vec3(1.5, this->Random(-0.2, 0.4), this->Random(0., 1.));
    const auto first = this->K.prismSpan(p, from, to - from, 0.);
    const auto last = this->K.prismSpan(p, from, to - from, 1.);
    if (first.Leave > first.Enter && last.Leave > last.Enter && first.Leave < last.Enter)
    {
      ++twice;
    }
  }
  EXPECT_GT(twice, 20);
}

TYPED_TEST(PrismKernel, ExitsAtVerticesAreThoseOfTheRayBetweenThem)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  using Vec4 = decltype(this->Exits(this->Straight(), Vec3(0.), Vec3(1.)).first);
  int same = 0;
  int further = 0;
  for (int i = 0; i < 4000; ++i)
  {
    // Parallel rays into the top: there distances to planes are linear.
    const auto p = this->Bent(0.15);
    const Vec3 top[] = { p.Bottom0 + p.Rise0, p.Bottom1 + p.Rise1, p.Bottom2 + p.Rise2 };
    const Vec3 direction(this->Random(-1., 1.), this->Random(-1., 1.), -1.);
    Real b[] = { Real(0), this->Random(0.05, 0.9), this->Random(0.05, 0.9) };
    if (b[1] + b[2] > 0.95)
    {
      continue;
    }
    b[0] = 1 - b[1] - b[2];
    Vec3 origin(0.);
    Vec4 lower(0.);
    Vec4 upper(0.);
    for (int k = 0; k < 3; ++k)
    {
      const auto exits = this->Exits(p, top[k], direction);
      origin += b[k] * top[k];
      lower += b[k] * exits.first;
      upper += b[k] * exits.second;
    }
    const auto span = this->K.prismSpan(p, origin, direction, 0.);
    if (!(span.Face == 1 && span.Leave > 0.01))
    {
      continue;
    }
    // A fin that bends inward may be left and entered again: the paper's rule leaves it for good.
    const Real leave = this->K.leaveByExits(p, lower, upper);
    ASSERT_GT(leave, span.Leave - 1e4 * this->Epsilon) << i;
    ++(leave < span.Leave + 1e4 * this->Epsilon ? same : further);
  }
  EXPECT_GT(same, 1000);
  EXPECT_LT(further, same / 10);
}

TYPED_TEST(PrismKernel, FinsThatBendInwardAreLeftByTheFurtherPlane)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  // The fin over the edge from corner 0 to 1, its top leaning in at one end or out.
  for (const double lean : { 0.5, -0.5 })
  {
    for (const int flags : { 0, 1 })
    {
      auto p = this->Straight();
      p.Rise0 = Vec3(0., lean, 1.);
      p.Flags = flags;
      const Vec3 inside(0.45, 0.3, 0.5);
      const auto exits = this->Exits(p, inside, Vec3(0., -1., 0.));
      const Real near = std::min(exits.first.y, exits.second.y);
      const Real far = std::max(exits.first.y, exits.second.y);
      EXPECT_LT(near, far - 0.01);
      const bool inward = this->K.finOfPrism(p, 0, Real(1)).Inward;
      EXPECT_EQ(inward, (lean > 0.) == (flags == 1));
      EXPECT_EQ(this->K.leaveByExits(p, exits.first, exits.second), inward ? far : near);
    }
  }
}

TYPED_TEST(PrismKernel, PlacesOnFinsAreThoseOfTheNeighbour)
{
  using Vec3 = typename TestFixture::Vec3;
  const Vec3 corners[] = { Vec3(0., 0., 0.3), Vec3(1., 0., 0.3), Vec3(0., 1., 0.3) };
  for (int fin = 0; fin < 3; ++fin)
  {
    const Vec3 place = this->K.placeOnFin(fin, 0.25, 0.3);
    const Vec3 expected =
      corners[fin] + (corners[(fin + 1) % 3] - corners[fin]) * typename TestFixture::Real(0.25);
    EXPECT_NEAR(glm::length(place - expected), 0., 10. * this->Epsilon);
    EXPECT_NEAR(this->K.alongFin(fin, place), 0.25, this->Epsilon);
    EXPECT_EQ(this->K.nearestFace(place), 2 + fin);
  }
  EXPECT_EQ(this->K.nearestFace(Vec3(0.3, 0.3, 0.01)), 0);
  EXPECT_EQ(this->K.nearestFace(Vec3(0.3, 0.3, 0.99)), 1);
}

TYPED_TEST(PrismKernel, AFanAroundAVertexFillsARayThroughIt)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  // Six prisms around the axis x = y = 0; rays along it, along fins, and through rims.
  constexpr int count = 6;
  std::vector<typename TestFixture::Shape> fan;
  const auto rim = [](int i)
  {
    const double angle = 2. * 3.14159265358979323846 * (i % count) / count;
    return Vec3(std::cos(angle), std::sin(angle), 0.);
  };
  for (int i = 0; i < count; ++i)
  {
    auto p = this->Straight();
    p.Bottom0 = Vec3(0.);
    p.Bottom1 = rim(i);
    p.Bottom2 = rim(i + 1);
    p.Rise1 = Vec3(0., 0., 1.) + Real(0.2) * p.Bottom1;
    p.Rise2 = Vec3(0., 0., 1.) + Real(0.2) * p.Bottom2;
    p.Flags = (i + 1) % count < i ? 2 : 0;
    fan.push_back(p);
  }
  const auto filled = [&](const Vec3& origin, const Vec3& direction)
  {
    Real sum = 0;
    for (const auto& p : fan)
    {
      const auto span = this->K.prismSpan(p, origin, direction, 1.);
      EXPECT_FALSE(std::isnan(span.Enter) || std::isnan(span.Leave));
      sum = std::max(sum, std::max(span.Leave - span.Enter, Real(0)));
    }
    return sum;
  };
  EXPECT_NEAR(filled(Vec3(0., 0., 2.), Vec3(0., 0., -1.)), 1., 1e-5);   // the axis itself
  EXPECT_NEAR(filled(Vec3(0.5, 0., 2.), Vec3(0., 0., -1.)), 1., 1e-5);  // in a fin
  EXPECT_NEAR(filled(Vec3(-2., 0., 0.5), Vec3(1., 0., 0.)), 1.1, 1e-5); // in two fins: half of 2.2
}

TYPED_TEST(PrismKernel, PrismsWithoutVolumeGiveNumbers)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  auto flat = this->Straight();
  flat.Rise0 = flat.Rise1 = flat.Rise2 = Vec3(0.);
  auto thin = this->Straight();
  thin.Bottom2 = Vec3(0.5, 0., 0.);
  auto point = flat;
  point.Bottom1 = point.Bottom2 = Vec3(0.);
  auto inverted = this->Straight();
  inverted.Rise0 = Vec3(2., 2., 1.);
  inverted.Rise1 = Vec3(-3., 0., 1.);
  for (const auto& p : { flat, thin, point, inverted })
  {
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 direction =
        i < 3 ? Vec3(Real(i == 0), Real(i == 1), Real(i == 2)) : this->Around(1.);
      const Vec3 origin = i < 6 ? Vec3(0.) : this->Around(2.);
      const auto span = this->K.prismSpan(p, origin, direction, 0.);
      EXPECT_FALSE(std::isnan(span.Enter) || std::isnan(span.Leave));
      const Vec3 place = this->K.prismPlace(p, origin, Vec3(0.3, 0.3, 0.5));
      const Vec3 rates = this->K.prismRates(p, place, direction);
      const Vec3 normal = this->K.prismNormal(p, place, direction);
      EXPECT_FALSE(std::isnan(place.x + place.y + place.z));
      EXPECT_FALSE(std::isnan(rates.x + rates.y + rates.z));
      EXPECT_FALSE(std::isnan(normal.x + normal.y + normal.z));
    }
  }
}

TYPED_TEST(PrismKernel, PlacesAreFoundAgain)
{
  using Vec3 = typename TestFixture::Vec3;
  for (int i = 0; i < 2000; ++i)
  {
    const auto p = this->Bent(0.12);
    Vec3 place(this->Random(0., 1.), this->Random(0., 1.), this->Random(0., 1.));
    if (place.x + place.y > 1.)
    {
      place = Vec3(1. - place.x, 1. - place.y, place.z);
    }
    const Vec3 found = this->K.prismPlace(p, this->PointOf(p, place), Vec3(0.3, 0.3, 0.5));
    const double limit = 100. * this->Epsilon + 1e-9; // Newton stops where its steps are below 1e-5
    EXPECT_NEAR(found.x, place.x, limit) << i;
    EXPECT_NEAR(found.y, place.y, limit) << i;
    EXPECT_NEAR(found.z, place.z, limit) << i;
  }
}

TYPED_TEST(PrismKernel, NormalsStandOnTheSurface)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  for (int i = 0; i < 500; ++i)
  {
    const auto p = this->Bent(0.2);
    const Vec3 place(this->Random(0., 0.5), this->Random(0., 0.5), this->Random(0., 1.));
    const Vec3 gradient = this->Around(1.);
    const Vec3 normal = this->K.prismNormal(p, place, gradient);
    // Along what keeps the function as it is the place moves across the normal; up it, with the normal.
    const Vec3 along = glm::cross(gradient, this->Around(1.));
    Vec3 t1;
    Vec3 t2;
    Vec3 t3;
    this->K.prismTangents(p, place, t1, t2, t3);
    const Vec3 level = along.x * t1 + along.y * t2 + along.z * t3;
    const Vec3 rising = gradient.x * t1 + gradient.y * t2 + gradient.z * t3;
    EXPECT_NEAR(glm::dot(normal, level), 0., 20. * this->Epsilon);
    EXPECT_GT(glm::dot(normal, rising), 0.) << i;
    // Rates are the tangents' inverse.
    const Vec3 rates = this->K.prismRates(p, place, rising);
    EXPECT_NEAR(glm::length(rates - gradient), 0., Real(200) * this->Epsilon);
  }
  const auto p = this->Straight();
  const Vec3 place(0.25, 0.25, 0.5);
  EXPECT_LT(this->K.prismFaceNormal(p, 0, place).z, 0.);
  EXPECT_GT(this->K.prismFaceNormal(p, 1, place).z, 0.);
  EXPECT_LT(this->K.prismFaceNormal(p, 2, place).y, 0.);
  EXPECT_GT(this->K.prismFaceNormal(p, 3, place).x, 0.);
  EXPECT_LT(this->K.prismFaceNormal(p, 4, place).x, 0.);
}

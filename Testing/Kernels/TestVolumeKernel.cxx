// Signed distances between voxels, across the tile's border and past the last slice; and the first meeting
// of a straight way with matter, against a dense march in double.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class VolumeKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec3;
  using Volume = typename Kernels::Volume;

  static constexpr double Depth = 0.5;

  /// A ball of radius 0.2 tiles around (0.5, 0.5) at half the depth.
  static std::vector<float> Ball(const std::array<int, 3>& size)
  {
    std::vector<float> distances;
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const double x = (i + 0.5) / size[0] - 0.5;
          const double y = (j + 0.5) / size[1] - 0.5;
          const double z = Depth * ((k + 0.5) / size[2] - 0.5);
          distances.push_back(static_cast<float>(std::sqrt(x * x + y * y + z * z) - 0.2));
        }
      }
    }
    return distances;
  }
};

TYPED_TEST_SUITE(VolumeKernel, BothKernels, KernelNames);

TYPED_TEST(VolumeKernel, DistancesAreThoseOfTheSampler)
{
  using Vec3 = typename TestFixture::Vec3;
  const typename TestFixture::Volume volume({ 5, 4, 3 }, this->RandomHeights(60));
  EXPECT_EQ(volume.exactDistance(Vec3(0.5, 0.375, 0.5)), volume.fetchVolume({ 2, 1, 1 }));
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 place(this->Random(-3., 3.), this->Random(-3., 3.), this->Random(0., 1.));
    EXPECT_NEAR(volume.exactDistance(place), volume.sampleVolume(place), 60. * this->Epsilon) << i;
  }
  // A tile on, the same; below the first slice's middle, as there.
  EXPECT_NEAR(volume.exactDistance(Vec3(0.3, 0.2, 0.5)), volume.exactDistance(Vec3(2.3, -0.8, 0.5)),
    30. * this->Epsilon);
  EXPECT_EQ(
    volume.exactDistance(Vec3(0.3, 0.2, 0.)), volume.exactDistance(Vec3(0.3, 0.2, 1. / 6.)));
}

TYPED_TEST(VolumeKernel, GradientsAreThoseOfTheInterpolant)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  const typename TestFixture::Volume volume({ 8, 8, 8 }, this->RandomHeights(512));
  for (int i = 0; i < 300; ++i)
  {
    // In the middle half of a cell, so that both ends of the differences are in it.
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] =
        (std::floor(this->Random(0., 7.)) + Real(0.5) + this->Random(0.25, 0.75)) / Real(8);
    }
    const Vec3 gradient = volume.voxelGradient(place);
    const Real step = Real(1) / 64;
    for (int axis = 0; axis < 3; ++axis)
    {
      Vec3 aside(0.);
      aside[axis] = step;
      const Real difference =
        (volume.exactDistance(place + aside) - volume.exactDistance(place - aside)) / (2 * step);
      EXPECT_NEAR(gradient[axis], difference, 4000. * this->Epsilon) << i;
    }
  }
  // Central differences of one voxel, in the middle of one.
  const Vec3 middle(3.5 / 8., 4.5 / 8., 2.5 / 8.);
  const Vec3 central = volume.volumeGradient(middle);
  EXPECT_NEAR(
    central.x, 4. * (volume.fetchVolume({ 4, 4, 2 }) - volume.fetchVolume({ 2, 4, 2 })), 1e-5);
  EXPECT_NEAR(
    central.y, 4. * (volume.fetchVolume({ 3, 5, 2 }) - volume.fetchVolume({ 3, 3, 2 })), 1e-5);
  EXPECT_NEAR(
    central.z, 4. * (volume.fetchVolume({ 3, 4, 3 }) - volume.fetchVolume({ 3, 4, 1 })), 1e-5);
}

TYPED_TEST(VolumeKernel, FindsTheFirstMeeting)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  const std::array<int, 3> size = { 32, 32, 16 };
  const typename TestFixture::Volume volume(size, this->Ball(size));
  const Real voxel = Real(1) / 32;
  int hits = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 from(this->Random(0., 1.), this->Random(0., 1.), this->Random(0.95, 1.));
    const Vec3 to(this->Random(-1., 2.), this->Random(-1., 2.), 0.);
    const Vec3 span = to - from;
    const auto hit = volume.exactHit(from, span,
      volume.bracketInVolume(from, span, Real(this->Depth), Real(0.25) * voxel, 256, false));
    constexpr int marches = 4000;
    double first = 2.;
    double nearest = 1.;
    for (int step = 0; step <= marches && first > 1.; ++step)
    {
      const Real part = Real(step) / marches;
      const double distance = volume.exactDistance(from + part * span);
      nearest = std::min(nearest, distance);
      first = distance <= 0. ? double(part) : first;
    }
    if (hit.Found)
    {
      ++hits;
      ASSERT_LE(first, 1.) << i;
      EXPECT_NEAR(hit.Part, first, 1.5 / marches) << i;
      EXPECT_NEAR(
        volume.exactDistance(from + hit.Part * span), 0., 2e-4 * voxel + 10. * this->Epsilon);
    }
    else
    {
      EXPECT_GT(nearest, -0.02 * voxel) << i; // it grazes the ball at most
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_LT(hits, 800);
}

TYPED_TEST(VolumeKernel, AWayThatStartsInMatterMeetsItThere)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  const std::array<int, 3> size = { 16, 16, 16 };
  const typename TestFixture::Volume volume(size, this->Ball(size));
  const auto inside = volume.bracketInVolume(
    Vec3(0.5, 0.5, 0.5), Vec3(0., 0., 1.), Real(this->Depth), Real(0.02), 64, false);
  EXPECT_TRUE(inside.Found);
  EXPECT_EQ(inside.Part, 0.);
  const auto nowhere = volume.bracketInVolume(
    Vec3(0., 0., 0.5), Vec3(0., 0., 0.), Real(this->Depth), Real(0.02), 64, false);
  EXPECT_FALSE(nowhere.Found);
  // From the ball's surface away from it, and into it.
  const Vec3 top(0.5, 0.5, 0.5 + 0.2 / this->Depth);
  EXPECT_FALSE(
    volume.bracketInVolume(top, Vec3(0., 0., 0.09), Real(this->Depth), Real(0.02), 64, true).Found);
  EXPECT_TRUE(
    volume.bracketInVolume(top, Vec3(0., 0., -0.5), Real(this->Depth), Real(0.02), 64, true).Found);
}

TYPED_TEST(VolumeKernel, PlacesAreLiftedOffMatter)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  const std::array<int, 3> size = { 32, 32, 16 };
  const typename TestFixture::Volume volume(size, this->Ball(size));
  const Real depth = Real(this->Depth);
  const Real voxel = volume.voxelSide(depth);
  EXPECT_NEAR(voxel, 1. / 32., 1e-6);
  for (int i = 0; i < 200; ++i)
  {
    // In the ball, not at its middle, where no way leads out.
    Vec3 away(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    away *= this->Random(0.12, 0.19) / glm::length(away);
    const Vec3 place = Vec3(0.5, 0.5, 0.5) + away / Vec3(1., 1., depth);
    const Vec3 lifted = volume.liftedOff(place, depth, Real(1.5));
    EXPECT_NEAR(volume.exactDistance(lifted), 1.5 * voxel, 0.35 * voxel)
      << i; // gradients of voxels
    const Vec3 moved = (lifted - place) * Vec3(1., 1., depth);
    EXPECT_GT(glm::dot(moved, away) / glm::length(moved) / glm::length(away), 0.99) << i;
  }
  const Vec3 up = volume.wayInShell(Vec3(0.2, 0.3, 0.75), Vec3(2., 0., 0.5));
  EXPECT_NEAR(up.z, 0.25, 1e-6);
  EXPECT_NEAR(up.x, 1., 1e-6);
  const Vec3 down = volume.wayInShell(Vec3(0.2, 0.3, 0.75), Vec3(0., 1., -0.5));
  EXPECT_EQ(down, Vec3(0., 1., -0.5));
  EXPECT_EQ(volume.wayInShell(Vec3(0.2, 0.3, 1.), Vec3(1., 1., 0.5)), Vec3(0., 0., 0.));
}

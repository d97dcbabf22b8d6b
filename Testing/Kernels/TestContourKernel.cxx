// Coverage by contour lines against the share of many points in the pixel, and its sums over rows of
// pixels against the lines' width.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class ContourKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  typename Kernels::Contour Kernel;

  /// The share of points of a pixel that lie within half a width of a line between 0 and 1.
  static double ByPoints(double value, double perPixel, double spacing, double offset, double width)
  {
    constexpr int points = 20000;
    int covered = 0;
    for (int i = 0; i < points; ++i)
    {
      const double x = (i + 0.5) / points - 0.5;
      const double at = value + x * perPixel;
      const double line = offset + spacing * std::floor((at - offset) / spacing + 0.5);
      covered += std::abs(at - line) <= 0.5 * width * perPixel ? 1 : 0;
    }
    return static_cast<double>(covered) / points;
  }
};

TYPED_TEST_SUITE(ContourKernel, BothKernels, KernelNames);

TYPED_TEST(ContourKernel, CoversAsManyPointsDo)
{
  using Real = typename TestFixture::Real;
  for (int i = 0; i < 300; ++i)
  {
    const Real spacing = this->Random(0.05, 0.3);
    const Real offset = this->Random(-0.5, 0.5);
    const Real width = this->Random(0.3, 4.);
    const Real perPixel = Real(spacing * std::pow(10., double(this->Random(-1.5, 1.))));
    const Real value = this->Random(0.31, 0.69); // no line near the ends
    const double expected = this->ByPoints(value, perPixel, spacing, offset, width);
    const double covered = this->Kernel.evenContours(value, perPixel, spacing, offset, width);
    // 20000 points tell edges apart to 1 / 20000; floats to epsilon / (lines per pixel).
    EXPECT_NEAR(covered, expected, 2e-4 + 4. * this->Epsilon * double(spacing / perPixel))
      << "value " << value << " per pixel " << perPixel << " spacing " << spacing << " offset "
      << offset << " width " << width;
  }
}

TYPED_TEST(ContourKernel, ALineIsAsWideAsItIsSaidHoweverItLies)
{
  using Real = typename TestFixture::Real;
  for (int i = 0; i < 200; ++i)
  {
    const Real width = this->Random(0.2, 5.);
    const Real perPixel = this->Random(0.001, 0.01);
    const Real at = Real(0.5) + this->Random(-0.5, 0.5) * perPixel;
    double one = 0.;
    double even = 0.;
    for (int pixel = -10; pixel <= 10; ++pixel)
    {
      const Real value = Real(0.5) + Real(pixel) * perPixel;
      one += this->Kernel.oneContour(value, perPixel, at, width);
      even += this->Kernel.evenContours(value, perPixel, Real(0.3), at, width);
    }
    EXPECT_NEAR(one, width, 1e-3);
    EXPECT_NEAR(even, width, 1e-3);
  }
}

TYPED_TEST(ContourKernel, LinesTooDenseToTellApartAreATint)
{
  // 0.4 pixels wide and 50 lines a pixel: all of it; 1/500 of a pixel wide: a tenth.
  EXPECT_NEAR(this->Kernel.evenContours(0.5, 0.5, 0.01, 0., 0.4), 1., 1e-5);
  EXPECT_NEAR(this->Kernel.evenContours(0.5, 0.5, 0.01, 0., 0.002), 0.1, 1e-3);
}

TYPED_TEST(ContourKernel, PlateausSummitsAndGroundsHaveNoLine)
{
  for (const double flat : { 0., 1e-7, NotANumber })
  {
    EXPECT_EQ(this->Kernel.evenContours(0.5, flat, 0.25, 0., 2.), 0.);
    EXPECT_EQ(this->Kernel.oneContour(0.5, flat, 0.5, 2.), 0.);
  }
  EXPECT_EQ(this->Kernel.evenContours(1., 0.01, 0.25, 0., 2.), 0.);
  EXPECT_EQ(this->Kernel.evenContours(0., 0.01, 0.25, 0., 2.), 0.);
  EXPECT_NEAR(this->Kernel.evenContours(0.75, 0.01, 0.25, 0., 2.), 1., 1e-5);
}

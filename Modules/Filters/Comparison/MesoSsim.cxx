#include "MesoSsim.h"

#include "MesoScene.h" // for MesoInputError
#include "MesoSeparableFilter.h"

#include <cmath>

namespace
{
MesoPlane Luma(const MesoPicture& picture)
{
  MesoPlane plane(picture.Width, picture.Height);
  for (std::size_t i = 0; i < picture.NumberOfPixels(); ++i)
  {
    const float* rgb = &picture.Rgb[3 * i];
    plane.Values[i] = 0.2126 * MesoLinearOfSRGB(rgb[0]) + 0.7152 * MesoLinearOfSRGB(rgb[1]) +
      0.0722 * MesoLinearOfSRGB(rgb[2]);
  }
  return plane;
}

std::vector<double> Window()
{
  constexpr int Radius = 5;
  constexpr double Deviation = 1.5;
  std::vector<double> kernel;
  double sum = 0.;
  for (int x = -Radius; x <= Radius; ++x)
  {
    kernel.push_back(std::exp(-0.5 * x * x / (Deviation * Deviation)));
    sum += kernel.back();
  }
  for (double& value : kernel)
  {
    value /= sum;
  }
  return kernel;
}

/// The mean of a product over the window around each pixel.
MesoPlane MeanOfProduct(const MesoPlane& a, const MesoPlane& b, const std::vector<double>& window)
{
  MesoPlane product = a;
  for (std::size_t i = 0; i < product.Values.size(); ++i)
  {
    product.Values[i] *= b.Values[i];
  }
  return MesoFilterSeparably(product, window, window, MesoFilterEdge::Renormalise);
}
}

std::vector<float> MesoSsim(const MesoPicture& truth, const MesoPicture& test)
{
  if (truth.Width != test.Width || truth.Height != test.Height)
  {
    throw MesoInputError("SSIM compares pictures of one size");
  }
  constexpr double C1 = 0.01 * 0.01;
  constexpr double C2 = 0.03 * 0.03;
  const std::vector<double> window = Window();
  const MesoPlane x = Luma(truth);
  const MesoPlane y = Luma(test);
  const MesoPlane meanX = MesoFilterSeparably(x, window, window, MesoFilterEdge::Renormalise);
  const MesoPlane meanY = MesoFilterSeparably(y, window, window, MesoFilterEdge::Renormalise);
  const MesoPlane squareX = MeanOfProduct(x, x, window);
  const MesoPlane squareY = MeanOfProduct(y, y, window);
  const MesoPlane product = MeanOfProduct(x, y, window);
  std::vector<float> index(x.Values.size());
  for (std::size_t i = 0; i < index.size(); ++i)
  {
    const double mx = meanX.Values[i];
    const double my = meanY.Values[i];
    const double varianceX = squareX.Values[i] - mx * mx;
    const double varianceY = squareY.Values[i] - my * my;
    const double covariance = product.Values[i] - mx * my;
    index[i] = static_cast<float>((2. * mx * my + C1) * (2. * covariance + C2) /
      ((mx * mx + my * my + C1) * (varianceX + varianceY + C2)));
  }
  return index;
}

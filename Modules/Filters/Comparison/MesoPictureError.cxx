#include "MesoPictureError.h"

#include "MesoFlip.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoSsim.h"

#include <cmath>

MesoPictureError MesoComparePictures(
  const MesoPicture& truth, const MesoPicture& test, const std::vector<bool>& counts)
{
  if (!counts.empty() && counts.size() != truth.NumberOfPixels())
  {
    throw MesoInputError("the pixels that count are not as many as the picture has");
  }
  MesoPictureError error;
  error.FlipMap = MesoFlip(truth, test);
  const std::vector<float> ssim = MesoSsim(truth, test);
  double flipSum = 0.;
  double ssimSum = 0.;
  double squareSum = 0.;
  double pixels = 0.;
  for (std::size_t i = 0; i < truth.NumberOfPixels(); ++i)
  {
    if (!counts.empty() && !counts[i])
    {
      continue;
    }
    pixels += 1.;
    flipSum += error.FlipMap[i];
    ssimSum += ssim[i];
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
    {
      const double difference = MesoLinearOfSRGB(truth.Rgb[k]) - MesoLinearOfSRGB(test.Rgb[k]);
      squareSum += difference * difference;
    }
  }
  if (pixels > 0.)
  {
    error.FlipMean = flipSum / pixels;
    error.Ssim = ssimSum / pixels;
    error.Rmse = std::sqrt(squareSum / (3. * pixels));
  }
  return error;
}

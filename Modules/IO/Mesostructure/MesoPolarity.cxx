#include "MesoPolarity.h"

#include "MesoMessage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdio>

namespace
{
constexpr double LeastCorrelation = 0.15; // well above what unrelated maps have by chance

/// Sums for the correlation of two quantities.
class Correlation
{
public:
  void Add(double a, double b)
  {
    ++this->Count;
    this->A += a;
    this->B += b;
    this->AA += a * a;
    this->BB += b * b;
    this->AB += a * b;
  }
  double Value() const
  {
    const double n = this->Count;
    const double varianceA = n * this->AA - this->A * this->A;
    const double varianceB = n * this->BB - this->B * this->B;
    // A constant differs from itself by rounding alone.
    if (!(varianceA > 1e-12 * n * this->AA) || !(varianceB > 1e-12 * n * this->BB))
    {
      return 0.;
    }
    return (n * this->AB - this->A * this->B) / std::sqrt(varianceA * varianceB);
  }

private:
  double Count = 0.;
  double A = 0.;
  double B = 0.;
  double AA = 0.;
  double BB = 0.;
  double AB = 0.;
};

std::string Rounded(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}
}

MesoPolarity::Reading MesoPolarity::Says(bool isYUp) const
{
  const double v = isYUp ? this->InV : -this->InV;
  return this->InU > LeastCorrelation && v > LeastCorrelation ? Reading::Height
    : this->InU < -LeastCorrelation && v < -LeastCorrelation  ? Reading::Depth
                                                              : Reading::Unknown;
}

bool MesoPolarity::LooksYDown() const
{
  return std::abs(this->InU) > LeastCorrelation && std::abs(this->InV) > LeastCorrelation &&
    (this->InU > 0.) != (this->InV > 0.);
}

MesoPolarity MesoComparePolarity(vtkImageData* map, vtkImageData* normalMap)
{
  int size[3];
  int normalSize[3];
  map->GetDimensions(size);
  normalMap->GetDimensions(normalSize);
  vtkDataArray* values = map->GetPointData()->GetScalars();
  vtkDataArray* normals = normalMap->GetPointData()->GetScalars();
  MesoPolarity polarity;
  if (!values || !normals || normals->GetNumberOfComponents() < 3)
  {
    return polarity;
  }
  Correlation u;
  Correlation v;
  const auto value = [&](int i, int j)
  { return values->GetComponent(vtkIdType(j) * size[0] + i, 0); };
  for (int j = 1; j + 1 < size[1]; ++j)
  {
    const int row = static_cast<int>((j + 0.5) / size[1] * normalSize[1]);
    for (int i = 1; i + 1 < size[0]; ++i)
    {
      const int column = static_cast<int>((i + 0.5) / size[0] * normalSize[0]);
      const vtkIdType texel = vtkIdType(row) * normalSize[0] + column;
      u.Add(value(i + 1, j) - value(i - 1, j), -normals->GetComponent(texel, 0));
      v.Add(value(i, j + 1) - value(i, j - 1), -normals->GetComponent(texel, 1));
    }
  }
  polarity.InU = u.Value();
  polarity.InV = v.Value();
  return polarity;
}

std::string MesoPolarityWarning(
  vtkImageData* map, vtkImageData* normalMap, bool isDepth, bool isYUp)
{
  using Reading = MesoPolarity::Reading;
  const MesoPolarity polarity = MesoComparePolarity(map, normalMap);
  const std::string figures =
    " (correlations " + Rounded(polarity.InU) + " in u, " + Rounded(polarity.InV) + " in v)";
  const Reading said = isDepth ? Reading::Depth : Reading::Height;
  const Reading seen = polarity.Says(isYUp);
  if (seen != Reading::Unknown && seen != said)
  {
    return std::string("the normal map says that the map is one of ") +
      (seen == Reading::Depth ? "depths, not of heights" : "heights, not of depths") + figures;
  }
  if (polarity.LooksYDown() == isYUp && seen == Reading::Unknown &&
    polarity.Says(!isYUp) != Reading::Unknown)
  {
    return std::string("the normal map's y seems to point ") + (isYUp ? "down" : "up") + ", not " +
      (isYUp ? "up" : "down") + figures;
  }
  return {};
}

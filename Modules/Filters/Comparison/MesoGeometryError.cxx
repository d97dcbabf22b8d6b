#include "MesoGeometryError.h"

#include "MesoOutline.h"

#include <cmath>

namespace
{
using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Errors and the pixels that they were found at.
struct Sample
{
  std::vector<double> Errors;
  std::vector<std::size_t> Pixels;

  void Add(double error, std::size_t pixel)
  {
    this->Errors.push_back(error);
    this->Pixels.push_back(pixel);
  }
  void Add(const Sample& other)
  {
    this->Errors.insert(this->Errors.end(), other.Errors.begin(), other.Errors.end());
    this->Pixels.insert(this->Pixels.end(), other.Pixels.begin(), other.Pixels.end());
  }
  MesoErrorSpread Spread() const { return MesoErrorSpread::Of(this->Errors, this->Pixels); }
};

class Comparison
{
public:
  Comparison(const MesoAOVs& truth, const MesoAOVs& test)
    : Truth(truth)
    , Test(test)
    , Pixels(truth.NumberOfPixels())
    , InTruth(truth.NumberOfPixels())
    , InTest(truth.NumberOfPixels())
  {
  }

  MesoGeometryError Run()
  {
    this->Error.Classes.assign(this->Pixels, MesoPixelClass::Empty);
    this->Error.Counts.assign(this->Pixels, false);
    this->FindCoverage();
    this->CompareOutlines();
    for (std::size_t pixel = 0; pixel < this->Pixels; ++pixel)
    {
      if (this->InTruth[pixel] && this->InTest[pixel])
      {
        ++this->Error.BothPixels;
        if (!this->Test.NotANumber[pixel])
        {
          this->ComparePixel(pixel);
        }
      }
    }
    this->Summarise();
    return this->Error;
  }

private:
  void FindCoverage()
  {
    for (std::size_t pixel = 0; pixel < this->Pixels; ++pixel)
    {
      bool inTruth = this->Truth.Coverage[pixel] >= 0.5f;
      bool inTest = this->Test.Coverage[pixel] >= 0.5f;
      MesoPixelClass& kind = this->Error.Classes[pixel];
      if (inTruth && !this->Truth.Base.empty() && this->Truth.Base[pixel] < 0.5f)
      {
        ++this->Error.BoundaryPixels;
        kind = MesoPixelClass::Boundary;
        inTruth = false;
        inTest = false;
      }
      this->InTruth[pixel] = inTruth;
      this->InTest[pixel] = inTest;
      this->Error.Counts[pixel] = inTruth || inTest;
      if (inTruth && !inTest)
      {
        ++this->Error.VoidPixels;
        kind = MesoPixelClass::Missing;
      }
      else if (!inTruth && inTest)
      {
        ++this->Error.ExtraPixels;
        kind = MesoPixelClass::Extra;
      }
      else if (inTruth)
      {
        kind = MesoPixelClass::Equal;
      }
      if (this->Test.NotANumber[pixel])
      {
        ++this->Error.NanPixels;
        kind = MesoPixelClass::NotANumber;
      }
    }
  }

  void CompareOutlines()
  {
    const int width = this->Truth.Width;
    const int height = this->Truth.Height;
    std::vector<bool> missing(this->Pixels);
    std::vector<bool> nearOutline(this->Pixels);
    const MesoOutline outline(this->InTruth, width, height);
    double both = 0.;
    double either = 0.;
    for (std::size_t pixel = 0; pixel < this->Pixels; ++pixel)
    {
      constexpr double Near = 2.;
      missing[pixel] = this->InTruth[pixel] && !this->InTest[pixel];
      nearOutline[pixel] = outline.DistanceOfPixel(static_cast<int>(pixel % width),
                             static_cast<int>(pixel / width)) <= Near;
      both += this->InTruth[pixel] && this->InTest[pixel] ? 1. : 0.;
      either += this->Error.Counts[pixel] ? 1. : 0.;
    }
    this->Error.CoverageIou = either > 0. ? both / either : 1.;
    const MesoOutline::Distance distance =
      MesoOutline::Between(outline, MesoOutline(this->InTest, width, height));
    this->Error.SilhouetteMean = distance.Mean;
    this->Error.SilhouetteMaximum = distance.Maximum;
    std::vector<bool> holes;
    this->Error.HolePixels = MesoCountUnreached(missing, nearOutline, width, height, &holes);
    for (std::size_t pixel = 0; pixel < this->Pixels; ++pixel)
    {
      if (holes[pixel] && this->Error.Classes[pixel] == MesoPixelClass::Missing)
      {
        this->Error.Classes[pixel] = MesoPixelClass::Hole;
      }
    }
  }

  /// A pixel that both cover.
  void ComparePixel(std::size_t pixel)
  {
    MesoPixelClass kind = MesoPixelClass::Equal;
    const int number =
      this->Truth.Object.empty() ? 0 : static_cast<int>(std::lround(this->Truth.Object[pixel]));
    const auto found = this->Truth.Objects.find(number);
    const MesoAOVObject object =
      found == this->Truth.Objects.end() ? MesoAOVObject() : found->second;
    const bool sameObject = this->Truth.Object.empty() ||
      std::lround(this->Test.Object[pixel]) == std::lround(this->Truth.Object[pixel]);

    if (this->CompareShadows(pixel))
    {
      kind = MesoPixelClass::ShadowDiffers;
    }
    if (!this->Truth.Depth.empty())
    {
      const double difference = double(this->Test.Depth[pixel]) - this->Truth.Depth[pixel];
      const double unit = object.Scale > 0. ? object.Scale : 1.;
      this->Depths[number].Add(std::abs(difference) / unit, pixel);
      const double tolerance =
        0.01 * (object.Scale > 0. ? object.Scale : std::abs(double(this->Truth.Depth[pixel])));
      if (std::abs(difference) > tolerance)
      {
        kind = difference < 0. ? MesoPixelClass::Nearer : MesoPixelClass::Farther;
      }
    }
    if (!sameObject)
    {
      ++this->Error.OtherObjectPixels;
      kind = MesoPixelClass::OtherObject;
    }
    else if (!this->Truth.Texcoord[0].empty() && object.MapWidth > 0 && object.MapHeight > 0)
    {
      this->Texcoords[number].Add(std::hypot(this->TexelsApart(0, pixel, object.MapWidth),
                                    this->TexelsApart(1, pixel, object.MapHeight)),
        pixel);
    }
    if (!this->Truth.Normal[0].empty())
    {
      this->CompareNormals(pixel);
    }
    this->Error.Classes[pixel] = kind;
  }

  double TexelsApart(int axis, std::size_t pixel, int texels) const
  {
    const double tiles =
      double(this->Test.Texcoord[axis][pixel]) - double(this->Truth.Texcoord[axis][pixel]);
    return texels * std::abs(tiles - std::round(tiles));
  }

  static Vector NormalAt(const MesoAOVs& aovs, std::size_t pixel)
  {
    return { aovs.Normal[0][pixel], aovs.Normal[1][pixel], aovs.Normal[2][pixel] };
  }

  void CompareNormals(std::size_t pixel)
  {
    const Vector a = NormalAt(this->Truth, pixel);
    const Vector b = NormalAt(this->Test, pixel);
    if (Dot(a, a) == 0.)
    {
      return;
    }
    constexpr double DegreesPerRadian = 180. / 3.14159265358979323846;
    const Vector cross = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
    this->Normals.Add(Dot(b, b) == 0.
        ? 180.
        : DegreesPerRadian * std::atan2(std::sqrt(Dot(cross, cross)), Dot(a, b)),
      pixel);
  }

  /// True where the state of any light's shadow differs.
  bool CompareShadows(std::size_t pixel)
  {
    bool differs = false;
    for (std::size_t light = 0; light < this->Truth.Shadows.size(); ++light)
    {
      const bool wrong =
        (this->Truth.Shadows[light][pixel] >= 0.5f) != (this->Test.Shadows[light][pixel] >= 0.5f);
      differs = differs || wrong;
      if (this->KnowsLights())
      {
        const bool attached = this->FacesAway(pixel, this->Truth.Lights[light]);
        ++(attached ? this->AttachedPixels : this->CastPixels);
        (attached ? this->AttachedWrong : this->CastWrong) += wrong ? 1 : 0;
      }
    }
    return differs;
  }

  bool KnowsLights() const
  {
    return !this->Truth.Lights.empty() && this->Truth.Camera && !this->Truth.Depth.empty() &&
      !this->Truth.Normal[0].empty();
  }

  bool FacesAway(std::size_t pixel, const MesoAOVLight& light) const
  {
    Vector towards = light.Place;
    if (light.Positional)
    {
      const Vector point = this->Truth.PointAt(pixel);
      towards = { towards[0] - point[0], towards[1] - point[1], towards[2] - point[2] };
    }
    return Dot(NormalAt(this->Truth, pixel), towards) <= 0.;
  }

  void Summarise()
  {
    Sample inScale;
    Sample inWorldUnits;
    Sample texcoords;
    for (const auto& depths : this->Depths)
    {
      const auto found = this->Truth.Objects.find(depths.first);
      MesoObjectError object;
      object.Number = depths.first;
      if (found != this->Truth.Objects.end())
      {
        object.Name = found->second.Name;
        object.DepthInScale = found->second.Scale > 0.;
      }
      object.Depth = depths.second.Spread();
      object.Texcoord = this->Texcoords[depths.first].Spread();
      this->Error.Objects.push_back(object);
      (object.DepthInScale ? inScale : inWorldUnits).Add(depths.second);
    }
    for (const auto& part : this->Texcoords)
    {
      texcoords.Add(part.second);
    }
    this->Error.DepthInScale = !inScale.Errors.empty();
    this->Error.Depth = (this->Error.DepthInScale ? inScale : inWorldUnits).Spread();
    this->Error.Texcoord = texcoords.Spread();
    this->Error.Normal = this->Normals.Spread();
    const auto part = [](std::size_t wrong, std::size_t all)
    { return all == 0 ? 0. : double(wrong) / double(all); };
    if (this->KnowsLights())
    {
      this->Error.ShadowAttached = part(this->AttachedWrong, this->AttachedPixels);
      this->Error.ShadowCast = part(this->CastWrong, this->CastPixels);
    }
  }

  const MesoAOVs& Truth;
  const MesoAOVs& Test;
  std::size_t Pixels;
  std::vector<bool> InTruth; ///< covered, and not of class `boundary`
  std::vector<bool> InTest;
  std::map<int, Sample> Depths; ///< by the truth's object
  std::map<int, Sample> Texcoords;
  Sample Normals;
  std::size_t AttachedPixels = 0;
  std::size_t AttachedWrong = 0;
  std::size_t CastPixels = 0;
  std::size_t CastWrong = 0;
  MesoGeometryError Error;
};
}

MesoGeometryError MesoCompareGeometry(const MesoAOVs& truth, const MesoAOVs& test)
{
  return Comparison(truth, test).Run();
}

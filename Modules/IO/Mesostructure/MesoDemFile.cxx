#include "MesoDemFile.h"

#include "MesoImageFile.h" // for limits
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::size_t RecordBytes = 1024;
constexpr double Foot = 0.3048;
constexpr double EarthRadius = 6371008.8;
constexpr double Pi = 3.14159265358979323846;
constexpr std::int64_t Void = -32767;
constexpr std::int64_t OldVoid = -9999;

class Scanner
{
public:
  Scanner(const std::string& bytes, const std::string& fileName)
    : Bytes(bytes)
    , FileName(fileName)
  {
  }

  MesoDem Scan()
  {
    if (this->Bytes.size() < 2 * RecordBytes)
    {
      this->Fail(this->Bytes.size(), "the file ends within its first two records");
    }
    this->Dem.Title = MesoPrintable(this->Trimmed(0, 40));
    this->ScanRecordA();
    std::size_t position = RecordBytes;
    for (std::int64_t i = 0; i < this->Profiles; ++i)
    {
      position = this->ScanProfile(position, i);
    }
    this->MakeGrid();
    return std::move(this->Dem);
  }

private:
  struct Profile
  {
    double X;
    double Y;
    std::vector<double> Elevations; ///< not a number where void
  };

  [[noreturn]] void Fail(std::size_t position, const std::string& reason) const
  {
    throw MesoInputError(
      this->FileName + ": byte " + std::to_string(position) + ": " + MesoPrintable(reason));
  }

  std::string Trimmed(std::size_t position, std::size_t length) const
  {
    const std::string text = this->Bytes.substr(position, length);
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? ""
                                      : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
  }

  /// A field of fixed width; an exponent may be marked with D, as in Fortran.
  double Number(std::size_t position, std::size_t length, const char* what) const
  {
    std::string text = this->Trimmed(position, length);
    std::replace(text.begin(), text.end(), 'D', 'E');
    double number = 0.;
    const std::string problem = MesoReadNumber(text, number);
    if (!problem.empty())
    {
      this->Fail(position, std::string(what) + ": " + problem);
    }
    return number;
  }

  std::int64_t Integer(std::size_t position, std::size_t length, const char* what) const
  {
    std::int64_t number = 0;
    const std::string problem = MesoReadInteger(this->Trimmed(position, length), number);
    if (!problem.empty())
    {
      this->Fail(position, std::string(what) + ": " + problem);
    }
    return number;
  }

  void ScanRecordA()
  {
    const std::int64_t groundUnit = this->Integer(528, 6, "unit of the ground");
    const std::int64_t elevationUnit = this->Integer(534, 6, "unit of elevation");
    if (groundUnit < 0 || groundUnit > 3)
    {
      this->Fail(528, "unit of the ground " + std::to_string(groundUnit) + " is none of 0 to 3");
    }
    if (elevationUnit != 1 && elevationUnit != 2)
    {
      this->Fail(534, "unit of elevation " + std::to_string(elevationUnit) + " is neither 1 nor 2");
    }
    double south = std::numeric_limits<double>::max();
    double north = std::numeric_limits<double>::lowest();
    for (int corner = 0; corner < 4; ++corner)
    {
      const double y = this->Number(546 + 24 + std::size_t(corner) * 48, 24, "corner");
      south = std::min(south, y);
      north = std::max(north, y);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Resolution[k] = this->Number(816 + 12 * k, 12, "resolution");
      if (!(this->Resolution[k] > 0.))
      {
        this->Fail(816 + 12 * k, "a resolution must be more than 0");
      }
    }
    this->Resolution[2] *= elevationUnit == 1 ? Foot : 1.;
    this->Profiles = this->Integer(858, 6, "number of profiles");
    if (this->Profiles < 1 || this->Profiles > MesoImageLargestSide)
    {
      this->Fail(858,
        std::to_string(this->Profiles) + " profiles are none, or over the limit of " +
          std::to_string(MesoImageLargestSide));
    }
    if (groundUnit == 1 || groundUnit == 2)
    {
      const double metres = groundUnit == 1 ? Foot : 1.;
      this->Dem.Spacing = { this->Resolution[0] * metres, this->Resolution[1] * metres };
      return;
    }
    const double radians = groundUnit == 0 ? 1. : Pi / 648000.;
    const double latitude = 0.5 * (south + north) * radians;
    this->Dem.Spacing = { this->Resolution[0] * radians * EarthRadius * std::cos(latitude),
      this->Resolution[1] * radians * EarthRadius };
    this->Dem.Notes.push_back("the ground is measured in angles; samples lie " +
      MesoNumberText(this->Dem.Spacing[0]) + " x " + MesoNumberText(this->Dem.Spacing[1]) +
      " m apart at the middle latitude");
    if (!(this->Dem.Spacing[0] > 0.))
    {
      this->Fail(546, "the corners lie beyond the pole");
    }
  }

  std::size_t ScanProfile(std::size_t position, std::int64_t number)
  {
    constexpr std::size_t headBytes = 144;
    constexpr std::size_t elevationBytes = 6;
    const std::string name = "profile " + std::to_string(number);
    if (this->Bytes.size() < position + headBytes)
    {
      this->Fail(this->Bytes.size(),
        "the file ends before " + name + " of " + std::to_string(this->Profiles));
    }
    const std::int64_t count = this->Integer(position + 12, 6, name.c_str());
    if (count < 0 || count > MesoImageLargestSide)
    {
      this->Fail(position + 12,
        name + ": " + std::to_string(count) + " elevations are none, or over the limit of " +
          std::to_string(MesoImageLargestSide));
    }
    Profile profile;
    profile.X = this->Number(position + 24, 24, name.c_str());
    profile.Y = this->Number(position + 48, 24, name.c_str());
    const double datum = this->Number(position + 72, 24, name.c_str());
    std::size_t field = position + headBytes;
    std::size_t recordEnd = position + RecordBytes;
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (field + elevationBytes > recordEnd)
      {
        field = recordEnd; // what is left of a record holds no elevation
        recordEnd += RecordBytes;
      }
      if (field + elevationBytes > this->Bytes.size())
      {
        this->Fail(this->Bytes.size(),
          "the file ends at elevation " + std::to_string(i) + " of " + std::to_string(count) +
            " of " + name);
      }
      const std::int64_t stored = this->Integer(field, elevationBytes, name.c_str());
      profile.Elevations.push_back(stored == Void || stored == OldVoid
          ? std::numeric_limits<double>::quiet_NaN()
          : stored * this->Resolution[2] + datum);
      field += elevationBytes;
    }
    this->Read.push_back(std::move(profile));
    return std::min(recordEnd, this->Bytes.size());
  }

  void MakeGrid()
  {
    double south = std::numeric_limits<double>::max();
    double north = std::numeric_limits<double>::lowest();
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();
    for (const Profile& profile : this->Read)
    {
      if (profile.Elevations.empty())
      {
        continue;
      }
      south = std::min(south, profile.Y);
      north =
        std::max(north, profile.Y + double(profile.Elevations.size() - 1) * this->Resolution[1]);
      for (double elevation : profile.Elevations)
      {
        least = std::isnan(elevation) ? least : std::min(least, elevation);
        most = std::isnan(elevation) ? most : std::max(most, elevation);
      }
    }
    const double rows = std::round((north - south) / this->Resolution[1]) + 1.;
    if (!(least <= most))
    {
      this->Fail(RecordBytes, "no profile has an elevation");
    }
    if (!(rows >= 1.) || rows > MesoImageLargestSide)
    {
      this->Fail(RecordBytes,
        "the profiles span " + MesoNumberText(rows) + " rows, over the limit of " +
          std::to_string(MesoImageLargestSide));
    }
    this->Dem.Width = static_cast<int>(this->Profiles);
    this->Dem.Height = static_cast<int>(rows);
    this->Dem.Range = { least, most };
    const std::size_t size = std::size_t(this->Dem.Width) * std::size_t(this->Dem.Height);
    this->Dem.Elevations.assign(size, static_cast<float>(least));
    std::size_t known = 0;
    for (std::size_t column = 0; column < this->Read.size(); ++column)
    {
      const Profile& profile = this->Read[column];
      const auto first =
        static_cast<std::size_t>(std::llround((profile.Y - south) / this->Resolution[1]));
      for (std::size_t i = 0; i < profile.Elevations.size() && first + i < std::size_t(rows); ++i)
      {
        if (!std::isnan(profile.Elevations[i]))
        {
          this->Dem.Elevations[(first + i) * std::size_t(this->Dem.Width) + column] =
            static_cast<float>(profile.Elevations[i]);
          ++known;
        }
      }
    }
    if (known < size)
    {
      this->Dem.Notes.push_back(std::to_string(size - known) + " of " + std::to_string(size) +
        " places have no elevation and get the lowest");
    }
  }

  const std::string& Bytes;
  const std::string& FileName;
  std::array<double, 3> Resolution = { 1., 1., 1. };
  std::int64_t Profiles = 0;
  std::vector<Profile> Read;
  MesoDem Dem;
};
}

MesoDem MesoParseDem(const std::string& bytes, const std::string& fileName)
{
  return Scanner(bytes, fileName).Scan();
}

#include "MesoImageReport.h"

#include "MesoImageFile.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace
{
/// Values of an image of any type, row 0 at the top.
class Pixels
{
public:
  explicit Pixels(MesoImageInput& input)
    : Header(input.Header())
    , Bytes(Header.NumberOfValues() * Header.BytesPerValue())
  {
    input.Read(this->Bytes.data(), MesoImageInput::RowOrder::TopFirst);
  }

  double Value(int column, int row, std::size_t channel) const
  {
    const std::size_t i =
      (std::size_t(row) * this->Header.Width + column) * this->Header.ChannelNames.size() + channel;
    switch (this->Header.ValueType)
    {
      case MesoImageHeader::Type::UnsignedChar:
        return reinterpret_cast<const std::uint8_t*>(this->Bytes.data())[i];
      case MesoImageHeader::Type::UnsignedShort:
        return reinterpret_cast<const std::uint16_t*>(this->Bytes.data())[i];
      case MesoImageHeader::Type::Float:
        return reinterpret_cast<const float*>(this->Bytes.data())[i];
    }
    return 0.;
  }

private:
  const MesoImageHeader& Header;
  std::vector<char> Bytes;
};

MesoChannelReport ReportChannel(
  const Pixels& pixels, const MesoImageHeader& header, std::size_t channel)
{
  MesoChannelReport report;
  report.Name = header.ChannelNames[channel];
  double sum = 0.;
  std::size_t finite = 0;
  for (int row = 0; row < header.Height; ++row)
  {
    for (int column = 0; column < header.Width; ++column)
    {
      const double value = pixels.Value(column, row, channel);
      if (!std::isfinite(value))
      {
        ++report.NotFinite;
        continue;
      }
      report.Least = finite == 0 ? value : std::min(report.Least, value);
      report.Most = finite == 0 ? value : std::max(report.Most, value);
      sum += value;
      ++finite;
    }
  }
  report.Mean = finite == 0 ? 0. : sum / double(finite);
  return report;
}

/// Steps of the first channel along rows (`isRow`) or columns.
MesoTilingReport ReportTiling(const Pixels& pixels, const MesoImageHeader& header, bool isRow)
{
  const int length = isRow ? header.Width : header.Height;
  const int lines = isRow ? header.Height : header.Width;
  double sums[2] = { 0., 0. };
  std::size_t counts[2] = { 0, 0 };
  for (int line = 0; line < lines; ++line)
  {
    const auto value = [&](int i)
    { return isRow ? pixels.Value(i, line, 0) : pixels.Value(line, i, 0); };
    for (int i = 0; i < length && length > 1; ++i)
    {
      const bool isBorder = i + 1 == length;
      const double step = std::abs(value(isBorder ? 0 : i + 1) - value(i));
      if (std::isfinite(step))
      {
        sums[isBorder ? 1 : 0] += step;
        ++counts[isBorder ? 1 : 0];
      }
    }
  }
  MesoTilingReport report;
  report.Inside = counts[0] == 0 ? 0. : sums[0] / double(counts[0]);
  report.AcrossBorder = counts[1] == 0 ? 0. : sums[1] / double(counts[1]);
  return report;
}
}

double MesoTilingReport::Ratio() const
{
  return this->AcrossBorder == 0. ? 0.
    : this->Inside == 0.          ? std::numeric_limits<double>::infinity()
                                  : this->AcrossBorder / this->Inside;
}

const char* MesoTilingReport::Verdict() const
{
  constexpr double mostOfYes = 1.75; // a wave that tiles has pi / 2 where it is steepest
  constexpr double mostOfNearly = 3.5;
  const double ratio = this->Ratio();
  return ratio <= mostOfYes ? "yes" : ratio <= mostOfNearly ? "nearly" : "no";
}

MesoImageReport MesoReportImage(const std::string& fileName)
{
  MesoImageInput input(fileName);
  const MesoImageHeader& header = input.Header();
  const Pixels pixels(input);
  MesoImageReport report;
  report.Width = header.Width;
  report.Height = header.Height;
  report.Format = header.Format;
  report.StoredType = header.StoredType;
  for (std::size_t channel = 0; channel < header.ChannelNames.size(); ++channel)
  {
    report.Channels.push_back(ReportChannel(pixels, header, channel));
  }
  report.Tiling = { ReportTiling(pixels, header, true), ReportTiling(pixels, header, false) };
  report.HasColorProfile = header.HasColorProfile;
  report.Notes = header.Notes;
  return report;
}

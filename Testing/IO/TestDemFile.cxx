// Elevation files, made field by field after the standard, and what is refused in them.

#include "MesoDemFile.h"
#include "MessageOf.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
std::string Field(std::size_t width, const std::string& text)
{
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string Real(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%24.15E", value);
  std::string field = text;
  field[field.find('E')] = 'D';
  return field;
}

std::string Padded(std::string record, std::size_t size)
{
  record.resize((record.size() + size - 1) / size * size, ' ');
  return record;
}

struct Units
{
  int Ground = 2;
  int Elevation = 2;
  double Resolution = 30.;
  double Latitude = 0.;
};

std::string RecordA(int profiles, const Units& units)
{
  std::string record = "A HILL";
  record.resize(528, ' ');
  record += Field(6, std::to_string(units.Ground)) + Field(6, std::to_string(units.Elevation)) +
    Field(6, "4");
  for (int corner = 0; corner < 4; ++corner)
  {
    record += Real(0.) + Real(units.Latitude);
  }
  record += Real(0.) + Real(0.) + Real(0.) + Field(6, "1");
  char resolution[40];
  std::snprintf(
    resolution, sizeof(resolution), "%12.6E%12.6E%12.6E", units.Resolution, units.Resolution, 1.);
  record += resolution + Field(6, "1") + Field(6, std::to_string(profiles));
  return Padded(record, 1024);
}

std::string Profile(int number, double y, const std::vector<int>& elevations)
{
  std::string record = Field(6, "1") + Field(6, std::to_string(number)) +
    Field(6, std::to_string(elevations.size())) + Field(6, "1") + Real(30. * number) + Real(y) +
    Real(0.) + Real(0.) + Real(0.);
  std::size_t end = 1024;
  for (int elevation : elevations)
  {
    if (record.size() + 6 > end)
    {
      record.resize(end, ' ');
      end += 1024;
    }
    record += Field(6, std::to_string(elevation));
  }
  return Padded(record, 1024);
}

std::string Refusal(const std::string& bytes)
{
  return MessageOf([&] { MesoParseDem(bytes, "m.dem"); });
}
}

TEST(DemFile, ReadsProfilesFromTheSouth)
{
  const auto dem = MesoParseDem(
    RecordA(2, {}) + Profile(1, 300., { 10, 20, 30 }) + Profile(2, 330., { 40, 50 }), "m.dem");
  EXPECT_EQ(dem.Title, "A HILL");
  ASSERT_EQ(dem.Width, 2);
  ASSERT_EQ(dem.Height, 3);
  EXPECT_EQ(dem.Elevations, (std::vector<float>{ 10, 10, 20, 40, 30, 50 }));
  EXPECT_EQ(dem.Spacing, (std::array<double, 2>{ 30., 30. }));
  EXPECT_EQ(dem.Range, (std::array<double, 2>{ 10., 50. }));
  EXPECT_EQ(
    dem.Notes, std::vector<std::string>{ "1 of 6 places have no elevation and get the lowest" });
}

TEST(DemFile, ReadsProfilesOfSeveralRecords)
{
  std::vector<int> elevations;
  for (int i = 0; i < 400; ++i) // 146 in the first record, 170 in each further one
  {
    elevations.push_back(i);
  }
  const auto dem =
    MesoParseDem(RecordA(2, {}) + Profile(1, 0., elevations) + Profile(2, 0., elevations), "m.dem");
  ASSERT_EQ(dem.Height, 400);
  for (int i = 0; i < 400; ++i)
  {
    EXPECT_EQ(dem.Elevations[2 * i + 1], i);
  }
  EXPECT_TRUE(dem.Notes.empty());
}

TEST(DemFile, BringsUnitsToMetres)
{
  Units feet;
  feet.Elevation = 1;
  feet.Ground = 1;
  const auto dem = MesoParseDem(RecordA(1, feet) + Profile(1, 0., { 0, 1000 }), "m.dem");
  EXPECT_NEAR(dem.Range[1], 304.8, 1e-9);
  EXPECT_NEAR(dem.Spacing[0], 9.144, 1e-9);

  Units angle;
  angle.Ground = 3;
  angle.Resolution = 3.;
  angle.Latitude = 60. * 3600.;
  const auto arc = MesoParseDem(RecordA(1, angle) + Profile(1, 0., { 0, 5 }), "m.dem");
  EXPECT_NEAR(arc.Spacing[1], 92.6624, 0.001);
  EXPECT_NEAR(arc.Spacing[0], 0.5 * arc.Spacing[1], 1e-6);
  EXPECT_EQ(arc.Notes.size(), 1u);
}

TEST(DemFile, VoidsAreNoElevations)
{
  const auto dem = MesoParseDem(RecordA(1, {}) + Profile(1, 0., { 5, -32767, 7 }), "m.dem");
  EXPECT_EQ(dem.Range[0], 5.);
  EXPECT_EQ(dem.Elevations[1], 5.f);
  EXPECT_EQ(dem.Notes.size(), 1u);
}

TEST(DemFile, RefusesBadFiles)
{
  const std::string whole = RecordA(2, {}) + Profile(1, 0., { 1, 2 }) + Profile(2, 0., { 3, 4 });
  EXPECT_EQ(Refusal("junk"), "m.dem: byte 4: the file ends within its first two records");
  EXPECT_EQ(Refusal(std::string(4096, 'x')),
    "m.dem: byte 528: unit of the ground: \"xxxxxx\" is not a whole number");
  EXPECT_EQ(
    Refusal(whole.substr(0, 2048)), "m.dem: byte 2048: the file ends before profile 1 of 2");
  EXPECT_EQ(Refusal(whole.substr(0, 2048 + 150)),
    "m.dem: byte 2198: the file ends at elevation 1 of 2 of profile 1");
  std::string bad = whole;
  bad.replace(1024 + 12, 6, "999999");
  EXPECT_EQ(Refusal(bad),
    "m.dem: byte 1036: profile 0: 999999 elevations are none, or over the "
    "limit of 16384");
  bad = whole;
  bad.replace(816, 12, "0.000000E+00");
  EXPECT_EQ(Refusal(bad), "m.dem: byte 816: a resolution must be more than 0");
  EXPECT_EQ(
    Refusal(RecordA(1, {}) + Profile(1, 0., {})), "m.dem: byte 1024: no profile has an elevation");
  EXPECT_EQ(Refusal(RecordA(2, {}) + Profile(1, 0., { 1 }) + Profile(2, 1e9, { 1 }))
              .find("m.dem: byte 1024: the profiles span "),
    0u);
}

#include "MesoSceneValue.h"

#include "MesoFileBytes.h"
#include "MesoMessage.h"

#include <algorithm>
#include <filesystem>

namespace
{
using Kind = MesoJsonValue::Kind;

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

bool Contains(const std::vector<std::string>& words, const std::string& word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string RangeText(const MesoSceneRange& range)
{
  if (range.Maximum == MesoSceneLargest)
  {
    if (range.Minimum == 0.)
    {
      return range.WithEnds ? "0 or more" : "more than 0";
    }
    if (range.Minimum > -MesoSceneLargest)
    {
      return MesoNumberText(range.Minimum) + " or more";
    }
  }
  return (range.WithEnds ? "in [" : "in (") + MesoNumberText(range.Minimum) + ", " +
    MesoNumberText(range.Maximum) + (range.WithEnds ? "]" : ")");
}
}

void MesoSceneValue::Fail(const std::string& reason) const
{
  const std::string place = this->Place.empty() ? "" : this->Place + ": ";
  throw MesoInputError(this->Source->FileName + ": " + place + reason);
}

void MesoSceneValue::FailType(const char* wanted) const
{
  this->Fail(std::string("must be ") + wanted + ", is " + this->Value->TypeName());
}

bool MesoSceneValue::ToBoolean() const
{
  if (this->Value->Type != Kind::Boolean)
  {
    this->FailType("true or false");
  }
  return this->Value->Boolean;
}

double MesoSceneValue::ToNumber(const MesoSceneRange& range) const
{
  if (!this->IsNumber())
  {
    this->FailType("a number");
  }
  const double number = this->Value->Number;
  const bool inside = range.WithEnds ? number >= range.Minimum && number <= range.Maximum
                                     : number > range.Minimum && number < range.Maximum;
  // The largest number ends a range that has no end of its own.
  if (std::abs(number) > MesoSceneLargest)
  {
    this->Fail(
      "must not be beyond " + MesoNumberText(MesoSceneLargest) + ", is " + MesoNumberText(number));
  }
  if (!inside)
  {
    this->Fail("must be " + RangeText(range) + ", is " + MesoNumberText(number));
  }
  return number;
}

double MesoSceneValue::ToInteger(const MesoSceneRange& range) const
{
  const double number = this->ToNumber(range);
  if (number != std::floor(number))
  {
    this->Fail("must be a whole number, is " + MesoNumberText(number));
  }
  return number;
}

std::string MesoSceneValue::ToText() const
{
  if (!this->IsString())
  {
    this->FailType("a string");
  }
  const std::string& text = this->Value->Text;
  if (text.empty())
  {
    this->Fail("must not be empty");
  }
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
  {
    this->Fail("must not hold control characters");
  }
  return text;
}

std::string MesoSceneValue::ToFileName() const
{
  namespace fs = std::filesystem;
  const fs::path given = this->ToText();
  const fs::path resolved = fs::path(this->Source->FileName).parent_path() / given;
  const std::string reason = this->Source->FilesMustExist ? MesoWhyNoFile(resolved.string()) : "";
  if (!reason.empty())
  {
    this->Fail("\"" + MesoPrintable(resolved.string()) + "\": " + reason);
  }
  return resolved.string();
}

std::vector<MesoSceneValue> MesoSceneValue::ToList(std::size_t count) const
{
  const std::string wanted =
    count == 0 ? std::string("a list") : "a list of " + std::to_string(count);
  if (this->Value->Type != Kind::Array)
  {
    this->FailType(wanted.c_str());
  }
  const auto& elements = this->Value->Elements;
  if (count != 0 && elements.size() != count)
  {
    this->Fail("must be " + wanted + ", has " + std::to_string(elements.size()));
  }
  std::vector<MesoSceneValue> list;
  list.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    list.emplace_back(elements[i], this->Place + "[" + std::to_string(i) + "]", *this->Source);
  }
  return list;
}

std::size_t MesoSceneValue::ToCount() const
{
  if (this->Value->Type != Kind::Array)
  {
    this->FailType("a list");
  }
  return this->Value->Elements.size();
}

MesoSceneValue MesoSceneValue::ElementAt(std::size_t number) const
{
  return MesoSceneValue(
    this->Value->Elements[number], this->Place + "[" + std::to_string(number) + "]", *this->Source);
}

MesoVector3 MesoSceneValue::ToDirection() const
{
  MesoVector3 direction = this->ToNumbers<3>();
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (length < std::numeric_limits<double>::min())
  {
    this->Fail("must have a direction, is 0");
  }
  for (double& component : direction)
  {
    component /= length;
  }
  return direction;
}

void MesoSceneValue::FailChoice(const std::string& kind, const std::string& word,
  const std::vector<std::string>& names, const std::vector<std::string>& later) const
{
  const std::string quoted = "\"" + MesoPrintable(word) + "\"";
  const std::string choices = "choices: " + Join(names);
  if (Contains(later, word))
  {
    this->Fail(kind + " " + quoted + " is not available yet (" + choices + ")");
  }
  const std::string nearest = MesoNearestWord(word, names);
  this->Fail("there is no " + kind + " " + quoted + " (" +
    (nearest.empty() ? "" : "did you mean " + nearest + "? ") + choices + ")");
}

std::string MesoSceneValue::PlaceOf(const std::string& key) const
{
  return (this->Place.empty() ? "" : this->Place + ".") + MesoPrintable(key);
}

void MesoSceneValue::CheckKeys(const std::string& object) const
{
  if (this->Value->Type != Kind::Object)
  {
    this->FailType("an object");
  }
  const MesoSceneKeyGroup& group = MesoSceneKeysOf(object);
  for (std::size_t i = 0; i < this->Value->Keys.size(); ++i)
  {
    const std::string& key = this->Value->Keys[i];
    if (Contains(group.Served, key))
    {
      continue;
    }
    const MesoSceneValue at(this->Value->Elements[i], this->PlaceOf(key), *this->Source);
    if (Contains(group.Later, key))
    {
      at.Fail("is not available yet");
    }
    std::vector<std::string> known = group.Served;
    known.insert(known.end(), group.Later.begin(), group.Later.end());
    const std::string nearest = MesoNearestWord(key, known);
    if (!nearest.empty())
    {
      at.Fail("unknown key (did you mean " + nearest + "?)");
    }
    for (const MesoSceneKeyGroup& other : MesoSceneKeyTable())
    {
      if (Contains(other.Served, key) || Contains(other.Later, key))
      {
        at.Fail("unknown key here (it is one of " + other.Object + ")");
      }
    }
    at.Fail("unknown key (there are: " + Join(group.Served) + ")");
  }
}

bool MesoSceneValue::Has(const std::string& key) const
{
  return this->Value->Find(key) != nullptr;
}

MesoSceneValue MesoSceneValue::At(const std::string& key) const
{
  const MesoJsonValue* value = this->Value->Find(key);
  if (!value)
  {
    this->Fail(key + " is missing");
  }
  return MesoSceneValue(*value, this->PlaceOf(key), *this->Source);
}

void MesoSceneValue::With(
  const std::string& key, const std::function<void(const MesoSceneValue&)>& read) const
{
  if (this->Has(key))
  {
    read(this->At(key));
  }
}

void MesoSceneValue::Refuse(const std::vector<std::string>& keys, const std::string& reason) const
{
  for (const std::string& key : keys)
  {
    if (this->Has(key))
    {
      this->At(key).Fail(reason);
    }
  }
}

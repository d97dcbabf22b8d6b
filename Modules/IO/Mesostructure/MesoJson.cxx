#include "MesoJson.h"

#include "MesoScene.h" // for MesoInputError

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_set>

namespace
{
/// Builds the tree from the parser's events, which show what a finished tree no longer tells.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json>
{
public:
  TreeBuilder(const std::string& text, const std::string& fileName)
    : Source(text)
    , FileName(fileName)
  {
  }

  MesoJsonValue Root;

  bool null() override
  {
    this->Add({});
    return true;
  }

  bool boolean(bool value) override
  {
    MesoJsonValue leaf;
    leaf.Type = MesoJsonValue::Kind::Boolean;
    leaf.Boolean = value;
    this->Add(std::move(leaf));
    return true;
  }

  bool number_integer(number_integer_t value) override
  {
    this->AddNumber(static_cast<double>(value));
    return true;
  }

  bool number_unsigned(number_unsigned_t value) override
  {
    this->AddNumber(static_cast<double>(value));
    return true;
  }

  bool number_float(number_float_t value, const string_t&) override
  {
    this->AddNumber(value);
    return true;
  }

  bool string(string_t& value) override
  {
    MesoJsonValue leaf;
    leaf.Type = MesoJsonValue::Kind::String;
    leaf.Text = value;
    this->Add(std::move(leaf));
    return true;
  }

  bool binary(binary_t&) override { return false; } // JSON text has none

  bool start_object(std::size_t) override
  {
    this->Open(MesoJsonValue::Kind::Object);
    return true;
  }

  bool start_array(std::size_t) override
  {
    this->Open(MesoJsonValue::Kind::Array);
    return true;
  }

  bool end_object() override
  {
    this->Levels.pop_back();
    return true;
  }

  bool end_array() override
  {
    this->Levels.pop_back();
    return true;
  }

  bool key(string_t& name) override
  {
    Level& level = this->Levels.back();
    const bool isNew = level.Seen.insert(name).second;
    level.Value->Keys.push_back(name);
    if (!isNew)
    {
      this->Fail("key given twice");
    }
    return true;
  }

  bool parse_error(
    std::size_t position, const std::string&, const nlohmann::detail::exception& error) override
  {
    std::string reason = error.what();
    const std::size_t tag = reason.find("] ");
    reason = tag == std::string::npos ? reason : reason.substr(tag + 2);
    const std::string prefix = "parse error at ";
    if (reason.compare(0, prefix.size(), prefix) == 0)
    {
      reason = reason.substr(prefix.size());
    }
    else
    {
      reason = this->LineAndColumn(position) + ": " + reason;
    }
    throw MesoInputError(this->FileName + ": " + MesoPrintable(reason));
  }

private:
  struct Level
  {
    MesoJsonValue* Value;
    std::unordered_set<std::string> Seen;
  };

  void AddNumber(double value)
  {
    MesoJsonValue leaf;
    leaf.Type = MesoJsonValue::Kind::Number;
    leaf.Number = value;
    this->Add(std::move(leaf));
    if (!std::isfinite(value))
    {
      this->Fail("number too large");
    }
  }

  MesoJsonValue& Add(MesoJsonValue&& value)
  {
    if (this->Levels.empty())
    {
      this->Root = std::move(value);
      return this->Root;
    }
    auto& elements = this->Levels.back().Value->Elements;
    elements.push_back(std::move(value));
    return elements.back();
  }

  void Open(MesoJsonValue::Kind kind)
  {
    MesoJsonValue value;
    value.Type = kind;
    MesoJsonValue& added = this->Add(std::move(value));
    if (this->Levels.size() == MesoJsonMaximumDepth)
    {
      this->Fail("nested deeper than " + std::to_string(MesoJsonMaximumDepth) + " levels");
    }
    // Only the deepest open value grows, so the pointers of the levels above stay good.
    this->Levels.push_back({ &added, {} });
  }

  [[noreturn]] void Fail(const std::string& reason) const
  {
    std::string place;
    for (const Level& level : this->Levels)
    {
      if (level.Value->Type == MesoJsonValue::Kind::Array)
      {
        place += "[" + std::to_string(level.Value->Elements.size() - 1) + "]";
      }
      else
      {
        place += (place.empty() ? "" : ".") + MesoPrintable(level.Value->Keys.back());
      }
    }
    throw MesoInputError(this->FileName + ": " + (place.empty() ? "" : place + ": ") + reason);
  }

  std::string LineAndColumn(std::size_t position) const
  {
    const auto end = this->Source.begin() + std::min(position, this->Source.size());
    const auto line = std::count(this->Source.begin(), end, '\n') + 1;
    const auto start = std::find(std::make_reverse_iterator(end), this->Source.rend(), '\n').base();
    return "line " + std::to_string(line) + ", column " + std::to_string(end - start);
  }

  const std::string& Source;
  const std::string& FileName;
  std::vector<Level> Levels;
};
}

const MesoJsonValue* MesoJsonValue::Find(const std::string& key) const
{
  const auto found = std::find(this->Keys.begin(), this->Keys.end(), key);
  return found == this->Keys.end() ? nullptr : &this->Elements[found - this->Keys.begin()];
}

const char* MesoJsonValue::TypeName() const
{
  switch (this->Type)
  {
    case Kind::Null:
      return "null";
    case Kind::Boolean:
      return "true or false";
    case Kind::Number:
      return "a number";
    case Kind::String:
      return "a string";
    case Kind::Array:
      return "a list";
    case Kind::Object:
      return "an object";
  }
  return "";
}

MesoJsonValue MesoParseJson(const std::string& text, const std::string& fileName)
{
  TreeBuilder builder(text, fileName);
  nlohmann::json::sax_parse(text, &builder);
  return std::move(builder.Root);
}

std::string MesoPrintable(const std::string& text)
{
  constexpr std::size_t longest = 160;
  std::string result = text.substr(0, longest);
  for (char& character : result)
  {
    if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f)
    {
      character = ' ';
    }
  }
  return text.size() > longest ? result + "..." : result;
}

std::string MesoNumberText(double value)
{
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
  return std::string(buffer, end);
}

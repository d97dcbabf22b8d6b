#include "CommandInfo.h"

#include "InfoJson.h"
#include "MesoFileBytes.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace
{
using Json = nlohmann::ordered_json;

std::string TextOf(const Json& value)
{
  if (value.is_string())
  {
    return value.get<std::string>();
  }
  if (value.is_boolean())
  {
    return value.get<bool>() ? "yes" : "no";
  }
  if (value.is_null())
  {
    return "not known";
  }
  if (value.is_number_float())
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.6g", value.get<double>());
    return text;
  }
  return value.dump();
}

bool IsListOfNumbers(const Json& value)
{
  return value.is_array() &&
    std::all_of(
      value.begin(), value.end(), [](const Json& element) { return element.is_number(); });
}

/// The same content as the JSON, a line a value; objects and lists are indented below their key.
void Print(const Json& object, const std::string& indent)
{
  for (const auto& [key, value] : object.items())
  {
    std::string name = object.is_array() ? "-" : key;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (IsListOfNumbers(value) && !value.empty())
    {
      std::cout << indent << name << ":";
      for (const Json& element : value)
      {
        std::cout << " " << TextOf(element);
      }
      std::cout << "\n";
    }
    else if (value.is_structured())
    {
      std::cout << indent << name << (value.empty() ? ": none\n" : ":\n");
      Print(value, indent + "  ");
    }
    else
    {
      std::cout << indent << name << (object.is_array() ? " " : ": ") << TextOf(value) << "\n";
    }
  }
}
}

CommandInfo::CommandInfo(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
    "info", "Tell what a mesh, image, baked table or scene holds, and what is wrong with it.");
  command
    ->add_option(
      "FILE", this->File, "Mesh, image, elevations (.dem), table (.vti) or scene (.json)")
    ->required();
  command->add_flag("--json", this->Json, "Print one JSON object of the same content");
  command->footer("Example: meso info pot.obj");
}

int CommandInfo::Run()
{
  MesoCheckIsFile(this->File);
  const ::Json report = JsonOfFile(this->File);
  if (this->Json)
  {
    // Names in files need not be UTF-8, which JSON must be.
    std::cout << report.dump(2, ' ', false, ::Json::error_handler_t::replace) << "\n";
  }
  else
  {
    Print(report, "");
  }
  return 0;
}

#include "MesoShaderLibrary.h"

#include "MesoShaderTable.h" // generated: MesoShaderTable, pairs of name and text

#ifndef NDEBUG
#include <cstdlib>
#include <fstream>
#include <sstream>
#endif

namespace
{
#ifndef NDEBUG
bool ReadFromDisk(const std::string& name, std::string& text)
{
  const char* folder = std::getenv("MESO_SHADER_DIR");
  if (!folder || !*folder)
  {
    return false;
  }
  std::ifstream file(std::string(folder) + "/" + name);
  std::ostringstream content;
  content << file.rdbuf();
  text = content.str();
  return static_cast<bool>(file);
}
#endif
}

std::string MesoShaderText(const std::string& name)
{
#ifndef NDEBUG
  std::string text;
  if (ReadFromDisk(name, text))
  {
    return text;
  }
#endif
  for (const auto& entry : MesoShaderTable)
  {
    if (name == entry.Name)
    {
      return entry.Text;
    }
  }
  return {};
}

std::vector<std::string> MesoShaderNames()
{
  std::vector<std::string> names;
  for (const auto& entry : MesoShaderTable)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

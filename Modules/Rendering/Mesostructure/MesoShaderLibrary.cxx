#include "MesoShaderLibrary.h"

#include "MesoShaderTable.h" // generated: MesoShaderTable, pairs of name and text

#include <cstdlib>
#include <fstream>
#include <sstream>

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

void MesoDumpShader(const char* stage, const std::string& text)
{
  const char* folder = std::getenv("MESO_DUMP_SHADERS");
  if (folder && *folder && !text.empty())
  {
    static int number = 0;
    std::ofstream(
      std::string(folder) + "/shader" + std::to_string(number++) + "." + stage + ".glsl")
      << text;
  }
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

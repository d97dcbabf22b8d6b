#include "MesoMeshFormats.h"

#include "MesoFileBytes.h"
#include "MesoGltfFile.h"
#include "MesoObjFile.h"
#include "MesoOffFile.h"
#include "MesoPlyFile.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoStlFile.h"
#include "MesoVtpFile.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace
{
using Parse = MesoMeshFile (*)(const std::string& bytes, const std::string& fileName);

const std::map<std::string, Parse>& Formats()
{
  static const std::map<std::string, Parse> formats = { { ".obj", &MesoParseObj },
    { ".ply", &MesoParsePly }, { ".stl", &MesoParseStl }, { ".off", &MesoParseOff },
    { ".vtp", &MesoParseVtp }, { ".gltf", &MesoParseGltf }, { ".glb", &MesoParseGltf } };
  return formats;
}
}

const std::vector<std::string>& MesoMeshExtensions()
{
  static const std::vector<std::string> extensions = { ".obj", ".ply", ".stl", ".off", ".vtp",
    ".gltf", ".glb" };
  return extensions;
}

std::string MesoExtensionOf(const std::string& fileName)
{
  const std::size_t dot = fileName.find_last_of("./");
  std::string extension =
    dot == std::string::npos || fileName[dot] == '/' ? "" : fileName.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

MesoMeshFile MesoReadMeshFile(const std::string& fileName)
{
  MesoCheckIsFile(fileName);
  const auto format = Formats().find(MesoExtensionOf(fileName));
  if (format == Formats().end())
  {
    std::string names;
    for (const std::string& extension : MesoMeshExtensions())
    {
      names += (names.empty() ? "" : ", ") + extension;
    }
    throw MesoInputError(fileName + ": is not a mesh by its name, which ends in none of " + names);
  }
  const std::string bytes = MesoReadBytes(fileName, MesoMeshLargestFile, "a mesh file");
  if (bytes.empty())
  {
    throw MesoInputError(fileName + ": is empty");
  }
  return format->second(bytes, fileName);
}

#include "MesoForeignShadows.h"

#include <regex>
#include <sstream>

std::string MesoShadeForeignLighting(const std::string& fragment, int numberOfLights)
{
  const bool traced = fragment.find("#define MESO_SURFACE\n") != std::string::npos;
  const std::string place = traced
    ? "mesoHitVC, mesoFragment.NormalVC, mesoHit.Relief * length(mesoFragment.PerDepth), "
      "length(mesoFragment.PerDepth), 0.0"
    : "vertexVC.xyz, facetOf(vertexVC.xyz, normalVCVSOutput), 0.0, 0.0, 0.0";
  const std::regex color("lightColor([0-9]+)");
  std::istringstream lines(fragment);
  std::string result;
  bool declared = false;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.find("lightColor") != std::string::npos && line.find("uniform") == std::string::npos)
    {
      // VTK uses the colours in main() alone, at its top level, a statement a line.
      for (int i = 0; i < numberOfLights && !declared; ++i)
      {
        const std::string light = std::to_string(i);
        result += "  vec3 mesoArriving" + light + " = (1.0 - castFraction(" + light + ", " + place +
          ")) * lightColor" + light + ";\n";
      }
      declared = true;
      line = std::regex_replace(line, color, "mesoArriving$1");
    }
    result += line + "\n";
  }
  return result;
}

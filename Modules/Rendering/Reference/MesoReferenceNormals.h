#ifndef MesoReferenceNormals_h
#define MesoReferenceNormals_h

#include "MesoBasePatch.h"
#include "MesoNormalMap.h"
#include "MesoOptions.h"

#include <array>
#include <optional>
#include <vector>

class vtkImageData;

/**
 * @class MesoReferenceNormals
 * @brief A normal map that a user gives in place of the true surface's shading normals.
 *
 * Bilinear between texel centres, in double. Written apart from Shaders/Common/NormalMap.glsl.
 */
class MesoReferenceNormals
{
public:
  MesoReferenceNormals(vtkImageData* map, const MesoNormalMapMeaning& meaning, MesoWrap wrap);

  /**
   * The shading normal, object space, unit; none where the map holds no direction.
   *
   * @param mapCoord map coordinate, tiles counted
   * @param tiles map coordinate = texture coordinate x tiles
   * @param perU,perV dp/du and dp/dv of the map coordinate, any lengths, at right angles to `normal`
   * @param normal unit, of the base
   */
  std::optional<glm::dvec3> NormalAt(const glm::dvec2& mapCoord, const glm::dvec2& tiles,
    const glm::dvec3& perU, const glm::dvec3& perV, const glm::dvec3& normal) const;

private:
  glm::dvec3 Stored(const glm::dvec2& place) const;

  int Width;
  int Height;
  MesoWrap Wrap;
  bool OfObject;
  std::vector<glm::dvec3> Texels; ///< directions, green up
};

#endif

#ifndef MesoReferenceLighting_h
#define MesoReferenceLighting_h

/**
 * @file MesoReferenceLighting.h
 * @brief VTK's Phong lighting and colour textures, in double precision, in world space.
 *
 * Texture values are used as stored; a picture's numbers are what VTK 9.1 writes into its frame
 * buffer (Shaders/Common/Lighting.glsl), computed apart from it.
 */

#include "MesoOptions.h" // for MesoWrap
#include "MesoScene.h"

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // as MesoHeightTexture.h asks for
#endif
#include <glm/glm.hpp>

#include <vector>

class vtkActor;
class vtkImageData;
class vtkRenderer;

/// Where a picture is seen from.
struct MesoReferenceCamera
{
  glm::dvec3 Position;
  glm::dvec3 Forward; ///< unit
  glm::dvec3 Right;
  glm::dvec3 Up;
  bool Parallel;
  double HalfHeight; ///< of the picture: world units, or at distance 1 along the view axis
  double Near;       ///< along the view axis
  double Far;

  MesoReferenceCamera(const MesoSceneCamera& camera);

  /// The ray of a place of the picture, x, y in [-1, 1] from left and bottom; `aspect` = width /
  /// height. Its direction advances 1 along the view axis.
  void RayAt(double x, double y, double aspect, glm::dvec3& origin, glm::dvec3& direction) const;
};

/// A light as it falls on a point.
struct MesoReferenceLight
{
  MesoReferenceLight(const MesoSceneLight& light, const MesoReferenceCamera& camera);

  /// Unit direction from a point towards the light; the distance, infinite where it has no place.
  glm::dvec3 Towards(const glm::dvec3& point, double& distance) const;
  /// By distance and cone.
  double AttenuationAt(const glm::dvec3& point) const;

  bool Headlight;
  bool Positional;
  bool CastsBetweenObjects; ///< the scene's `shadow`; headlights never do
  glm::dvec3 Position;
  glm::dvec3 Travel; ///< unit: the way the light, or the cone's axis, goes
  glm::dvec3 Attenuation;
  double ConeAngle; ///< degrees; 90 or more: no cone
  double Exponent;
  glm::dvec3 Radiance;
};

/// An actor's colours.
class MesoReferenceMaterial
{
public:
  MesoReferenceMaterial(vtkActor* actor, MesoWrap wrap);

  /// The colour of a point, not clamped. `blocked`: for each light the fraction that does not arrive;
  /// `shading` unit; `eye`: unit, from the point to the camera's position; `own`: the colour of the detail
  /// itself, by which ambient and diffuse light are multiplied.
  glm::dvec3 Shade(const std::vector<MesoReferenceLight>& lights,
    const std::vector<double>& blocked, const glm::dvec3& point, const glm::dvec3& shading,
    const glm::dvec3& eye, const glm::dvec2& mapCoord, const glm::dvec3& own) const;

  /// What the surface makes of diffuse light: the fraction of each colour that it sends on.
  glm::dvec3 Albedo(const glm::dvec2& mapCoord, const glm::dvec3& own) const;

  /// The diffuse part of Shade(): what the lights alone, without ambient and specular, give.
  glm::dvec3 ShadeDiffuse(const std::vector<MesoReferenceLight>& lights,
    const std::vector<double>& blocked, const glm::dvec3& point, const glm::dvec3& shading,
    const glm::dvec2& mapCoord, const glm::dvec3& own) const;

private:
  glm::dvec3 TextureAt(const glm::dvec2& mapCoord) const;

  glm::dvec3 Ambient;
  glm::dvec3 Diffuse;
  glm::dvec3 Specular;
  double SpecularPower;
  int Width = 0; ///< of the colour map, 0 without one
  int Height = 0;
  MesoWrap Wrap;
  std::vector<glm::dvec3> Texels;
};

#endif

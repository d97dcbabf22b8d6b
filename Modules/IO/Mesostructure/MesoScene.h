#ifndef MesoScene_h
#define MesoScene_h

/**
 * @file MesoScene.h
 * @brief A scene file's contents as plain values, checked, with file names resolved.
 *
 * What each key means is said once, in Documentation/SceneFile.md and in the published JSON Schema
 * (Documentation/scene.schema.json). Angles are degrees, matrices row-major, directions in world
 * space. Reading never builds VTK objects: that is vtkMesoSceneBuilder's work.
 */

#include "MesoOptions.h"
#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// What is wrong with a file, in one line that names the file, the place in it and the reason.
class MESOIOMESOSTRUCTURE_EXPORT MesoInputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

using MesoVector3 = std::array<double, 3>;

struct MesoSceneCamera
{
  MesoVector3 Position = { 0., 0., 5. };
  MesoVector3 FocalPoint = { 0., 0., 0. };
  MesoVector3 ViewUp = { 0., 1., 0. };
  double ViewAngle = 30.;                             ///< vertical, degrees, in (0, 180)
  std::optional<double> ParallelScale;                ///< > 0; makes the projection parallel
  std::optional<std::array<double, 2>> ClippingRange; ///< default: fitted
};

struct MesoSceneLight
{
  enum class Kind
  {
    Headlight,
    Directional,
    Point,
    Spot
  };
  Kind Type = Kind::Headlight;
  MesoVector3 Direction = { 0., 0., -1. }; ///< directional: where the light travels
  MesoVector3 Position = { 0., 0., 1. };
  MesoVector3 FocalPoint = { 0., 0., 0. };
  double ConeAngle = 30.; ///< half angle, degrees, in (0, 90)
  double Exponent = 1.;
  MesoVector3 Attenuation = { 1., 0., 0. }; ///< constant, linear, quadratic
  MesoVector3 Color = { 1., 1., 1. };
  double Intensity = 1.;
  bool Shadow = true;
  bool InCameraCoordinates = false;
};

/// What gives a surface its colour in place of the material's.
struct MesoSceneColorBy
{
  std::string Array; ///< name of a point array, or "height": that of the relief where it is seen
  std::optional<int> Component; ///< without one: the magnitude of the tuple
  std::string LookupTable;      ///< a color map (MesoColorMapNames), or empty: what suits the array
  std::optional<std::array<double, 2>> Range; ///< default: what suits the array

  bool IsHeight() const { return this->Array == "height"; }
};

/// What the numbers of contour lines and scalar bars count.
enum class MesoSceneHeightUnit
{
  Height, ///< 0 at the deepest point, 1 at the mesh
  Map     ///< the numbers stored in the map
};

/// Contour lines of the relief's height; either a spacing or values.
struct MesoSceneContours
{
  double Spacing = 0.; ///< > 0: lines at all its multiples
  std::vector<double> Values;
  MesoSceneHeightUnit ValuesOf = MesoSceneHeightUnit::Height;
  MesoVector3 Color = { 0., 0., 0. };
  double Width = 1.5; ///< pixels
};

/// A scalar bar beside the picture: which colors stand for which numbers.
struct MesoSceneScalarBar
{
  std::string Title; ///< empty: what color_by names
  std::string Units; ///< shown in brackets behind the title, or empty
  MesoSceneHeightUnit ValuesOf = MesoSceneHeightUnit::Height; ///< of heights
};

/// Which triangles of a mesh are meant: those where the mean of their corners' value lies in a range.
struct MesoScenePart
{
  std::string By;               ///< x, y, z, u, v, or the name of a point array
  std::optional<int> Component; ///< of an array; without one: the magnitude of the tuple
  std::array<double, 2> Range = { 0., 1. }; ///< from, up to but without
};

struct MesoSceneMaterial
{
  MesoVector3 Color = { 1., 1., 1. };
  std::string ColorMap;           ///< resolved file name, or empty
  std::string NormalMap;          ///< resolved file name, or empty
  bool NormalMapDown = false;     ///< its green grows downwards (normal_map_y)
  bool NormalMapOfObject = false; ///< it is relative to the object's axes, else to tangents
  std::optional<MesoSceneColorBy> ColorBy;
  std::optional<MesoSceneContours> Contours;
  std::optional<MesoSceneScalarBar> ScalarBar; ///< only with ColorBy
  double Ambient = 0.;
  double Diffuse = 1.;
  double Specular = 0.;
  double SpecularPower = 1.;
  double Opacity = 1.;
  bool TwoSided = false;
  bool Edges = false;
};

/// A mesh file, or a built-in shape with its numbers.
struct MesoSceneMesh
{
  std::string File;  ///< resolved file name, or empty where Shape is given
  std::string Shape; ///< of MesoShapeNames()
  /// The shape's numbers by key; a size in several directions has several values.
  std::map<std::string, std::vector<double>> Parameters;
  std::optional<double> FeatureAngle; ///< degrees; edges sharper than this split normals
  int Subdivide = 0; ///< times that it is made four times as fine and smooth (Loop1987), 0 to 6
};

/// A height or depth map: an image file or a built-in pattern, and what its numbers mean.
struct MesoSceneMap
{
  std::string File;    ///< resolved file name, or empty where Pattern is given
  std::string Pattern; ///< of MesoPatternNames()
  std::array<int, 2> Size = { 256, 256 };
  std::uint32_t Seed = 1;
  std::map<std::string, double> Parameters; ///< the pattern's further numbers by key
  bool IsDepth = false;     ///< brighter is lower (depth_map, relief_map), else higher
  bool IsReliefMap = false; ///< the depth is the file's alpha channel (relief_map)
  std::optional<std::array<double, 2>> Range;         ///< stored numbers that map to [0,1]
  std::optional<std::array<double, 2>> SampleSpacing; ///< object units a sample
};

/// Mesostructure that is no height field: a volume's file, a mesh that fills a tile, or a built-in one.
struct MesoSceneVolume
{
  std::string File;    ///< resolved file name, or empty where Pattern is given
  bool IsMesh = false; ///< the file is a closed mesh (tile_mesh)
  std::string Pattern; ///< of MesoVolumePatternNames()
  /// Voxels of the canonical volume; default: 64 x 64 x 32, of a file its own up to that many a side.
  std::optional<std::array<int, 3>> Size;
  std::uint32_t Seed = 1;
  std::map<std::string, double> Parameters; ///< the pattern's further numbers by key
  /// Stored numbers from here on are solid; default: what parts them best (MesoVolumeReport).
  std::optional<double> Threshold;
  bool SolidBelow = false; ///< numbers below Threshold are solid
  /// [x0, x1, y0, y1, z0, z1]: the part of the file that is the tile, in samples from 0, or, of a mesh,
  /// in its own units; default: all of it.
  std::optional<std::array<double, 6>> Crop;
  double Blend = 0.; ///< of the tile's width and height, that is faded so that it tiles: [0, 0.5]
};

struct MesoSceneNode
{
  std::string Name;
  /// Row-major; what `matrix` or translate * rotate * scale say.
  std::array<double, 16> Matrix = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  std::optional<MesoSceneMesh> Mesh;
  std::optional<MesoScenePart> Part; ///< of the mesh; without one: all of it
  MesoSceneMaterial Material;
  MesoMesostructureOptions Mesostructure;
  std::optional<MesoSceneMap> Map;
  std::optional<MesoSceneVolume> Volume;
  std::string VolumeColors; ///< resolved name of a volume of the tile's colours, or empty
  std::string Baked;        ///< resolved name of a baked table, or empty
  std::vector<MesoSceneNode> Children;
};

/// What lies on the side that the normal points to is drawn, the rest is cut away. World space.
struct MesoSceneClippingPlane
{
  MesoVector3 Point = { 0., 0., 0. };
  MesoVector3 Normal = { 0., 0., 1. }; ///< unit
};

struct MesoScene
{
  std::string File;
  MesoSceneCamera Camera;
  /// No `lights` key: one headlight; an empty list: none.
  std::vector<MesoSceneLight> Lights = { MesoSceneLight() };
  MesoVector3 Background = { 0., 0., 0. };
  std::vector<MesoSceneClippingPlane> ClippingPlanes; ///< at most 6
  std::vector<MesoSceneNode> Nodes;
};

/// Bytes of a scene file, at most.
constexpr std::uintmax_t MesoLargestSceneFile = 64u << 20;

/**
 * Read and check a scene file. Relative names are taken relative to the scene file's folder.
 * Throws MesoInputError on anything that is not understood: the message names the file, the place
 * ("nodes[0].mesostructure.height_map") and the reason. A key that is known but not yet served is
 * refused with just that said.
 */
MESOIOMESOSTRUCTURE_EXPORT MesoScene MesoReadScene(const std::string& fileName);

/// The same from text; `fileName` serves messages and relative names only.
MESOIOMESOSTRUCTURE_EXPORT MesoScene MesoParseScene(
  const std::string& text, const std::string& fileName);

#endif

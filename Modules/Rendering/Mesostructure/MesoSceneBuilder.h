#ifndef MesoSceneBuilder_h
#define MesoSceneBuilder_h

#include "MesoNormalMap.h"
#include "MesoScene.h"
#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
struct MesoHeights;
struct MesoNormals;
class vtkMesoPolyDataMapper;
class vtkPolyData;
class vtkRenderer;

/**
 * @class MesoSceneBuilder
 * @brief Turns a scene into actors, lights and a camera of a renderer.
 *
 * Meshes are read or made, frames attached, maps brought to heights; each node with a mesh becomes
 * an actor whose mapper draws the node's technique. Throws MesoInputError where a file cannot be
 * used; the renderer may then hold a part of the scene.
 *
 * Where a light casts shadows and there are two objects or more, the renderer gets a
 * vtkMesoShadowMapPass as its pass, else none.
 *
 * Colour maps are read in map coordinates, as the height map is: both repeat with `tiles`.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoSceneBuilder
{
public:
  struct Object
  {
    int Number = 0; ///< of the node, counted from 1 in the file's order, children after parents
    std::string Name;
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkMesoPolyDataMapper> Mapper;
    vtkSmartPointer<vtkPolyData> Base; ///< with its frames
    vtkSmartPointer<vtkPolyData>
      Mesh; ///< the base where height 1 lies: p + (1 - r) D n; or its shell
    vtkSmartPointer<vtkImageData> HeightMap;   ///< null without one
    vtkSmartPointer<vtkImageData> Volume;      ///< canonical, of techniques that draw one; or null
    vtkSmartPointer<vtkImageData> VolumeTable; ///< of gdm: distances through the volume; or null
    vtkSmartPointer<vtkImageData> NormalMap;   ///< given to be shown in place of any other; or null
    MesoNormalMapMeaning NormalMeaning;
    MesoMesostructureOptions Options;
  };

  /// Fill the renderer. Its aspect must be that of the window that it will be drawn in.
  void Build(const MesoScene& scene, vtkRenderer* renderer);

  const std::vector<Object>& GetObjects() const { return this->Objects; }
  /// What is odd but no error, a line each, to be shown to the user.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

private:
  void AddNode(const MesoScene& scene, const MesoSceneNode& node, const std::string& place,
    const std::array<double, 16>& parentMatrix, vtkRenderer* renderer);
  /// The material's normal map, where it is shown; none where it is not.
  MesoNormals ReadNormals(const MesoSceneNode& node, Object& object, const std::string& inScene);
  /// Colours, contour lines and a scalar bar of the object's numbers.
  void AddScalars(const MesoSceneMaterial& material, const Object& object,
    const std::string& inScene, vtkRenderer* renderer);
  void SetShadows(const std::vector<MesoSceneLight>& lights, vtkRenderer* renderer) const;
  MesoHeights MakeHeights(const MesoSceneMap& map, const std::string& place);
  vtkSmartPointer<vtkPolyData> MakeMesh(
    const MesoSceneNode& node, const std::string& place, vtkImageData* heights, bool needsFrames);

  std::vector<Object> Objects;
  std::vector<std::string> Warnings;
  int BarCount = 0;
  int NodeCount = 0;
};

#endif

#ifndef PaperFigure_h
#define PaperFigure_h

/**
 * @file PaperFigure.h
 * @brief A scene of the documentation beside its truth, for tests of what a report's figure shows.
 */

#include "DrawnAOVs.h"
#include "MesoBaseline.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>
#include <string>

/// What a pixel knows of a coverage.
inline bool Covers(const MesoAOVs& pixels, std::size_t pixel)
{
  return pixels.Coverage[pixel] >= 0.5f;
}

/// A scene of Data/Scenes without shadows between its objects, its truth, and what the techniques draw of
/// it.
class PaperFigure
{
public:
  /// file: without its folder and extension, in Data/Scenes/Documentation unless it is "../name".
  explicit PaperFigure(const std::string& file, int width = 160, int height = 120)
    : Scene(Unshadowed(file))
    , Width(width)
    , Height(height)
    , TruePixels(MesoAOVsOfImage(MesoReference(this->Scene).Render(width, height).AOVs))
  {
  }

  const MesoAOVs& Truth() const { return this->TruePixels; }

  /// The scene with every relief drawn by one technique.
  MesoScene With(MesoTechnique technique) const
  {
    MesoScene scene = this->Scene;
    for (MesoSceneNode& node : scene.Nodes)
    {
      if (node.Map)
      {
        node.Mesostructure.Technique = technique;
      }
    }
    return scene;
  }

  MesoAOVs Drawn() const { return DrawnAOVs(this->Scene, this->Width, this->Height); }
  MesoAOVs Drawn(MesoTechnique technique) const
  {
    return DrawnAOVs(this->With(technique), this->Width, this->Height);
  }
  MesoGeometryError ErrorOf(const MesoAOVs& drawn) const
  {
    return MesoCompareGeometry(this->TruePixels, drawn);
  }

  MesoScene Scene;
  int Width;
  int Height;

private:
  static MesoScene Unshadowed(const std::string& file)
  {
    MesoScene scene = MesoReadScene(std::string(MESO_SCENES) + "/Documentation/" + file + ".json");
    for (MesoSceneLight& light : scene.Lights)
    {
      light.Shadow = false;
    }
    return scene;
  }

  MesoAOVs TruePixels;
};

/// A scene in colours, with smooth outlines.
inline vtkSmartPointer<vtkImageData> DrawnPicture(const MesoScene& scene, int width, int height,
  const std::function<void(const MesoSceneBuilder&, vtkRenderer*)>& add = {})
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  if (add)
  {
    add(builder, renderer);
  }
  renderer->ResetCameraClippingRange();
  return MesoGrabWindow(window);
}

/// A picture of the documentation: a scene with the edges of its meshes over it, those of `tessellated` diced.
/// Where the relief ends before its mesh does, edges stand alone.
inline testing::AssertionResult MesoCompareWithMeshPicture(
  const MesoScene& scene, const std::string& name, int width, int height)
{
  const auto addEdges = [](const MesoSceneBuilder& builder, vtkRenderer* renderer)
  {
    for (const auto& object : builder.GetObjects())
    {
      if (object.Options.Technique == MesoTechnique::Tessellated)
      {
        object.Actor->GetProperty()->EdgeVisibilityOn();
        object.Actor->GetProperty()->SetEdgeColor(0.05, 0.15, 0.45);
        continue;
      }
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(object.Mesh);
      mapper->ScalarVisibilityOff();
      vtkNew<vtkActor> mesh;
      mesh->SetMapper(mapper);
      mesh->SetUserMatrix(object.Actor->GetMatrix());
      mesh->GetProperty()->SetRepresentationToWireframe();
      mesh->GetProperty()->BackfaceCullingOn();
      mesh->GetProperty()->LightingOff();
      mesh->GetProperty()->SetColor(0.05, 0.15, 0.45);
      mesh->GetProperty()->SetOpacity(0.4);
      renderer->AddActor(mesh);
    }
  };
  return MesoCompareWithBaseline(DrawnPicture(scene, width, height, addEdges), name,
    MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER });
}

#endif

#ifndef SceneTable_h
#define SceneTable_h

// A table of view-dependent displacements for a scene of one relief, in a file of its own: of as few azimuths
// and curvatures as a test can do with, where the technique would bake those of the paper anew each time.

#include "MesoBakedFile.h"
#include "MesoBumpMaps.h"
#include "MesoSceneBuilder.h"
#include "TemporaryFolder.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoVDM.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>

class SceneTable
{
public:
  /// layout: its depth is that of the scene's relief, and its last curvature at most what that allows.
  /// rank 0: the table itself.
  SceneTable(MesoScene scene, MesoVDMLayout layout, int rank)
  {
    scene.Nodes[0].Mesostructure.Technique = MesoTechnique::Relief; // has the same frames
    vtkNew<vtkMesoEGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    MesoSceneBuilder builder;
    builder.Build(scene, renderer);
    const MesoSceneBuilder::Object& object = builder.GetObjects()[0];
    layout.Depth = MesoDepthInTiles(object.Base, object.Options);
    layout.LastCurvature = std::min(layout.LastCurvature, 0.8 / layout.Depth);
    vtkNew<vtkMesoVDM> filter;
    filter->SetInputData(object.HeightMap);
    filter->SetLayout(layout);
    filter->SetRanks(rank, rank > 0 ? 4 : 0);
    filter->Update();
    MesoBaked baked;
    baked.Kind = "vdm";
    baked.Table = filter->GetOutput();
    MesoWriteBaked(this->GetFile(), baked);
  }

  /// What "baked" of a scene names; there as long as this object.
  std::string GetFile() const { return this->Folder.PathOf("scene.vdm.vti"); }

private:
  TemporaryFolder Folder;
};

#endif

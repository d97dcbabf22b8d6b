// Every picture in Documentation/Images is what the program renders from a scene in Data/Scenes, but
// for those that a test of their own draws.

#include "MesoBaseline.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"

#include "vtkImageData.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <ostream>
#include <set>
#include <vector>

namespace
{
namespace fs = std::filesystem;

struct Picture
{
  const char* Name;  ///< Documentation/Images/<Name>.png
  const char* Scene; ///< Data/Scenes/<Scene>
  const char* Size;
  const char* Verb = "render";
  const char* Technique = ""; ///< in place of the scene's
  const char* Samples = "4";
};

// GoogleTest puts it into the test's name, which must not change from run to run.
void PrintTo(const Picture& picture, std::ostream* stream)
{
  *stream << picture.Size;
}

const Picture Pictures[] = {
  { "Demo", "demo.json", "400x300" },
  { "ComparedTruth", "Documentation/Compared.json", "320x240", "reference" },
  { "ComparedBump", "Documentation/Compared.json", "320x240", "render", "bump" },
  { "ComparedDisplacement", "Documentation/Compared.json", "320x240", "render", "displacement" },
  { "ComparedHorizon", "Documentation/Compared.json", "320x240", "render", "horizon" },
  { "ComparedNormal", "Documentation/Compared.json", "320x240", "render", "normal" },
  { "ComparedParallax", "Documentation/Compared.json", "320x240", "render", "parallax" },
  { "ComparedRelief", "Documentation/Compared.json", "320x240", "render", "relief" },
  { "ComparedReliefQuadric", "Documentation/Compared.json", "320x240", "render", "relief-quadric" },
  { "ComparedTessellated", "Documentation/Compared.json", "320x240", "render", "tessellated" },
  { "ColorHeight", "Documentation/ColorHeight.json", "320x240" },
  { "CurvedBent", "Documentation/CurvedBent.json", "320x240" },
  { "CurvedExact", "Documentation/CurvedExact.json", "320x240" },
  { "CurvedOsculating", "Documentation/CurvedOsculating.json", "320x240" },
  { "CurvedQuadric", "Documentation/CurvedQuadric.json", "320x240" },
  { "CurvedSurface", "Documentation/CurvedSurface.json", "320x240" },
  { "CurvedTruth", "Documentation/CurvedQuadric.json", "320x240", "reference" },
  { "DepthCylinders", "Documentation/DepthCylinders.json", "400x300" },
  { "DisplacementLevels", "Documentation/DisplacementLevels.json", "320x240" },
  { "GDMBlob", "Documentation/GDMBlob.json", "320x240" },
  { "GDMBlobTruth", "Documentation/GDMBlob.json", "320x240", "reference" },
  { "GDMLizard", "Documentation/GDMLizard.json", "320x240" },
  { "GDMLizardTruth", "Documentation/GDMLizard.json", "320x240", "reference" },
  { "GDMNeck", "Documentation/GDMNeck.json", "320x240" },
  { "GDMNeckTruth", "Documentation/GDMNeck.json", "320x240", "reference" },
  { "GDMNeckVDM", "Documentation/GDMNeck.json", "320x240", "render", "vdm" },
  { "GDMOpen", "Documentation/GDMOpen.json", "320x240" },
  { "GDMOpenTruth", "Documentation/GDMOpen.json", "320x240", "reference" },
  { "GDMOpenVDM", "Documentation/GDMOpen.json", "320x240", "render", "vdm" },
  { "ReferenceDemo", "demo.json", "320x240", "reference" },
  { "FigureCylinder", "Documentation/FigureCylinder.json", "240x180" },
  { "FigureCylinderRelief", "Documentation/FigureCylinder.json", "240x180", "render", "relief" },
  { "FigureCylinderTruth", "Documentation/FigureCylinder.json", "240x180", "reference" },
  { "FigureHall", "Documentation/FigureHall.json", "280x210", "render", "", "2" },
  { "FigureHallTruth", "Documentation/FigureHall.json", "280x210", "reference", "", "2" },
  { "FigureRoom", "room.json", "320x240", "render", "", "2" },
  { "FigureRoomTruth", "room.json", "320x240", "reference", "", "2" },
  { "FigureSaddle", "Documentation/FigureSaddle.json", "240x180" },
  { "FigureSaddleRelief", "Documentation/FigureSaddle.json", "240x180", "render", "relief" },
  { "FigureTeapot", "Documentation/FigureTeapot.json", "240x180" },
  { "FigureTeapotRelief", "Documentation/FigureTeapot.json", "240x180", "render", "relief" },
  { "FigureTeapotTruth", "Documentation/FigureTeapot.json", "240x180", "reference" },
  { "FigureTiles", "Documentation/FigureTiles.json", "400x150" },
  { "FigureTorus", "Documentation/FigureTorus.json", "240x180" },
  { "GeometryImageCube", "Documentation/GeometryImageCube.json", "320x240" },
  { "HeightFieldGlobe", "Documentation/HeightFieldGlobe.json", "400x300" },
  { "HeightFieldPlane", "Documentation/HeightFieldPlane.json", "400x300" },
  { "ReliefCloseUpBilinear", "Documentation/ReliefCloseUpBilinear.json", "320x240" },
  { "ReliefCloseUpBicubic", "Documentation/ReliefCloseUpBicubic.json", "320x240" },
  { "ReliefColumn", "Documentation/ReliefColumn.json", "400x300" },
  { "ReliefDraft", "Documentation/ReliefDraft.json", "400x300" },
  { "ReliefFarFiltered", "Documentation/ReliefFarFiltered.json", "320x240", "render", "", "1" },
  { "ReliefFarTruth", "Documentation/ReliefFarUnfiltered.json", "320x240", "reference", "", "16" },
  { "ReliefFarUnfiltered", "Documentation/ReliefFarUnfiltered.json", "320x240", "render", "", "1" },
  { "ReliefHigh", "Documentation/ReliefHigh.json", "400x300" },
  { "ReliefMapDepth", "Documentation/ReliefMapDepth.json", "400x300" },
  { "ReliefQuadricHole", "Documentation/ReliefQuadricHole.json", "400x300" },
  { "ReliefQuadricSilhouette", "Documentation/ReliefQuadricSilhouette.json", "400x300" },
  { "ReliefQuadricTorus", "Documentation/ReliefQuadricTorus.json", "400x300" },
  { "ReliefSilhouette", "Documentation/ReliefSilhouette.json", "400x300" },
  { "ShadowsFloor", "Documentation/ShadowsFloor.json", "400x300" },
  { "ShadowsFloorReference", "Documentation/ShadowsFloor.json", "400x300", "reference" },
  { "TessellatedDraft", "Documentation/TessellatedDraft.json", "400x300" },
  { "TessellatedTorus", "Documentation/TessellatedTorus.json", "400x300" },
  { "VDMReference", "Documentation/VDMDetail.json", "240x180", "reference" },
  { "VDMCloseUp", "Documentation/VDMCloseUp.json", "320x240" },
  { "VDMCloseUpTruth", "Documentation/VDMCloseUp.json", "320x240", "reference" },
  { "VDMCurvatureChange", "Documentation/VDMCurvatureChange.json", "320x240" },
  { "VDMCurvatureChangeTruth", "Documentation/VDMCurvatureChange.json", "320x240", "reference" },
  { "VDMOpenBoundary", "Documentation/VDMOpenBoundary.json", "320x240" },
  { "VDMOpenBoundaryTruth", "Documentation/VDMOpenBoundary.json", "320x240", "reference" },
  { "VDMStretchedChart", "Documentation/VDMStretchedChart.json", "320x240" },
  { "VDMStretchedChartTruth", "Documentation/VDMStretchedChart.json", "320x240", "reference" },
  { "VDMFarFiltered", "Documentation/ReliefFarFiltered.json", "320x240", "render", "vdm", "1" },
  { "VDMFarUnfiltered", "Documentation/ReliefFarUnfiltered.json", "320x240", "render", "vdm", "1" },
  { "VDMPaperBranch", "Documentation/VDMPaperBranch.json", "320x240" },
  { "VDMPaperTorus", "Documentation/VDMPaperTorus.json", "320x240" },
  { "VDMPaperVase", "Documentation/VDMPaperVase.json", "320x240" },
  { "VDMTeapot", "Documentation/VDMTeapot.json", "320x240" },
  { "VDMTeapotBump", "Documentation/VDMTeapot.json", "320x240", "render", "bump" },
  { "VDMTeapotDisplacement", "Documentation/VDMTeapot.json", "320x240", "render", "displacement" },
  { "VDMTeapotHorizon", "Documentation/VDMTeapot.json", "320x240", "render", "horizon" },
  { "VDMTorus", "Documentation/VDMTorus.json", "400x300" },
  { "PatternBrick", "Documentation/PatternBrick.json", "320x240" },
  { "PatternNoise", "Documentation/PatternNoise.json", "320x240" },
  { "PatternSmooth", "Documentation/PatternSmooth.json", "320x240" },
  { "PatternStep", "Documentation/PatternStep.json", "320x240" },
  { "ScalarContours", "Documentation/ScalarContours.json", "400x300" },
  { "PatternCheckerboard", "Documentation/PatternCheckerboard.json", "320x240" },
  { "PatternPits", "Documentation/PatternPits.json", "320x240" },
  { "PatternSpikes", "Documentation/PatternSpikes.json", "320x240" },
  { "PatternStone", "Documentation/PatternStone.json", "320x240" },
  { "PatternTerrain", "Documentation/PatternTerrain.json", "320x240" },
  { "PatternWaves", "Documentation/PatternWaves.json", "320x240" },
  { "PatternWeave", "Documentation/PatternWeave.json", "320x240" },
  { "ShapeBranch", "Documentation/ShapeBranch.json", "320x240" },
  { "ShapeCone", "Documentation/ShapeCone.json", "320x240" },
  { "ShapeCube", "Documentation/ShapeCube.json", "320x240" },
  { "ShapeCylinder", "Documentation/ShapeCylinder.json", "320x240" },
  { "ShapePlane", "Documentation/ShapePlane.json", "320x240" },
  { "ShapeSphere", "Documentation/ShapeSphere.json", "320x240" },
  { "ShapeTeapot", "Documentation/ShapeTeapot.json", "320x240" },
  { "ShapeTorus", "Documentation/ShapeTorus.json", "320x240" },
  { "ShapeUndulating", "Documentation/ShapeUndulating.json", "320x240" },
  { "ShapeVase", "Documentation/ShapeVase.json", "320x240" },
  { "SlicesAlong", "Documentation/SlicesAlong.json", "320x240" },
  { "SlicesAlongScreen", "Documentation/SlicesAlongScreen.json", "320x240" },
  { "SlicesAlongTruth", "Documentation/SlicesAlong.json", "320x240", "reference" },
  { "VolumeBranch", "Documentation/VolumeBranch.json", "320x240" },
  { "VolumeOpen", "Documentation/VolumeOpen.json", "320x240" },
  { "VolumeOpenSlices", "Documentation/VolumeOpen.json", "320x240", "render", "slices" },
  { "VolumeOpenTruth", "Documentation/VolumeOpen.json", "320x240", "reference" },
  { "VolumeTorus", "Documentation/VolumeTorus.json", "320x240" },
  { "VolumeTorusGDM", "Documentation/VolumeTorus.json", "320x240", "render", "gdm" },
  { "VolumeTorusTruth", "Documentation/VolumeTorus.json", "320x240", "reference" },
  { "VolumeVase", "Documentation/VolumeVase.json", "320x240" },
  { "VolumeVaseGDM", "Documentation/VolumeVase.json", "320x240", "render", "gdm" },
  { "VolumeVaseTruth", "Documentation/VolumeVase.json", "320x240", "reference" },
  { "SurfaceTorusMaximum", "Documentation/SurfaceTorusMaximum.json", "400x300" },
  { "SurfaceTorusMinimum", "Documentation/SurfaceTorusMinimum.json", "400x300" },
  { "SurfaceBlobMaximum", "Documentation/SurfaceBlobMaximum.json", "400x300" },
  { "SurfaceBlobMinimum", "Documentation/SurfaceBlobMinimum.json", "400x300" },
  { "SurfaceBlobConfidence", "Documentation/SurfaceBlobConfidence.json", "400x300" },
  { "SurfaceCylinderConfidence", "Documentation/SurfaceCylinderConfidence.json", "400x300" },
};

/// By TestConvergencePicture, TestDirectionsPicture, TestDistancesPicture, TestGDMFigures, TestPaperOutlines, TestPaperQuadrics,
/// TestVDMDetail, TestVDMImages and TestVDMPicture.
const char* const DrawnElsewhere[] = { "CurvedDistances", "FigureCylinderMesh", "FigureObjectsMesh",
  "FigureQuadrics", "FigureSaddleMesh", "FigureTeapotMesh", "FigureTorusMesh", "GDMFigureDistances",
  "GDMFigureExit", "GDMFigureShadow", "GDMFigureSpaces", "ShellConvergence",
  "SurfaceBlobDirections", "VDMDraft", "VDMErrorOverBytes", "VDMErrorOverRank", "VDMFull",
  "VDMImages", "VDMLow", "VDMMedium", "VDMMesh", "VDMMeshDisplaced", "VDMMeshDisplacedZoom",
  "VDMMeshZoom", "VDMShortcut" };

/// By them alone.
const char* const ScenesDrawnElsewhere[] = { "FigureObjects" };

constexpr std::uintmax_t LargestPicture = 150000; // bytes

class DocumentationPicture : public testing::TestWithParam<Picture>
{
};

/// Names without their extension.
std::set<std::string> NamesIn(const std::string& folder, const std::string& extension)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.path().extension() == extension)
    {
      names.insert(entry.path().stem().string());
    }
  }
  return names;
}
}

TEST_P(DocumentationPicture, IsWhatTheProgramRenders)
{
  const Picture& picture = GetParam();
  const TemporaryFolder folder;
  const std::string file = folder.PathOf("picture.png");
  std::vector<std::string> arguments = { picture.Verb,
    std::string(MESO_SCENES) + "/" + picture.Scene, "-o", file, "--size", picture.Size, "--samples",
    picture.Samples };
  if (*picture.Technique)
  {
    arguments.insert(arguments.end(), { "--technique", picture.Technique, "--quality", "medium" });
  }
  const MesoRun run = RunMeso(arguments);
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_EQ(run.Messages, "");
  EXPECT_TRUE(MesoCompareWithBaseline(
    MesoReadPNG(file), picture.Name, MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));

  const std::string kept = std::string(MESO_IMAGES) + "/" + picture.Name + ".png";
  EXPECT_LE(fs::file_size(kept), LargestPicture);
}

INSTANTIATE_TEST_SUITE_P(Pictures, DocumentationPicture, testing::ValuesIn(Pictures),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(DocumentationPictures, HaveATestEach)
{
  std::set<std::string> pictures(std::begin(DrawnElsewhere), std::end(DrawnElsewhere));
  std::set<std::string> scenes(std::begin(ScenesDrawnElsewhere), std::end(ScenesDrawnElsewhere));
  for (const Picture& picture : Pictures)
  {
    pictures.insert(picture.Name);
    const fs::path scene = picture.Scene;
    if (scene.has_parent_path())
    {
      scenes.insert(scene.stem().string());
    }
  }
  EXPECT_EQ(NamesIn(MESO_IMAGES, ".png"), pictures);
  EXPECT_EQ(NamesIn(std::string(MESO_SCENES) + "/Documentation", ".json"), scenes);
}

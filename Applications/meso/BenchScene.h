#ifndef BenchScene_h
#define BenchScene_h

#include "BenchResults.h"
#include "BenchSettings.h"
#include "BenchTruth.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class BenchProgress;
class MesoSceneBuilder;
class vtkMesoEGLRenderWindow;
class vtkRenderer;

/**
 * One scene of a bench: its truths, and each arm rendered, judged against them and timed. What is
 * timed is timed in turns, in one window: a frame without anything, one of the floor (the scene drawn
 * `plain`), one of each arm, and again.
 *
 * Pictures go to the folder `<scene>` in the bench's folder: truths, and for each arm a strip (truth,
 * arm, FLIP, classes) and the surroundings of its worst pixel.
 */
class BenchScene
{
public:
  /// Reads the scene. `device` is the name of what draws. Throws MesoInputError.
  BenchScene(const BenchSettings& settings, const std::string& file, const std::string& device);

  /// The file's name without folder and extension.
  const std::string& Name() const { return this->SceneName; }

  /// What Run() will tell the progress.
  double Steps() const;

  /// Does what `results` do not hold yet, and saves them. False where the scene has no truth, which
  /// the results then say.
  bool Run(BenchResults& results, BenchProgress& progress) const;

private:
  /// What arms are judged by.
  struct Truths
  {
    std::map<BenchSurface, MesoRendering> Surfaces;
    /// Of techniques, solved when the first arm of each is judged.
    std::map<MesoTechnique, std::optional<MesoAOVs>> Models;
  };
  struct Arm;

  std::string KeyOfScene() const;
  std::string KeyOfArm(const BenchArm& arm) const;
  std::string PathOf(const std::string& name) const;
  Truths MakeTruths(BenchResults& results, BenchProgress& progress) const;
  /// Renders an arm in the window and judges it; its row says whether it was refused.
  std::unique_ptr<Arm> Render(const BenchArm& choice, vtkMesoEGLRenderWindow* window,
    vtkRenderer* renderer, Truths& truths) const;
  /// Times arms in turns with the floor and adds that to their rows.
  void Time(const std::vector<std::unique_ptr<Arm>>& arms, const MesoSceneBuilder& floor,
    vtkMesoEGLRenderWindow* window) const;
  void Judge(Arm& arm, const MesoRendering& rendering, Truths& truths) const;
  BenchResults::Json StartOfRow(const BenchArm& arm) const;
  /// Each technique with all its effects and with each of them off.
  std::vector<BenchArm> AblationArms() const;
  /// Renders and times what the results do not hold yet.
  void RunArms(const std::vector<BenchArm>& arms, const MesoSceneBuilder& floor,
    vtkMesoEGLRenderWindow* window, vtkRenderer* renderer, Truths& truths, BenchResults& results,
    BenchProgress& progress) const;

  const BenchSettings& Settings;
  std::vector<BenchArm> Arms; ///< those of the settings that draw what the scene holds
  std::string File;
  std::string SceneName;
  std::string Device;
  std::string Content; ///< bytes of the scene's file and of all files that it names
  MesoScene Scene;
};

/// The surface that a technique is judged by, of those that a scene has: what models the smooth surface
/// is judged by it.
BenchSurface SurfaceOfTechnique(MesoTechnique technique, bool hasSmooth);

#endif

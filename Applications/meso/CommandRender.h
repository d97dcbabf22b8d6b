#ifndef CommandRender_h
#define CommandRender_h

#include "MesoOptions.h"
#include "MesoScene.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// `meso render`: a scene file becomes a picture, and on request AOVs and figures of cost.
class CommandRender
{
public:
  /// Adds the command and its options to the program.
  explicit CommandRender(CLI::App& app);

  /// Returns the program's exit code; throws where the job fails.
  int Run();

private:
  /// Options of the command line take the place of what the scene says.
  void Override(std::vector<MesoSceneNode>& nodes) const;

  std::string SceneFile;
  std::string Output;
  std::array<int, 2> Size = { 800, 600 };
  std::optional<MesoTechnique> Technique;
  std::optional<MesoQuality> Quality;
  std::optional<MesoSearch> Search;
  std::optional<MesoEffectChoice> Effects;
  std::vector<std::string> Channels; ///< AOV groups, empty for none
  int Samples = 1;
  std::string StatsFile;
};

#endif

#ifndef CommandReference_h
#define CommandReference_h

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// `meso reference`: a scene file ray traced over its true surface.
class CommandReference
{
public:
  /// Adds the command and its options to the program.
  explicit CommandReference(CLI::App& app);

  /// Returns the program's exit code; throws where the job fails.
  int Run();

private:
  std::string SceneFile;
  std::string Output;
  std::array<int, 2> Size = { 800, 600 };
  bool Smooth = false;               ///< the closed forms of the shapes, not the meshes
  std::vector<std::string> Channels; ///< AOV groups, empty for none
  int Samples = 1;
  int Bounces = 0;
  std::string StatsFile;
};

#endif

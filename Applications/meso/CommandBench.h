#ifndef CommandBench_h
#define CommandBench_h

#include "BenchSettings.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// `meso bench`: scenes in all techniques and qualities become tables, plots and a report of error
/// against cost.
class CommandBench
{
public:
  /// Adds the command and its options to the program.
  explicit CommandBench(CLI::App& app);

  /// Returns the program's exit code; throws where the job fails.
  int Run();

private:
  /// Adds an arm with each search that is asked for and goes with it.
  void AddSearches(const BenchArm& arm, std::vector<BenchArm>& arms) const;
  std::vector<BenchArm> Arms() const;

  BenchSettings Settings;
  std::vector<MesoTechnique> Techniques;
  std::vector<MesoQuality> Qualities;
  std::vector<MesoSearch> Searches;
  std::optional<std::array<int, 2>> Size;
};

#endif

#ifndef CommandBake_h
#define CommandBake_h

#include <memory>
#include <string>
#include <vector>

class BakeKind;

namespace CLI
{
class App;
}

/// `meso bake KIND`: a map becomes what a technique needs, once.
class CommandBake
{
public:
  /// Adds the command, and a subcommand a kind, to the program.
  explicit CommandBake(CLI::App& app);
  ~CommandBake();

  /// Returns the program's exit code; throws where the job fails.
  int Run();

private:
  CLI::App* Command;
  std::vector<std::unique_ptr<BakeKind>> Kinds;
};

#endif

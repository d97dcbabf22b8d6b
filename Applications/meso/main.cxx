// meso: dispatches to one command a verb.
// Exit: 0 on success, 1 on a failed job, 2 on wrong usage.

#include "CommandBake.h"
#include "CommandBench.h"
#include "CommandCompare.h"
#include "CommandInfo.h"
#include "CommandReference.h"
#include "CommandRender.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <iostream>
#include <map>

int main(int argc, char* argv[])
{
  CLI::App app("Fine surface relief on coarse meshes.", "meso");
  app.set_version_flag("--version", std::string("meso ") + MESO_VERSION);
  app.require_subcommand(0, 1); // so that a mistyped command is named: see below
  app.footer("Example: meso render scene.json -o scene.png\n"
             "Each command has its own help: meso render --help");
  CommandBake bake(app);
  CommandBench bench(app);
  CommandCompare compare(app);
  CommandInfo info(app);
  CommandRender render(app);
  CommandReference reference(app);
  const std::map<std::string, std::function<int()>> commands = {
    { "bake", [&] { return bake.Run(); } },
    { "bench", [&] { return bench.Run(); } },
    { "compare", [&] { return compare.Run(); } },
    { "info", [&] { return info.Run(); } },
    { "reference", [&] { return reference.Run(); } },
    { "render", [&] { return render.Run(); } },
  };
  try
  {
    app.parse(argc, argv);
    if (app.get_subcommands().empty())
    {
      throw CLI::RequiredError("A command");
    }
    return commands.at(app.get_subcommands().front()->get_name())();
  }
  catch (const CLI::Success& asked) // help, version
  {
    return app.exit(asked, std::cout, std::cerr);
  }
  catch (const CLI::ParseError& problem)
  {
    const auto asked = app.get_subcommands();
    const std::string verb = asked.empty() ? "" : asked.front()->get_name() + " ";
    std::cerr << "meso: " << problem.what() << " (see meso " << verb << "--help)\n";
    return 2;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "meso: " << problem.what() << "\n";
    return 1;
  }
}

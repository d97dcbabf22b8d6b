// meso: dispatches to one command a verb.
// Exit: 0 on success, 1 on a failed job, 2 on wrong usage.

#include "CommandRender.h"

#include <CLI/CLI.hpp>

#include <iostream>

int main(int argc, char* argv[])
{
  CLI::App app("Fine surface relief on coarse meshes.", "meso");
  app.set_version_flag("--version", std::string("meso ") + MESO_VERSION);
  app.require_subcommand(1);
  app.footer("Each command has its own help: meso render --help");
  CommandRender render(app);
  try
  {
    app.parse(argc, argv);
    return render.Run();
  }
  catch (const CLI::ParseError& problem)
  {
    return app.exit(problem, std::cout, std::cerr) == 0 ? 0 : 2;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "meso: " << problem.what() << "\n";
    return 1;
  }
}

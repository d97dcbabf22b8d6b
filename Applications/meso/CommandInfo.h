#ifndef CommandInfo_h
#define CommandInfo_h

#include <string>

namespace CLI
{
class App;
}

/// `meso info`: what a file holds and what is wrong with it.
class CommandInfo
{
public:
  explicit CommandInfo(CLI::App& app);
  int Run();

private:
  std::string File;
  bool Json = false;
};

#endif

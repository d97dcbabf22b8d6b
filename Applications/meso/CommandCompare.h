#ifndef CommandCompare_h
#define CommandCompare_h

#include <string>

struct MesoImageError;

namespace CLI
{
class App;
}

/// `meso compare`: two pictures, or what their pixels know, become figures of error.
class CommandCompare
{
public:
  /// Adds the command and its options to the program.
  explicit CommandCompare(CLI::App& app);

  /// Returns the program's exit code; throws where the job fails.
  int Run();

private:
  /// Compares what the two files, and AOVs beside pictures, hold.
  MesoImageError Compare() const;
  void WritePictures(const MesoImageError& error) const;

  std::string Truth;
  std::string Test;
  bool Json = false;
  std::string DifferenceFile;
  std::string ClassesFile;
};

#endif

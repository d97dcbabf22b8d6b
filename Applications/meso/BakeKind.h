#ifndef BakeKind_h
#define BakeKind_h

#include "MesoOptions.h" // for MesoWrap
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkImageData;

namespace CLI
{
class App;
}

/**
 * One KIND of `meso bake`: adds its own subcommand with its options, and does the job.
 *
 * A new kind is a class of its own and a line in CommandBake.cxx.
 */
class BakeKind
{
public:
  BakeKind() = default;
  virtual ~BakeKind() = default;
  BakeKind(const BakeKind&) = delete;
  void operator=(const BakeKind&) = delete;

  /// The word for it on the command line, `bake`'s subcommand.
  virtual const char* GetName() const = 0;

  /// Fill the subcommand: description, options, an example.
  virtual void AddOptions(CLI::App& command) = 0;

  /// Bake and write; throws where that fails.
  virtual void Run() = 0;
};

/// The height map that a kind bakes: INPUT and what its numbers mean, by options named as the scene
/// file's keys.
class BakeInput
{
public:
  /// Adds INPUT, --depth-map, --range, --wrap.
  void AddOptions(CLI::App& command);

  const std::string& GetFileName() const { return this->FileName; }
  MesoWrap GetWrap() const { return this->Wrap; }

  /// Heights in [0,1] (MesoToHeights). What is odd about the file is said on standard error.
  vtkSmartPointer<vtkImageData> Read() const;

private:
  std::string FileName;
  bool IsDepth = false;
  std::optional<std::array<double, 2>> Range;
  MesoWrap Wrap = MesoWrap::Repeat;
};

/// -o and --stats of a kind.
class BakeOutput
{
public:
  /// `what` describes the file that is written.
  void AddOptions(CLI::App& command, const std::string& what);

  const std::string& GetFileName() const { return this->FileName; }

  /// Throws where a result, one of `more` too, could not be written or would go over an input.
  void Check(
    const std::vector<std::string>& inputs, const std::vector<std::string>& more = {}) const;

  /// Updates the algorithm under a progress bar; its first error is thrown. Takes the time of it.
  void Update(vtkAlgorithm* algorithm);

  /// Writes --stats, where it was asked for: kind, size, seconds and the process's peak memory, and what
  /// more a kind has to say.
  void WriteStats(const char* kind, vtkImageData* table,
    const std::vector<std::pair<std::string, double>>& more = {}) const;

private:
  std::string FileName;
  std::string StatsFile;
  double Seconds = 0.;
};

#endif

#ifndef CommandLine_h
#define CommandLine_h

/**
 * @file CommandLine.h
 * @brief Options and habits that the verbs share.
 *
 * Values that make no sense throw CLI::ValidationError, which names option and value.
 */

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace CLI
{
class App;
}

/// Names as one text, with commas.
std::string JoinNames(const std::vector<std::string>& names);

/// The parts of a list, empty ones as well, which no list of names takes.
std::vector<std::string> SplitAtCommas(const std::string& text);

/// Width and height of a text such as 800x600.
std::array<int, 2> ParseSize(const char* option, const std::string& text);

/// The two numbers of a text such as 0,255, or nothing.
std::optional<std::array<double, 2>> ParsePair(const std::string& text);

/// An option that takes one of two words; `flag` becomes whether it is `on`.
void AddChoice(CLI::App& command, const std::string& option, const std::string& off,
  const std::string& on, bool& flag, const std::string& help);

///@{
/// `-o,--output`, a .png; `--size WxH`; `--aov LIST` of these groups; `--samples N`; `--stats FILE`.
void AddOutputOption(CLI::App& command, std::string& output);
void AddSizeOption(CLI::App& command, std::array<int, 2>& size);
void AddAOVOption(
  CLI::App& command, const std::vector<std::string>& groups, std::vector<std::string>& channels);
void AddSamplesOption(CLI::App& command, int& samples);
void AddStatsOption(CLI::App& command, std::string& file, const std::string& help);
///@}

/// The AOVs that lie beside a picture: `x.png` gives `x.aov.exr`.
std::string AOVFileName(const std::string& picture);

/// Throws where a result could not be written, two would go to one file, or one would go over a file
/// that the command reads (`inputs`), before time is spent on them. Empty names are passed over.
void CheckFileNames(const std::vector<std::string>& names, const std::vector<std::string>& inputs);

/// Of these channels, those that AOV groups ("depth", "texcoord", "all", ...) stand for.
std::vector<std::string> ChannelsOfGroups(
  const std::vector<std::string>& groups, const std::vector<std::string>& channels);

/// The bytes of a PNG file.
std::string PictureBytes(vtkImageData* image);

/// A bar on the terminal's last line for work of over a second; nothing where output is piped.
class ProgressBar
{
public:
  void operator()(double part);

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

#endif

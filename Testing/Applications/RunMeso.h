#ifndef RunMeso_h
#define RunMeso_h

/**
 * @file RunMeso.h
 * @brief Runs the built program `meso` as a user does, and keeps what it says.
 */

#include <string>
#include <vector>

struct MesoRun
{
  int ExitCode = -1;    ///< -1 where a signal ended it
  std::string Output;   ///< standard output
  std::string Messages; ///< standard error, without the line that names the device
};

/// Runs `meso` with these arguments and waits. Throws std::runtime_error where it cannot start.
MesoRun RunMeso(const std::vector<std::string>& arguments);

/// Starts `meso` and leaves it to itself; what it says is not kept. Result: of the process.
int StartMeso(const std::vector<std::string>& arguments);

/// Waits for it to end. Result: its exit code, -1 where a signal ended it.
int WaitForMeso(int process);

#endif

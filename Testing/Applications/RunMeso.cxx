#include "RunMeso.h"

#include "TemporaryFolder.h"

#include <cstdlib> // for setenv
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
std::string ContentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

// Which device draws is no message about the job.
std::string WithoutDevice(const std::string& messages)
{
  const std::string start = "meso: rendering on ";
  const auto at = messages.find(start);
  if (at == std::string::npos)
  {
    return messages;
  }
  const auto end = messages.find('\n', at);
  return messages.substr(0, at) + (end == std::string::npos ? "" : messages.substr(end + 1));
}

int Start(
  const std::vector<std::string>& arguments, const std::string& output, const std::string& messages)
{
#ifdef MESO_ASAN_OPTIONS
  setenv("ASAN_OPTIONS", MESO_ASAN_OPTIONS, 0);
#endif
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int Flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), Flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), Flags, 0600);

  std::vector<std::string> words = { MESO_PROGRAM };
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);

  pid_t process = 0;
  const int problem =
    posix_spawn(&process, MESO_PROGRAM, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0)
  {
    throw std::runtime_error(std::string(MESO_PROGRAM) + " cannot be run");
  }
  return process;
}
}

int StartMeso(const std::vector<std::string>& arguments)
{
  return Start(arguments, "/dev/null", "/dev/null");
}

int WaitForMeso(int process)
{
  int status = 0;
  if (waitpid(process, &status, 0) != process)
  {
    throw std::runtime_error(std::string(MESO_PROGRAM) + " cannot be waited for");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

MesoRun RunMeso(const std::vector<std::string>& arguments)
{
  const TemporaryFolder folder;
  const std::string output = folder.PathOf("stdout");
  const std::string messages = folder.PathOf("stderr");
  const int exitCode = WaitForMeso(Start(arguments, output, messages));
  return { exitCode, ContentOf(output), WithoutDevice(ContentOf(messages)) };
}

// Input and output are files in memory, so that neither side waits for a full
// pipe.
#include "adapters/asr/words/program_output.hpp"

#include <array>
#include <utility>

#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "adapters/asr/words/memory_file.hpp"

extern char** environ;

namespace parlour::adapters::asr {

namespace {

// No copy of this process is made: it may have many threads.
std::optional<pid_t> start(const std::vector<std::string>& words, int input,
                           int output) {
  std::vector<char*> arguments;
  for (const auto& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t process = 0;
  const auto error = posix_spawnp(&process, arguments[0], &actions, nullptr,
                                  arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? std::optional(process) : std::nullopt;
}

// Whether it ended by itself, and well.
// The descriptor of the process becomes readable when it ends, so that no
// signal is needed.
bool ends_well(pid_t process, std::chrono::milliseconds patience) {
  const int handle = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  pollfd ended{handle, POLLIN, 0};
  const bool in_time =
      handle >= 0 && poll(&ended, 1, static_cast<int>(patience.count())) == 1;
  if (handle >= 0)
    close(handle);
  if (!in_time)
    kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  return in_time && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

// What it writes on standard error goes where ours does.
std::optional<std::string> program_output(const std::vector<std::string>& words,
                                          const std::string& input,
                                          std::chrono::milliseconds patience) {
  const auto given = MemoryFile::make(input);
  const auto taken = MemoryFile::make("");
  if (words.empty() || !given || !taken)
    return {};
  const auto process = start(words, given->descriptor(), taken->descriptor());
  if (!process || !ends_well(*process, patience))
    return {};
  return taken->text();
}

} // namespace parlour::adapters::asr

#include "adapters/process/started_process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

namespace {

// The file actions and attributes for posix_spawn. All descriptors but the
// given ones are closed. Signals have their default handling. A process group
// of its own keeps Ctrl-C away from it: the platform decides when components
// end.
class Start {
public:
  explicit Start(std::span<const int> descriptors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    int number = 0;
    for (const auto ours : descriptors)
      give(ours, number++);
    posix_spawn_file_actions_addclosefrom_np(&actions_, number);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK |
                                               POSIX_SPAWN_SETSIGDEF |
                                               POSIX_SPAWN_SETPGROUP);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;
  ~Start() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }

  // Returns 0, or the error number.
  int run(pid_t& process, const std::filesystem::path& program,
          const std::vector<std::string>& arguments) const {
    // The first word is what ps shows.
    std::vector<char*> words{const_cast<char*>("parlour")};
    for (const auto& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    return posix_spawn(&process, program.c_str(), &actions_, &attributes_,
                       words.data(), environ);
  }

private:
  void give(int ours, int number) {
    if (ours < 0)
      posix_spawn_file_actions_addopen(&actions_, number, "/dev/null", O_RDWR,
                                       0);
    else
      posix_spawn_file_actions_adddup2(&actions_, ours, number);
  }

  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

// The exit status of waitpid as a sentence without its subject.
std::string description_of(int status) {
  if (WIFSIGNALED(status))
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace

Expected<std::unique_ptr<StartedProcess>>
StartedProcess::start(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments,
                      std::span<const int> descriptors) {
  pid_t process = -1;
  if (const auto trouble = Start(descriptors).run(process, program, arguments);
      trouble != 0)
    return fail(ErrorKind::settings,
                program.string() + " does not start: " +
                    std::generic_category().message(trouble));
  return std::unique_ptr<StartedProcess>(new StartedProcess(process));
}

StartedProcess::StartedProcess(pid_t process)
    : process_(process),
      ended_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {
  if (ended_ >= 0)
    fcntl(ended_, F_SETFD, FD_CLOEXEC);
}

StartedProcess::~StartedProcess() {
  if (process_ > 0)
    bury(Milliseconds::zero());
  if (ended_ >= 0)
    ::close(ended_);
}

// Without a pidfd nobody knows; bury() then kills when the time is over.
bool StartedProcess::ends_by(Moment deadline) const {
  pollfd awaited[] = {{ended_, POLLIN, 0}};
  return wait_until_ready(awaited, deadline) == Waited::ready;
}

bool StartedProcess::has_ended() const {
  return ends_by(Moment::clock::now());
}

void StartedProcess::kill() {
  std::lock_guard lock(mutex_);
  if (process_ > 0)
    ::kill(process_, SIGKILL);
}

std::string StartedProcess::bury(Milliseconds patience) {
  ends_by(Moment::clock::now() + patience);
  std::lock_guard lock(mutex_);
  int status = 0;
  // Reaping under the lock: kill() can never hit a process that got the same
  // number.
  const bool alive = waitpid(process_, &status, WNOHANG) == 0;
  if (alive) {
    ::kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  process_ = -1;
  return alive ? "hung up and did not end" : description_of(status);
}

} // namespace parlour::adapters

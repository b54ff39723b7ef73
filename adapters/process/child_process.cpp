#include "adapters/process/child_process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

// What the new process starts with: nothing of ours but its socket, signals as
// they are by default, and a group of its own, so that Ctrl-C is ours to take.
class Start {
public:
  explicit Start(int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    for (const auto stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR,
                                       0);
    posix_spawn_file_actions_adddup2(&actions_, socket, component_socket);
    posix_spawn_file_actions_addclosefrom_np(&actions_, component_socket + 1);
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

  // 0 or what is wrong.
  int run(pid_t& process, const std::filesystem::path& program,
          const std::vector<std::string>& arguments) const {
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const auto& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    return posix_spawn(&process, program.c_str(), &actions_, &attributes_,
                       words.data(), environ);
  }

private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

tl::unexpected<Error> not_started(const std::filesystem::path& program,
                                  int error) {
  return fail(ErrorKind::settings, program.string() + " does not start: " +
                                       std::generic_category().message(error));
}

std::string words_of(int status) {
  if (WIFSIGNALED(status))
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace

Expected<std::unique_ptr<ChildProcess>>
ChildProcess::spawn(const std::filesystem::path& program,
                    const std::vector<std::string>& arguments) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return not_started(program, errno);
  pid_t process = -1;
  const auto trouble = Start(ends[1]).run(process, program, arguments);
  ::close(ends[1]);
  if (trouble == 0)
    return std::unique_ptr<ChildProcess>(new ChildProcess(process, ends[0]));
  ::close(ends[0]);
  return not_started(program, trouble);
}

ChildProcess::ChildProcess(pid_t process, int socket)
    : process_(process),
      ended_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))),
      socket_(socket) {
  if (ended_ >= 0)
    fcntl(ended_, F_SETFD, FD_CLOEXEC);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0)
    bury(Milliseconds::zero());
  if (ended_ >= 0)
    ::close(ended_);
}

bool ChildProcess::has_ended() const {
  pollfd ended{ended_, POLLIN, 0};
  return poll(&ended, 1, 0) == 1;
}

void ChildProcess::kill() {
  std::lock_guard lock(mutex_);
  if (process_ > 0)
    ::kill(process_, SIGKILL);
}

std::string ChildProcess::bury(Milliseconds patience) {
  pollfd ended{ended_, POLLIN, 0};
  poll(&ended, 1, static_cast<int>(patience.count()));
  std::lock_guard lock(mutex_);
  int status = 0;
  const bool alive = waitpid(process_, &status, WNOHANG) == 0;
  if (alive) {
    ::kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  process_ = -1;
  return alive ? "hung up and did not end" : words_of(status);
}

} // namespace parlour::adapters

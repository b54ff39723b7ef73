#include "adapters/process/child_process.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

namespace {

// Our end does not block, and no other child inherits it.
bool make_pipe(int (&ends)[2]) {
  return pipe2(ends, O_CLOEXEC) == 0 &&
         fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

// The file actions and attributes for posix_spawn. The child gets its socket,
// its output pipe and /dev/null as standard input; all other descriptors are
// closed. Signals have their default handling. A process group of its own keeps
// Ctrl-C away from it: the platform decides when components end.
class Start {
public:
  Start(int socket, int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null",
                                     O_RDONLY, 0);
    for (const auto stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_adddup2(&actions_, output, stream);
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
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

tl::unexpected<Error> not_started(const std::filesystem::path& program,
                                  int error) {
  return fail(ErrorKind::settings, program.string() + " does not start: " +
                                       std::generic_category().message(error));
}

// The exit status of waitpid as a sentence without its subject.
std::string description_of(int status) {
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
  int output[2] = {-1, -1};
  pid_t process = -1;
  // The child has its own copies, so our copies of its ends are closed in
  // either case: only then is a closed socket noticed.
  const auto trouble =
      make_pipe(output)
          ? Start(ends[1], output[1]).run(process, program, arguments)
          : errno;
  for (const auto theirs : {ends[1], output[1]})
    ::close(theirs);
  if (trouble == 0)
    return std::unique_ptr<ChildProcess>(
        new ChildProcess(process, ends[0], output[0]));
  for (const auto ours : {ends[0], output[0]})
    ::close(ours);
  return not_started(program, trouble);
}

ChildProcess::ChildProcess(pid_t process, int socket, int output)
    : process_(process),
      ended_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))),
      output_(output), socket_(socket) {
  if (ended_ >= 0)
    fcntl(ended_, F_SETFD, FD_CLOEXEC);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0)
    bury(Milliseconds::zero());
  for (const auto ours : {ended_, output_})
    if (ours >= 0)
      ::close(ours);
}

std::string ChildProcess::read_output() {
  std::string bytes(1 << 16, '\0');
  const auto got =
      output_ < 0 ? 0 : ::read(output_, bytes.data(), bytes.size());
  if (got == 0 && output_ >= 0)
    // A pipe at its end would be readable for ever, and wait() would not block.
    ::close(std::exchange(output_, -1));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

// Without a pidfd nobody knows; bury() then kills when the time is over.
bool ChildProcess::ends_by(IpcSocket::Moment deadline) const {
  pollfd awaited[] = {{ended_, POLLIN, 0}};
  return wait_until_ready(awaited, deadline) == Waited::ready;
}

bool ChildProcess::has_ended() const {
  return ends_by(std::chrono::steady_clock::now());
}

void ChildProcess::kill() {
  std::lock_guard lock(mutex_);
  if (process_ > 0)
    ::kill(process_, SIGKILL);
}

std::string ChildProcess::bury(Milliseconds patience) {
  ends_by(std::chrono::steady_clock::now() + patience);
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

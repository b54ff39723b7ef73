// ChildProcess is an operating-system process that runs one component. It
// inherits nothing from us but one end of a socket pair, as descriptor
// `component_socket`, and a pipe for what it prints.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <sys/types.h>

#include "adapters/process/ipc_socket.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters {

// The descriptor on which the program in the child finds its socket.
inline constexpr int component_socket = 3;

// Threads: one thread reads, waits and reaps (bury); any thread may kill.
class ChildProcess {
public:
  // Starts the program. The error, of kind Settings, says that the program does
  // not exist or that the system cannot start a process.
  static Expected<std::unique_ptr<ChildProcess>>
  spawn(const std::filesystem::path& program,
        const std::vector<std::string>& arguments);
  // Kills the process if it still runs.
  ~ChildProcess();

  IpcSocket& socket() {
    return socket_;
  }
  // Blocks until the socket or the output can be read, or the process has
  // ended.
  void wait() const {
    socket_.wait(ended_, output_);
  }
  // Returns what the process has printed on standard output and error, at most
  // 64 KiB. Does not block.
  std::string read_output();
  bool has_ended() const;
  // Thread-safe. Does nothing after bury().
  void kill();

  // Waits for the end of the process, kills it after `patience`, and reaps it,
  // so that no zombie remains. Returns how it ended: "was killed by signal 9
  // (Killed)".
  std::string bury(Milliseconds patience);

private:
  ChildProcess(pid_t process, int socket, int output);
  // Blocks until the process has ended or the deadline has passed.
  bool ends_by(IpcSocket::Moment deadline) const;

  std::mutex mutex_;
  // -1 after bury(): the number may belong to another process then.
  pid_t process_;
  // A pidfd, readable when the process has ended; -1 if the kernel has none.
  int ended_;
  // Our end of the output pipe; -1 after its end.
  int output_;
  IpcSocket socket_;
};

} // namespace parlour::adapters

// ChildProcess is an operating-system process that runs one component. It
// inherits nothing from us but one end of a socket pair, as descriptor
// `component_socket`, and a pipe for what it prints.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "adapters/process/ipc_socket.hpp"
#include "adapters/process/started_process.hpp"

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
    socket_.wait(process_->ended(), output_);
  }
  // Returns what the process has printed on standard output and error, at most
  // 64 KiB. Does not block.
  std::string read_output();
  // As for a StartedProcess.
  bool has_ended() const {
    return process_->has_ended();
  }
  void kill() {
    process_->kill();
  }
  std::string bury(Milliseconds patience) {
    return process_->bury(patience);
  }

private:
  ChildProcess(std::unique_ptr<StartedProcess> process, int socket, int output);

  const std::unique_ptr<StartedProcess> process_;
  // Our end of the output pipe; -1 after its end.
  int output_;
  IpcSocket socket_;
};

} // namespace parlour::adapters

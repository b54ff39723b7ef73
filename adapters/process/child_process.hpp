// ChildProcess: a program that runs for one component. Of ours it has nothing
// but one end of a socket pair, as `component_socket`, and of a pipe for what
// it prints.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <sys/types.h>

#include "adapters/process/frame_socket.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters {

inline constexpr int component_socket = 3;

class ChildProcess {
public:
  // An error of kind Settings: there is no such program, or no process for it.
  static Expected<std::unique_ptr<ChildProcess>>
  spawn(const std::filesystem::path& program,
        const std::vector<std::string>& arguments);
  // Kills it where it has not been buried.
  ~ChildProcess();

  FrameSocket& socket() {
    return socket_;
  }
  // Blocks until something can be read of its socket or its output, or it has
  // ended.
  void wait() const {
    socket_.wait(ended_, output_);
  }
  // What it has printed since, on standard output or error, some 64 KiB at a
  // time; without waiting.
  std::string read_output();
  bool has_ended() const;
  void kill(); // from any thread, at any time

  // Waits for its end, which comes by force after so long; nothing of it is
  // left. How it ended: "was killed by signal 9 (Killed)".
  std::string bury(Milliseconds patience);

private:
  ChildProcess(pid_t process, int socket, int output);

  std::mutex mutex_;
  pid_t process_; // -1: buried
  int ended_;     // a descriptor that can be read then; -1: there is none
  int output_;    // the same; -1: it prints nothing any more
  FrameSocket socket_;
};

} // namespace parlour::adapters

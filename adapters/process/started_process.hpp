// StartedProcess is an operating-system process that we have started and have
// not reaped yet. It inherits nothing from us but the descriptors that it is
// given.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Threads: one thread reaps (bury); any thread may kill.
class StartedProcess {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Starts a program whose descriptors 0, 1, 2 … are copies of these ones of
  // ours; -1 stands for /dev/null. None of ours may be among the numbers that
  // the program gets. The error, of kind Settings, says that the program does
  // not exist or that the system cannot start a process.
  static Expected<std::unique_ptr<StartedProcess>>
  start(const std::filesystem::path& program,
        const std::vector<std::string>& arguments,
        std::span<const int> descriptors);
  StartedProcess(const StartedProcess&) = delete;
  StartedProcess& operator=(const StartedProcess&) = delete;
  // Kills the process if it still runs.
  ~StartedProcess();

  // A descriptor that can be read when the process has ended; -1 if the kernel
  // has none. It belongs to this object.
  int ended() const {
    return ended_;
  }
  bool has_ended() const;
  // Thread-safe. Does nothing after bury().
  void kill();

  // Waits for the end of the process, kills it after `patience`, and reaps it,
  // so that no zombie remains. Returns how it ended: "was killed by signal 9
  // (Killed)". Call it once.
  std::string bury(Milliseconds patience);

private:
  explicit StartedProcess(pid_t process);
  // Blocks until the process has ended or the deadline has passed.
  bool ends_by(Moment deadline) const;

  std::mutex mutex_;
  // -1 after bury(): the number may belong to another process then.
  pid_t process_;
  // A pidfd, readable when the process has ended; -1 if the kernel has none.
  const int ended_;
};

} // namespace parlour::adapters

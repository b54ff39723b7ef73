// Hearing: whether a run with a voice still has something to hear once nobody
// types any more. It goes on until a signal, or until the file that is heard in
// the place of a microphone has ended and nothing has happened for a while.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "runtime/message/message.hpp"

namespace parlour::tools {

// Safe to use from any thread.
class Hearing {
public:
  // The names of components.
  using Names = std::set<std::string, std::less<>>;

  // `quiet` is longer than the pause after which a robot takes a topic up
  // again.
  explicit Hearing(Names microphones,
                   std::chrono::milliseconds quiet = std::chrono::seconds(4))
      : microphones_(std::move(microphones)), quiet_(quiet) {}

  using Moment = std::chrono::steady_clock::time_point;

  // A message of the run.
  void take(const Message& message,
            Moment now = std::chrono::steady_clock::now());
  // A signal came.
  void end();
  bool is_over(Moment now) const;
  // Returns when there is nothing more to hear.
  void wait();

private:
  bool is_over_now(Moment now) const; // while mutex_ is held

  const Names microphones_;
  const std::chrono::milliseconds quiet_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Moment last_; // of the messages
  bool file_ended_ = false;
  bool interrupted_ = false;
};

} // namespace parlour::tools

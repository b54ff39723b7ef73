// Knows when the house is quiet: nothing queued and nothing running. Every
// message that asks for something holds a piece of Work
// (actors/protocol/work.hpp) until its handler is done, and whatever the
// handler sends holds another, so that the count is zero exactly when nothing
// goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "actors/protocol/work.hpp"

namespace parlour::actors {

// Safe to use from any thread. Outlives every piece of Work that it gave out.
class WorkCount : public WorkCounter {
public:
  using Deadline = std::chrono::steady_clock::time_point;

  // A piece of work; over when its last copy is gone.
  Work begin();

  // Sessions that wait for an answer which is to come by itself.
  void session_waits(bool waits);
  bool sessions_wait() const {
    return waiting_ != 0;
  }

  // Blocks until `done` holds; asks again after each wake. False when it was
  // interrupted or the deadline passed.
  bool wait(const std::function<bool()>& done,
            std::optional<Deadline> deadline = std::nullopt);
  // What a waiter waits for may have changed.
  void wake();
  // Every wait, now and later, ends at once.
  void interrupt();
  bool interrupted() const {
    return interrupted_;
  }
  // Waiting makes sense again: the house is to be brought down in order.
  void forget_interrupt();

private:
  void all_done() override;

  std::atomic<std::int64_t> waiting_ = 0;
  std::atomic<bool> interrupted_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
};

} // namespace parlour::actors

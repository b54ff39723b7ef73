// QuiescenceTracker: knows when a node is quiet, which means that no message is
// queued and no handler runs. Every message that asks for something holds an
// InFlight token (actors/protocol/in_flight.hpp) until its handler is done, and
// what the handler sends holds others: the count is zero exactly when nothing
// goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "actors/protocol/in_flight.hpp"

namespace parlour::actors {

// One of each node, in NodeTime. The driving thread waits in wait(); whoever
// drops the last token wakes it.
// Safe to use from any thread. Outlives every token that it gave out.
class QuiescenceTracker : public InFlightCounter {
public:
  using Deadline = std::chrono::steady_clock::time_point;

  // A token; the node is busy until its last copy is dropped.
  InFlight begin();

  // Counts the sessions that wait for an answer from outside.
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
  // Waiting makes sense again: the node is to be brought down in order.
  void forget_interrupt();

private:
  void all_done() override;

  std::atomic<std::int64_t> waiting_ = 0;
  std::atomic<bool> interrupted_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
};

} // namespace parlour::actors

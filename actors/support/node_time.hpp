// NodeTime: the time of one node, what is due in it, and whether something is
// going on. Made by the node, which outlives its actors.
#pragma once

#include <atomic>

#include "actors/protocol/due_times.hpp"
#include "actors/support/main_thread_queue.hpp"
#include "actors/support/quiescence_tracker.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// A due time that is removed wakes those who wait for quiet: what they wait for
// may have become work, or nothing.
struct NodeTime {
  NodeTime(const Clock& its_clock, MainThreadQueue::Kind kind)
      : clock(its_clock), due_times([this] { work.wake(); }),
        main_thread(kind) {}
  NodeTime(const NodeTime&) = delete;
  NodeTime& operator=(const NodeTime&) = delete;

  Timestamp now() const {
    return clock.now();
  }

  const Clock& clock; // outlives it
  QuiescenceTracker work;
  DueTimes due_times;
  MainThreadQueue main_thread;
  // Something did not come to an end in time: what is left of the actors calls
  // nobody outside any more.
  std::atomic<bool> left_behind = false;
};

} // namespace parlour::actors

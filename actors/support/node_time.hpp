// NodeTime: the time of one node, what is due in it, and whether something is
// going on. Made by the node, which outlives its actors.
#pragma once

#include <atomic>

#include "actors/support/due_times.hpp"
#include "actors/support/thread_gate.hpp"
#include "actors/support/work_count.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Safe to use from any thread.
struct NodeTime {
  NodeTime(const Clock& its_clock, ThreadGate::Kind kind)
      : clock(its_clock), due_times([this] { work.wake(); }), gate(kind) {}
  NodeTime(const NodeTime&) = delete;
  NodeTime& operator=(const NodeTime&) = delete;

  Timestamp now() const {
    return clock.now();
  }

  const Clock& clock; // outlives it
  WorkCount work;
  DueTimes due_times;
  ThreadGate gate;
  // Something did not come to an end in time: what is left of the actors calls
  // nobody outside any more.
  std::atomic<bool> left_behind = false;
};

} // namespace parlour::actors

// ManualClock: a clock that the test sets and moves.
#pragma once

#include <atomic>

#include "runtime/base/clock.hpp"

namespace parlour::test {

class ManualClock : public Clock {
public:
  Timestamp now() const override {
    return now_;
  }
  void set(Timestamp time) {
    now_ = time;
  }
  void advance(Milliseconds step) {
    now_ += step.count();
  }

private:
  std::atomic<Timestamp> now_ = parse_timestamp("2026-11-21 09:00").value();
};

} // namespace parlour::test

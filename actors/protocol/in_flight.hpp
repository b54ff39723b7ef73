// InFlight: a token that a message holds until its handler is done. While any
// token is held, the node is busy; when the last one is dropped, it is quiet
// (actors/support/quiescence_tracker.hpp). Tokens may be copied, moved and
// dropped on any thread; copying one costs an atomic addition.
#pragma once

#include <atomic>
#include <cassert>
#include <cstdint>
#include <utility>

namespace parlour::actors {

// Counts the tokens that are held. Must outlive all of them.
class InFlightCounter {
public:
  virtual ~InFlightCounter() = default;

  bool none() const {
    return held_ == 0;
  }
  std::int64_t held() const {
    return held_;
  }

private:
  friend class InFlight;
  // The last token was dropped; called on the thread that dropped it.
  virtual void all_done() = 0;

  std::atomic<std::int64_t> held_ = 0;
};

// Each copy counts on its own. One that is default-constructed or moved from
// holds nothing.
class InFlight {
public:
  InFlight() = default;
  explicit InFlight(InFlightCounter& counter) : InFlight(&counter) {}
  InFlight(const InFlight& other) : InFlight(other.counter_) {}
  InFlight(InFlight&& other) noexcept
      : counter_(std::exchange(other.counter_, nullptr)) {}
  InFlight& operator=(InFlight other) noexcept {
    std::swap(counter_, other.counter_);
    return *this;
  }
  ~InFlight() {
    reset();
  }

  // The count is lowered before all_done() is called: whoever that wakes sees a
  // quiet node.
  void reset() {
    auto* counter = std::exchange(counter_, nullptr);
    if (!counter)
      return;
    const auto left = --counter->held_;
    assert(left >= 0 && "a token was dropped twice");
    if (left == 0)
      counter->all_done();
  }
  explicit operator bool() const {
    return counter_ != nullptr;
  }

private:
  explicit InFlight(InFlightCounter* counter) : counter_(counter) {
    if (counter_)
      ++counter_->held_;
  }

  InFlightCounter* counter_ = nullptr;
};

} // namespace parlour::actors

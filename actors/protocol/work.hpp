// Work: held while what a message asks for is not done, so that it is known
// when the house is quiet (actors/support/work_count.hpp).
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace parlour::actors {

// Counts what is held, and outlives it.
class WorkCounter {
public:
  virtual ~WorkCounter() = default;

  bool none() const {
    return held_ == 0;
  }

private:
  friend class Work;
  // The last is gone; from any thread.
  virtual void all_done() = 0;

  std::atomic<std::int64_t> held_ = 0;
};

// Copies are held on their own; one that is default or moved from is none.
class Work {
public:
  Work() = default;
  explicit Work(WorkCounter& counter) : Work(&counter) {}
  Work(const Work& other) : Work(other.counter_) {}
  Work(Work&& other) noexcept
      : counter_(std::exchange(other.counter_, nullptr)) {}
  Work& operator=(Work other) noexcept {
    std::swap(counter_, other.counter_);
    return *this;
  }
  ~Work() {
    reset();
  }

  void reset() {
    auto* counter = std::exchange(counter_, nullptr);
    if (counter && --counter->held_ == 0)
      counter->all_done();
  }
  explicit operator bool() const {
    return counter_ != nullptr;
  }

private:
  explicit Work(WorkCounter* counter) : counter_(counter) {
    if (counter_)
      ++counter_->held_;
  }

  WorkCounter* counter_ = nullptr;
};

} // namespace parlour::actors

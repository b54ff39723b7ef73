// FailureRecord: when a component that failed is tried again, and when it is
// held for down (engine rule 7.3).
#pragma once

#include <cstdint>
#include <deque>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

class FailureRecord {
public:
  // So many failures within `window`, and it is down.
  static constexpr std::size_t most = 5;
  static constexpr Milliseconds window{60'000};
  // The second failure's; it doubles with each further one.
  static constexpr Milliseconds first_pause{100};
  // The first time that it is down; it doubles each time, up to `longest`.
  static constexpr Milliseconds rest{60'000};
  static constexpr Milliseconds longest_rest{16 * 60'000};

  struct Verdict {
    bool down = false;
    Milliseconds pause{0}; // until another instance is tried

    bool operator==(const Verdict&) const = default;
  };

  // One that fails within `window` of its return from a rest is down at once.
  Verdict failed(Timestamp now);
  // Since the start.
  std::int64_t count() const {
    return count_;
  }

private:
  Verdict go_down(Timestamp now);

  std::deque<Timestamp> recent_;
  std::int64_t count_ = 0;
  Milliseconds last_rest_{0};
  Timestamp returns_ = 0; // from its last rest
};

} // namespace parlour::actors

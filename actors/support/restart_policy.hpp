// RestartPolicy: when a component that failed is tried again, and when it is
// down (engine rule 7.3).
//
//   failure within a minute          what follows
//   1st                              another try at once
//   2nd, 3rd, 4th                    after 100, 200, 400 ms
//   5th                              down for a minute
//   within a minute of its return    down for twice as long, 16 minutes at most
#pragma once

#include <cstdint>
#include <deque>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

// One for each service; called on the supervisor's thread.
class RestartPolicy {
public:
  // With so many failures within `window` it is down.
  static constexpr std::size_t max_failures = 5;
  static constexpr Milliseconds window{60'000};
  // After the second failure; it doubles with each further one.
  static constexpr Milliseconds first_pause{100};
  // How long it is down at first; doubles each time, up to max_down_time.
  static constexpr Milliseconds first_down_time{60'000};
  static constexpr Milliseconds max_down_time{16 * 60'000};

  struct Verdict {
    bool down = false;
    Milliseconds pause{0}; // until another instance is tried

    bool operator==(const Verdict&) const = default;
  };

  // One that fails within `window` of its return is down at once.
  Verdict failed(Timestamp now);
  // Since the start.
  std::int64_t count() const {
    return count_;
  }

private:
  Verdict go_down(Timestamp now);

  std::deque<Timestamp> recent_;
  std::int64_t count_ = 0;
  Milliseconds down_time_{0};
  Timestamp returns_ = 0; // after it was down
};

} // namespace parlour::actors

// Alarm calls a function on a loop at a moment.
#pragma once

#include <memory>

#include "adapters/loop/loop.hpp"

namespace parlour::adapters {

// Used on the loop's thread only (loop.hpp).
class Alarm {
public:
  using Moment = Loop::Moment;
  // What time_point::max() stands for: no moment at all.
  static constexpr Moment never = Moment::max();

  // `action` is called on the loop's thread; it may call or destroy the alarm.
  Alarm(Loop& loop, Loop::Action action);
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;
  ~Alarm();

  // Calls the action once, at this moment or soon after it, instead of at the
  // one that was set before. Cheap if the moment becomes later.
  void set(Moment moment);

private:
  struct State;
  const std::shared_ptr<State> state_;
};

} // namespace parlour::adapters

// Watch waits on a loop for one descriptor at a time. It waits once: whoever
// wants to wait again says so, which is cheap for the same descriptor.
#pragma once

#include <functional>
#include <memory>

#include "adapters/loop/loop.hpp"

namespace parlour::adapters {

// Used on the loop's thread only (loop.hpp). It never owns the descriptor.
class Watch {
public:
  // Called on the loop's thread with an event that was waited for. An error or
  // a hang-up is reported as such an event, too: whoever then reads or writes
  // meets it. Several events that come together may be reported one by one, and
  // rarely nothing can be read any more. It may call or destroy the watch.
  using Ready = std::function<void(short ready)>;

  Watch(Loop& loop, Ready ready);
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch();

  // Waits for POLLIN, POLLOUT or POLLPRI instead of what was waited for before.
  // A descriptor of -1, or no events: waits for nothing, not even a hang-up. A
  // descriptor that cannot be waited for is reported at once.
  void await(int descriptor, short events);
  // Forgets the descriptor. Once it is closed, another one may get its number:
  // call this before the loop is to wait for that one.
  void stop();

private:
  struct State;
  const std::shared_ptr<State> state_;
};

} // namespace parlour::adapters

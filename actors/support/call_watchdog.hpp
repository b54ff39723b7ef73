// CallWatchdog: the call that one instance of a component is in. Its host says
// when a call begins and ends; the supervisor watches from outside and gives up
// an instance whose call does not return.
#pragma once

#include <mutex>
#include <optional>

#include "actors/protocol/interfaces.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// A token for the call is kept here and not on the host's stack: if the call
// hangs, the supervisor drops it, and the node becomes quiet all the same.
class CallWatchdog {
public:
  enum class Begin {
    refused,   // it was given up, and is to be called no more
    watched,   // somebody looks at its calls
    unwatched, // somebody is to look, from now on
  };

  // A call will come that no message holds a token for: `work` is held until
  // the next call that begins without one is over.
  void expect(InFlight work);
  // Before a call; `work` is taken, unless it is refused, and held until the
  // call is over.
  Begin begin(Timestamp now, InFlight& work);
  // After it, `work` is what was taken for it; false where the instance was
  // given up meanwhile, and the work with it.
  bool end(InFlight& work);

  bool in_call() const {
    return call_since().has_value();
  }
  // Nothing: it is in no call.
  std::optional<Timestamp> call_since() const;
  // The next call is to be watched anew: it has less time than the last.
  void watch_anew();
  // How long the call may still take, at most 0 where it should be over. Where
  // there is none, nobody watches any more.
  std::optional<Milliseconds> time_left(Timestamp now, Milliseconds deadline);
  // The call is lost: its tokens are dropped, so that nobody waits for it, and
  // no other call begins. False where it was in no call.
  bool give_up();

private:
  mutable std::mutex mutex_;
  std::optional<Timestamp> since_;
  InFlight work_;
  InFlight expected_;
  bool watched_ = false;
  bool given_up_ = false;
};

} // namespace parlour::actors

// CallWatch: the call that one instance of a component is in, for who watches
// from outside and gives up an instance that does not return.
#pragma once

#include <mutex>
#include <optional>

#include "actors/protocol/interfaces.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Safe to use from any thread.
class CallWatch {
public:
  enum class Begin {
    refused,   // it was given up, and is to be called no more
    watched,   // somebody looks at its calls
    unwatched, // somebody is to look, from now on
  };

  // A call is to come that nobody holds work for: the next one that begins
  // without any.
  void expect(Work work);
  // Before a call; `work` is taken, unless it is refused, and held until the
  // call is over.
  Begin begin(Timestamp now, Work& work);
  // After it, `work` is what was taken for it; false where the instance was
  // given up meanwhile, and the work with it.
  bool end(Work& work);

  bool in_call() const;
  // The next call is to be watched anew: it has less time than the last.
  void watch_anew();
  // How long the call may still take, at most 0 where it should be over. Where
  // there is none, nobody watches any more.
  std::optional<Milliseconds> look(Timestamp now, Milliseconds deadline);
  // The call, where there is one, is held for lost, and what waits for it waits
  // no longer. False where there is none; no other begins in either case.
  bool give_up();

private:
  mutable std::mutex mutex_;
  std::optional<Timestamp> since_;
  Work work_;
  Work expected_;
  bool watched_ = false;
  bool given_up_ = false;
};

} // namespace parlour::actors

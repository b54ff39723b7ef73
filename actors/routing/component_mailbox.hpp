// ComponentMailbox: what waits for a component, in order. Not an actor's own
// mailbox: it outlives the instances, so that a fresh one goes on where another
// broke, and several can share it.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "runtime/base/message.hpp"

namespace parlour::actors {

// One for all who are given it.
using SharedMessage = std::shared_ptr<const Message>;

// Safe to use from any thread.
class ComponentMailbox {
public:
  // More that have arrived are refused; those that an instance has come to are
  // not counted.
  static constexpr std::size_t capacity = 10'000;

  struct Job {
    SharedMessage message; // never null
    Work work;
  };

  // -- senders ---------------------------------------------------------------

  // Null where it was taken; else why not, in words that follow the component's
  // name, and `job` is as it was.
  const char* put(Job& job);

  // -- instances -------------------------------------------------------------

  // Takes part from now on: is sent work_waits when there is something.
  void join(const component_host_actor& host);
  // Takes part no more.
  void leave(const component_host_actor& host);
  // The next job for a host that takes part. Nothing: one that rests is told
  // when there is one.
  enum class IfEmpty : bool { rest, look_again };
  std::optional<Job> take(const component_host_actor& host,
                          IfEmpty then = IfEmpty::rest);

  // It was taken and cannot be done: another does it, before all others.
  void put_back(Job job);

  // -- who keeps the component -----------------------------------------------

  bool empty() const;
  // Nothing is taken in any more, for this reason, until it is opened; what
  // waits can still be taken.
  void close(const char* why);
  void open();
  // All that waits.
  std::vector<Job> take_all();

private:
  using Lock = std::unique_lock<std::mutex>;

  component_host_actor one_to_wake();
  void wake_for_what_waits(Lock front);
  static void wake(const component_host_actor& host);
  void bring_forward(const component_host_actor& host, IfEmpty then);

  // What waits stands at two ends, on cache lines of their own, so that who
  // puts and who takes seldom meet: when nothing is left in front, all that has
  // arrived moves there. Who locks both locks the front first.
  static constexpr std::size_t cache_line = 64;
  struct alignas(cache_line) Back {
    mutable std::mutex mutex;
    std::deque<Job> waiting;
    std::vector<component_host_actor> resting;
    const char* closed = nullptr; // why
  };
  struct alignas(cache_line) Front {
    mutable std::mutex mutex;
    std::deque<Job> waiting;
    std::vector<component_host_actor> members;
  };
  Back back_;
  Front front_;
};

} // namespace parlour::actors

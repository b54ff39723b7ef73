// ComponentMailbox: what waits for a component, in order. Not an actor's own
// mailbox: it outlives the instances, so that a fresh one goes on where another
// broke, and several can share it.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "runtime/base/message.hpp"
#include "runtime/interfaces.hpp"

namespace parlour::actors {

// One for all who are given it.
using SharedMessage = std::shared_ptr<const Message>;

// Safe to use from any thread.
class ComponentMailbox {
public:
  // More waiting messages are refused.
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
  // The next job for a host that takes part; nothing: it is told when there is
  // one.
  std::optional<Job> take(const component_host_actor& host);

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
  // One that rests, to be told outside of the lock; null: none.
  component_host_actor one_to_wake();
  static void wake(const component_host_actor& host);

  mutable std::mutex mutex_;
  std::deque<Job> waiting_;
  std::vector<component_host_actor> members_;
  std::vector<component_host_actor> resting_;
  const char* closed_ = nullptr; // why
};

} // namespace parlour::actors

// ComponentMailbox: the messages that wait for a component, in order. It is no
// actor's own mailbox, because it outlives the instances: a fresh instance goes
// on where another one broke, and the instances of a pool share it. Owned by
// the component's services; the routing table holds it, too.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "runtime/base/metrics.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// One for all who are given it.
using SharedMessage = std::shared_ptr<const Message>;

// A component's hosts are its workers: each takes the next job when it is
// ready, so that a pool shares the work. An idle host is woken by one message
// and then takes as many jobs as there are.
// Safe to use from any thread.
class ComponentMailbox {
public:
  // Of messages that no instance has come to yet; further ones are refused.
  // The bound of architecture rule 5: a component that is this far behind does
  // not catch up. A smaller one would refuse bursts that a slow disk or network
  // makes.
  static constexpr std::size_t capacity = 10'000;

  // A message, and the token that keeps the node busy until it is handled.
  struct Job {
    SharedMessage message; // never null
    InFlight work;
  };

  // -- senders ---------------------------------------------------------------

  // Null where it was taken; else why not, in words that follow the component's
  // name, and `job` is as it was.
  const char* put(Job& job);

  // -- instances -------------------------------------------------------------

  // This host takes messages from now on. It is sent mailbox_ready when there
  // is one.
  void add_worker(const component_host_actor& host);
  // This host takes no more messages.
  void remove_worker(const component_host_actor& host);
  // The next message, for a host that works here. Nothing: the mailbox is
  // empty, and with IfEmpty::go_idle the host is told when that changes.
  enum class IfEmpty : bool { go_idle, poll_again };
  std::optional<Job> take(const component_host_actor& host,
                          IfEmpty then = IfEmpty::go_idle);

  // A host took this message and cannot handle it: another host takes it next.
  void put_back(Job job);

  // -- who keeps the component -----------------------------------------------

  bool empty() const;
  std::size_t size() const; // of all that waits
  // Messages that were put here since it is there, and those that the component
  // got directly, in the turn of a session.
  std::uint64_t received() const {
    return back_.received.value();
  }
  void count_direct() {
    back_.received.add();
  }
  // Refuses new messages until open() is called; `why` follows the component's
  // name in the error. What waits already can still be taken.
  void close(const char* why);
  void open();
  // All that waits.
  // For whoever answers them in the component's place.
  std::vector<Job> take_all();

private:
  using Lock = std::unique_lock<std::mutex>;

  // With the back's lock held.
  bool is_full() const;
  component_host_actor one_to_wake();
  // Takes the front's lock and lets go of it before it wakes anybody.
  void wake_for_what_waits(Lock front);
  static void wake(const component_host_actor& host);
  // With the front's lock held, and the front empty.
  void bring_forward(const component_host_actor& host, IfEmpty then);

  // Two queues, each on a cache line of its own, so that senders and hosts
  // seldom wait for each other's lock: senders append to the back, hosts take
  // from the front, and when the front is empty the whole back moves there.
  // Whoever needs both locks takes the front's first.
  static constexpr std::size_t cache_line = 64;
  struct alignas(cache_line) Back {
    mutable std::mutex mutex;
    std::deque<Job> waiting;
    std::vector<component_host_actor> idle;
    const char* closed = nullptr; // why
    std::size_t moved = 0;        // to the front, when that was last empty
    Counter received;
  };
  struct alignas(cache_line) Front {
    mutable std::mutex mutex;
    std::deque<Job> waiting;
    std::vector<component_host_actor> workers;
    std::atomic<std::size_t> size = 0; // for senders, who hold no lock of it
  };
  Back back_;
  Front front_;
};

} // namespace parlour::actors

// Scheduler: how a node's time passes. In virtual time the driving thread runs
// the actors and jumps from due time to due time; in real time it waits.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <caf/actor_system.hpp>
#include <caf/actor_system_config.hpp>

#include "actors/support/node_time.hpp"

namespace parlour::actors {

// Made by NodeRuntime and owned by it. In virtual time the same actors run as
// in real time; what is different is in here (engine rule 7.5).
class Scheduler {
public:
  virtual ~Scheduler() = default;

  virtual const Clock& clock() const = 0;
  virtual MainThreadQueue::Kind queue_kind() const = 0;
  // Whether plug-ins that block get a thread of their own.
  // True in real time: a call that blocks stops its own thread and no other.
  virtual bool detaches() const = 0;
  virtual void configure(caf::actor_system_config& config) const = 0;
  // Before any other call below.
  virtual void attach(caf::actor_system& system, NodeTime& time) = 0;

  // As Node says.
  virtual bool run_until_quiet() = 0;
  virtual bool step_to_next_due(Milliseconds at_most) = 0;
  virtual void advance(Milliseconds time) = 0;
  // Until quiet, and on to the next due times, if they are at most this far,
  // until there is an answer: what departs may take its time.
  void run_until_answered(const std::function<bool()>& answered,
                          Milliseconds at_most) {
    while (run_until_quiet() && !answered() && step_to_next_due(at_most)) {
    }
  }
  // Until `done`, or at most so long in real time. False if it did not come.
  virtual bool run_until(const std::function<bool()>& done,
                         Milliseconds at_most) = 0;
  // Carries `action` out. False where that takes longer in real time: it then
  // goes on by itself, and whatever it uses has to stay for good.
  virtual bool finish(std::function<void()> action, Milliseconds at_most) = 0;
};

// 0 threads: as many as cores. `start`: what the clock shows when this is made;
// else it is the machine's.
std::unique_ptr<Scheduler>
make_real_time(unsigned threads, std::optional<Timestamp> start = std::nullopt);
std::unique_ptr<Scheduler> make_virtual_time(Timestamp start);

} // namespace parlour::actors

#include <atomic>

#include <caf/scheduler/test_coordinator.hpp>

#include "actors/node/scheduler.hpp"

namespace parlour::actors {

namespace {

// Atomic, as plug-ins may read the time on threads of their own.
class VirtualClock : public Clock {
public:
  explicit VirtualClock(Timestamp start) : now_(start) {}
  Timestamp now() const override {
    return now_;
  }
  void set(Timestamp now) {
    now_ = now;
  }

private:
  std::atomic<Timestamp> now_;
};

// Everything runs on the driving thread, one job after the other, so that
// equal inputs give equal runs.
class VirtualTime : public Scheduler {
public:
  explicit VirtualTime(Timestamp start) : clock_(start) {}

  const Clock& clock() const override {
    return clock_;
  }
  MainThreadQueue::Kind queue_kind() const override {
    return MainThreadQueue::Kind::one_thread;
  }
  bool detaches() const override {
    return false;
  }
  void configure(caf::actor_system_config& config) const override {
    config.set("scheduler.policy", caf::atom("testing"));
  }
  void attach(caf::actor_system& system, NodeTime& time) override {
    scheduler_ =
        dynamic_cast<caf::scheduler::test_coordinator*>(&system.scheduler());
    time_ = &time;
  }

  bool run_until_quiet() override;
  bool step_to_next_due(Milliseconds at_most) override;
  void advance(Milliseconds time) override;
  bool run_until(const std::function<bool()>& done, Milliseconds) override {
    run_until_quiet();
    return done();
  }
  bool finish(std::function<void()> action, Milliseconds) override {
    action();
    return true;
  }

private:
  void jump_to(Timestamp time);

  VirtualClock clock_;
  caf::scheduler::test_coordinator* scheduler_ = nullptr;
  NodeTime* time_ = nullptr;
};

// One message at a time until no actor has any, then what other threads have
// left in the queue, which may give the actors messages again.
bool VirtualTime::run_until_quiet() {
  time_->main_thread.adopt_thread();
  const auto& work = time_->work;
  do {
    while (!work.interrupted() && scheduler_->try_run_once()) {
    }
  } while (!work.interrupted() && time_->main_thread.drain());
  return !work.interrupted();
}

// All that is due at that time happens before this returns: what a timer leads
// to at once has the same time.
bool VirtualTime::step_to_next_due(Milliseconds at_most) {
  if (!run_until_quiet())
    return false;
  const auto next = time_->due_times.next();
  if (!next || next->due > clock_.now() + at_most.count())
    return false;
  jump_to(next->due);
  return run_until_quiet();
}

// From due time to due time, so that each thing happens at its own time: after
// 10 s, a timer of 3 s that repeats has fired at 3, 6 and 9 s.
void VirtualTime::advance(Milliseconds time) {
  const auto end = clock_.now() + time.count();
  while (step_to_next_due(Milliseconds(end - clock_.now()))) {
  }
  if (time_->work.interrupted())
    return;
  jump_to(end);
  run_until_quiet(); // what nobody waits for may have come due, too
}

// Ours first: what CAF's clock sets off asks for the time.
void VirtualTime::jump_to(Timestamp time) {
  const auto step = Milliseconds(time - clock_.now());
  if (step <= Milliseconds::zero())
    return;
  clock_.set(time);
  scheduler_->advance_time(step);
}

} // namespace

std::unique_ptr<Scheduler> make_virtual_time(Timestamp start) {
  return std::make_unique<VirtualTime>(start);
}

} // namespace parlour::actors

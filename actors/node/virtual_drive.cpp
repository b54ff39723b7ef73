#include <atomic>

#include <caf/scheduler/test_coordinator.hpp>

#include "actors/node/drive.hpp"

namespace parlour::actors {

namespace {

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
class VirtualDrive : public Drive {
public:
  explicit VirtualDrive(Timestamp start) : clock_(start) {}

  const Clock& clock() const override {
    return clock_;
  }
  ThreadGate::Kind gate() const override {
    return ThreadGate::Kind::one_thread;
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

bool VirtualDrive::run_until_quiet() {
  time_->gate.belongs_here();
  const auto& work = time_->work;
  do {
    while (!work.interrupted() && scheduler_->try_run_once()) {
    }
  } while (!work.interrupted() && time_->gate.drain());
  return !work.interrupted();
}

bool VirtualDrive::step_to_next_due(Milliseconds at_most) {
  if (!run_until_quiet())
    return false;
  const auto next = time_->due_times.next();
  if (!next || next->due > clock_.now() + at_most.count())
    return false;
  jump_to(next->due);
  return run_until_quiet();
}

void VirtualDrive::advance(Milliseconds time) {
  const auto end = clock_.now() + time.count();
  while (step_to_next_due(Milliseconds(end - clock_.now()))) {
  }
  if (!time_->work.interrupted())
    jump_to(end);
}

// Ours first: what CAF's clock sets off asks for the time.
void VirtualDrive::jump_to(Timestamp time) {
  const auto step = Milliseconds(time - clock_.now());
  if (step <= Milliseconds::zero())
    return;
  clock_.set(time);
  scheduler_->advance_time(step);
}

} // namespace

std::unique_ptr<Drive> make_virtual_drive(Timestamp start) {
  return std::make_unique<VirtualDrive>(start);
}

} // namespace parlour::actors

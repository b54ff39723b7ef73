#include <algorithm>
#include <future>
#include <thread>
#include <utility>

#include "actors/node/scheduler.hpp"

namespace parlour::actors {

namespace {

// Messages that an actor may take before another gets its turn; unlimited by
// default in CAF, which starves the others.
constexpr std::size_t max_throughput = 300;

// The machine's, moved to begin at some other time.
class MovedClock : public Clock {
public:
  explicit MovedClock(std::optional<Timestamp> start)
      : by_(start ? *start - machine_.now() : 0) {}
  Timestamp now() const override {
    return machine_.now() + by_;
  }

private:
  SystemClock machine_;
  const Timestamp by_;
};

// The actors run on CAF's threads and the components on their own; the driving
// thread only waits, and is woken by the tracker of the work in flight.
class RealTime : public Scheduler {
public:
  RealTime(unsigned threads, std::optional<Timestamp> start)
      : clock_(start), threads_(threads) {}

  const Clock& clock() const override {
    return clock_;
  }
  MainThreadQueue::Kind queue_kind() const override {
    return MainThreadQueue::Kind::open;
  }
  bool detaches() const override {
    return true;
  }
  void configure(caf::actor_system_config& config) const override;
  void attach(caf::actor_system&, NodeTime& time) override {
    time_ = &time;
  }

  bool run_until_quiet() override;
  bool step_to_next_due(Milliseconds at_most) override;
  void advance(Milliseconds time) override;
  bool run_until(const std::function<bool()>& done,
                 Milliseconds at_most) override;
  bool finish(std::function<void()> action, Milliseconds at_most) override;

private:
  bool quiet() const;

  MovedClock clock_;
  unsigned threads_;
  NodeTime* time_ = nullptr;
};

void RealTime::configure(caf::actor_system_config& config) const {
  const auto threads =
      threads_ != 0 ? threads_ : std::thread::hardware_concurrency();
  config.set("scheduler.policy", caf::atom("stealing"));
  config.set("scheduler.max-threads",
             static_cast<std::size_t>(std::max(threads, 1u)));
  config.set("scheduler.max-throughput", max_throughput);
}

// An answer that a component's delay stands before is no reason to wait; what
// is overdue is about to be work.
bool RealTime::quiet() const {
  const auto& due_times = time_->due_times;
  return time_->work.none() && !due_times.overdue(clock_.now()) &&
         (!time_->work.sessions_wait() || due_times.component_pending());
}

// Woken whenever the last token is dropped or a due time goes (NodeTime).
bool RealTime::run_until_quiet() {
  return time_->work.wait([this] { return quiet(); });
}

// CAF's clock sets off the timer by itself; here is only waited for it.
bool RealTime::step_to_next_due(Milliseconds at_most) {
  const auto next = time_->due_times.next();
  if (!next || next->due > clock_.now() + at_most.count())
    return false;
  // It is over when whoever waits for it has taken it away.
  auto over = [&] { return !time_->due_times.has(next->id); };
  return time_->work.wait(over) && run_until_quiet();
}

// The whole time, whatever happens in it, unless it is interrupted.
void RealTime::advance(Milliseconds time) {
  time_->work.wait([] { return false; },
                   std::chrono::steady_clock::now() + time);
  run_until_quiet();
}

bool RealTime::run_until(const std::function<bool()>& done,
                         Milliseconds at_most) {
  return time_->work.wait(done, std::chrono::steady_clock::now() + at_most);
}

// On a thread of its own: what does not come to an end can only be left behind,
// not stopped.
bool RealTime::finish(std::function<void()> action, Milliseconds at_most) {
  std::packaged_task<void()> task(std::move(action));
  auto done = task.get_future();
  std::thread thread(std::move(task));
  const bool over = done.wait_for(at_most) == std::future_status::ready;
  if (over)
    thread.join();
  else
    thread.detach();
  return over;
}

} // namespace

std::unique_ptr<Scheduler> make_real_time(unsigned threads,
                                          std::optional<Timestamp> start) {
  return std::make_unique<RealTime>(threads, start);
}

} // namespace parlour::actors

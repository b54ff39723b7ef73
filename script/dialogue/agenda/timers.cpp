#include "script/dialogue/agenda/timers.hpp"

#include <algorithm>
#include <utility>

#include "script/program/timer_limits.hpp"

namespace parlour::dialogue {

// A deadline is watched by the engine, also that of a script's <request>.
void Timers::ring_at(TimerId id, const Timer& timer) {
  const bool of_script =
      timer.purpose == Timer::Purpose::script ||
      (timer.purpose == Timer::Purpose::wait && timer.correlation == 0);
  port_->start_timer(id, timer.due,
                     of_script ? TimerOwner::script : TimerOwner::engine);
}

TimerId Timers::start(Timestamp due, Timer timer) {
  timer.due = due;
  const auto& entry = timers_.emplace_back(++last_, std::move(timer));
  ring_at(last_, entry.second);
  return last_;
}

TimerId Timers::start(Timestamp due, Timer::Purpose purpose) {
  auto& entry = timers_.emplace_back();
  entry.first = ++last_;
  entry.second.purpose = purpose;
  entry.second.due = due;
  ring_at(last_, entry.second);
  return last_;
}

void Timers::resume() {
  for (const auto& [id, timer] : timers_)
    ring_at(id, timer);
}

// From the end: the timers that come and go with each input, such as that of
// silence, are the latest.
Timers::Entries::iterator Timers::find(TimerId id) {
  const auto found =
      std::find_if(timers_.rbegin(), timers_.rend(),
                   [&](const Entry& entry) { return entry.first == id; });
  return found == timers_.rend() ? timers_.end() : found.base() - 1;
}

void Timers::cancel(TimerId id) {
  const auto found = find(id);
  if (found == timers_.end())
    return;
  timers_.erase(found);
  port_->cancel_timer(id);
}

// A timer whose statements are queued already has no entry any more, only a
// ring: stop_scripts stops both.
void Timers::cancel_named(const std::string& name) {
  stop_scripts([&](const auto& timer) { return timer.name == name; });
}

void Timers::cancel_wait(WaitId wait) {
  cancel_where([&](const Timer& timer) {
    return timer.purpose == Timer::Purpose::wait && timer.wait == wait;
  });
}

// The repeating one starts before its statements run, so that they can stop it.
// It counts from now and not from when it was due: after a long pause it rings
// once, and not as often as it would have.
std::optional<Timer> Timers::fired(TimerId id, Timestamp now) {
  const auto found = find(id);
  if (found == timers_.end())
    return std::nullopt;
  auto timer = std::move(found->second);
  timers_.erase(found);
  if (timer.every.count() > 0)
    start(now + timer.every.count(), timer);
  return timer;
}

// One that repeats is told by its name: another of that name takes its place. A
// ring that was stopped does not count, as its statements never run.
std::shared_ptr<Ring> Timers::ring(const Timer& timer) {
  std::erase_if(rings_, [](const auto& ring) { return ring.expired(); });
  const bool goes_on =
      timer.every > Milliseconds::zero() &&
      std::any_of(rings_.begin(), rings_.end(), [&](const auto& known) {
        const auto ring = known.lock();
        return ring->name == timer.name && !ring->stopped;
      });
  if (goes_on)
    return nullptr;
  auto ring = std::make_shared<Ring>();
  ring->name = timer.name;
  ring->visit = timer.visit;
  rings_.push_back(ring);
  return ring;
}

void Timers::cancel_all() {
  cancel_where([](const Timer&) { return true; });
}

bool Timers::any(Timer::Purpose purpose) const {
  return std::any_of(timers_.begin(), timers_.end(), [&](const auto& entry) {
    return entry.second.purpose == purpose;
  });
}

// A <wait> always keeps the session open, and a <timer> as it says; the
// engine's own timers do not (engine rule 3.8).
bool Timers::keep_open() const {
  return std::any_of(timers_.begin(), timers_.end(), [](const auto& entry) {
    const auto& timer = entry.second;
    return timer.keeps_open || timer.purpose == Timer::Purpose::wait;
  });
}

std::vector<std::shared_ptr<Ring>> Timers::ringing() const {
  std::vector<std::shared_ptr<Ring>> rings;
  for (const auto& known : rings_)
    if (auto ring = known.lock())
      rings.push_back(std::move(ring));
  return rings;
}

std::vector<const Timer*> Timers::pending() const {
  std::vector<const Timer*> scripts;
  for (const auto& [id, timer] : timers_)
    if (timer.purpose == Timer::Purpose::script)
      scripts.push_back(&timer);
  return scripts;
}

// Only what scripts start counts: the engine's own timers are few. A timer
// whose place the new one takes does not count.
std::optional<Error> Timers::refuse(const Timer& timer,
                                    std::size_t limit) const {
  std::size_t count = 1;
  auto bytes = timer.bytes;
  for (const auto& [id, other] : timers_) {
    if (other.purpose != Timer::Purpose::script &&
        other.purpose != Timer::Purpose::wait)
      continue;
    if (timer.purpose == Timer::Purpose::script &&
        other.purpose == Timer::Purpose::script && other.name == timer.name)
      continue;
    ++count;
    bytes += other.bytes;
  }
  return script::refuse_timers(count, bytes, limit);
}

} // namespace parlour::dialogue

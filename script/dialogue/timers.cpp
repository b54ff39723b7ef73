#include "script/dialogue/timers.hpp"

#include <algorithm>
#include <utility>

#include "script/timer_limits.hpp"

namespace parlour::dialogue {

TimerId Timers::start(Milliseconds after, Timer timer) {
  timers_.emplace_back(++last_, std::move(timer));
  port_->start_timer(last_, after);
  return last_;
}

TimerId Timers::start(Milliseconds after, Timer::Purpose purpose) {
  auto& entry = timers_.emplace_back();
  entry.first = ++last_;
  entry.second.purpose = purpose;
  port_->start_timer(last_, after);
  return last_;
}

// The latest are the likeliest.
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

template <class Predicate>
void Timers::cancel_where(Predicate predicate) {
  std::erase_if(timers_, [&](const auto& entry) {
    if (!predicate(entry.second))
      return false;
    port_->cancel_timer(entry.first);
    return true;
  });
}

void Timers::cancel_named(const std::string& name) {
  cancel_where([&](const Timer& timer) {
    return timer.purpose == Timer::Purpose::script && timer.name == name;
  });
}

void Timers::cancel_wait(WaitId wait) {
  cancel_where([&](const Timer& timer) {
    return timer.purpose == Timer::Purpose::wait && timer.wait == wait;
  });
}

std::optional<Timer> Timers::fired(TimerId id) {
  const auto found = find(id);
  if (found == timers_.end())
    return std::nullopt;
  auto timer = std::move(found->second);
  timers_.erase(found);
  if (timer.every.count() > 0)
    start(timer.every, timer);
  return timer;
}

void Timers::cancel_all() {
  cancel_where([](const Timer&) { return true; });
}

bool Timers::any(Timer::Purpose purpose) const {
  return std::any_of(timers_.begin(), timers_.end(), [&](const auto& entry) {
    return entry.second.purpose == purpose;
  });
}

std::optional<Error> Timers::refuse(const Timer& timer,
                                    std::size_t limit) const {
  std::size_t count = 1;
  auto bytes = timer.bytes;
  for (const auto& [id, other] : timers_) {
    if (other.purpose != Timer::Purpose::script)
      continue;
    ++count;
    bytes += other.bytes;
  }
  return script::refuse_timers(count, bytes, limit);
}

} // namespace parlour::dialogue

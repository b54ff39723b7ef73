#include "actors/protocol/due_times.hpp"

#include <algorithm>
#include <utility>

namespace parlour::actors {

DueTimes::DueTimes(std::function<void()> changed)
    : changed_(std::move(changed)) {}

DueTimes::Id DueTimes::add(Timestamp due, Of of) {
  std::lock_guard lock(mutex_);
  pending_[++last_] = {due, of};
  return last_;
}

// Whoever waits for this time (RealTime::step_to_next_due) is woken outside of
// the lock, as it asks for it.
void DueTimes::remove(Id id) {
  std::unique_lock lock(mutex_);
  const bool was_there = pending_.erase(id) != 0;
  lock.unlock();
  if (was_there)
    changed_();
}

bool DueTimes::has(Id id) const {
  std::lock_guard lock(mutex_);
  return pending_.count(id) != 0;
}

// A search through all: there are as many as timers and delays, which is few,
// and they are added far more often than asked for.
std::optional<DueTimes::Entry> DueTimes::next() const {
  std::lock_guard lock(mutex_);
  auto earlier = [](const auto& one, const auto& other) {
    return one.second.due < other.second.due;
  };
  auto first = std::min_element(pending_.begin(), pending_.end(), earlier);
  if (first == pending_.end())
    return std::nullopt;
  return Entry{first->first, first->second.due};
}

std::optional<Timestamp> DueTimes::next_of_sessions() const {
  std::lock_guard lock(mutex_);
  std::optional<Timestamp> first;
  for (const auto& [id, pending] : pending_)
    if (pending.of == Of::session && (!first || pending.due < *first))
      first = pending.due;
  return first;
}

bool DueTimes::overdue(Timestamp now) const {
  auto first = next();
  return first && first->due <= now;
}

bool DueTimes::component_pending() const {
  std::lock_guard lock(mutex_);
  return std::any_of(pending_.begin(), pending_.end(), [](const auto& entry) {
    return entry.second.of == Of::component;
  });
}

DueTicket::DueTicket(DueTicket&& other) noexcept
    : times_(std::exchange(other.times_, nullptr)), id_(other.id_) {}

DueTicket& DueTicket::operator=(DueTicket&& other) noexcept {
  std::swap(times_, other.times_);
  std::swap(id_, other.id_);
  return *this;
}

DueTicket::~DueTicket() {
  if (times_)
    times_->remove(id_);
}

} // namespace parlour::actors

#include "actors/protocol/due_times.hpp"

#include <utility>

namespace parlour::actors {

DueTimes::DueTimes(std::function<void()> changed)
    : changed_(std::move(changed)) {}

DueTimes::Id DueTimes::add(Timestamp due, Of of) {
  std::lock_guard lock(mutex_);
  pending_[++last_] = {due, of};
  in_order(of).emplace(due, last_);
  return last_;
}

// Whoever waits for this time (RealTime::step_to_next_due) is woken outside of
// the lock, as it asks for it.
void DueTimes::remove(Id id) {
  std::unique_lock lock(mutex_);
  const auto found = pending_.find(id);
  if (found == pending_.end())
    return;
  in_order(found->second.of).erase({found->second.due, id});
  pending_.erase(found);
  lock.unlock();
  changed_();
}

bool DueTimes::has(Id id) const {
  std::lock_guard lock(mutex_);
  return pending_.count(id) != 0;
}

// Ids rise, so that of equal times the smaller pair is the one added first.
std::optional<DueTimes::Entry> DueTimes::next() const {
  std::lock_guard lock(mutex_);
  const std::pair<Timestamp, Id>* first = nullptr;
  for (const auto& all : in_order_)
    if (!all.empty() && (!first || *all.begin() < *first))
      first = &*all.begin();
  if (!first)
    return std::nullopt;
  return Entry{first->second, first->first};
}

std::optional<Timestamp> DueTimes::next_of_sessions() const {
  std::lock_guard lock(mutex_);
  const auto& all = in_order(Of::session);
  if (all.empty())
    return std::nullopt;
  return all.begin()->first;
}

bool DueTimes::overdue(Timestamp now) const {
  auto first = next();
  return first && first->due <= now;
}

bool DueTimes::component_pending() const {
  std::lock_guard lock(mutex_);
  return !in_order(Of::component).empty();
}

DueTicket::DueTicket(DueTicket&& other) noexcept
    : times_(std::exchange(other.times_, nullptr)), id_(other.id_) {}

// What this one had goes with `other`.
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

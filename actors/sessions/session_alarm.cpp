#include "actors/sessions/session_alarm.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

namespace parlour::actors {

namespace {

// CAF keeps a session that has ended as long as a wake_up is on its way to it,
// which must not be a day.
constexpr Milliseconds longest_wait{600'000};

} // namespace

void SessionAlarm::set(dialogue::TimerId id, Timestamp due) {
  watches_.push_back(
      {id, due,
       DueTicket(time_.due_times,
                 time_.due_times.add(due, DueTimes::Of::session))});
  wake_at(due);
}

void SessionAlarm::cancel(dialogue::TimerId id) {
  std::erase_if(watches_, [&](const Watch& watch) { return watch.id == id; });
}

void SessionAlarm::cancel_all() {
  watches_.clear();
}

// What is set later than that is looked at when the session wakes: most is
// cancelled before.
void SessionAlarm::wake_at(Timestamp due) {
  if (wakes_at_ && *wakes_at_ <= due)
    return;
  const auto wait = std::clamp(Milliseconds(due - time_.now()), Milliseconds(0),
                               longest_wait);
  wakes_at_ = time_.now() + wait.count();
  if (wait > Milliseconds::zero())
    self_->delayed_send(self_, wait, wake_up{});
  else
    self_->send(self_, wake_up{});
}

// A wake_up that was overtaken by an earlier one comes all the same, and finds
// nothing due.
void SessionAlarm::wake() {
  const auto now = time_.now();
  if (wakes_at_ && *wakes_at_ <= now)
    wakes_at_.reset();
  const auto due = std::stable_partition(
      watches_.begin(), watches_.end(),
      [&](const Watch& watch) { return watch.due > now; });
  std::vector<Watch> over(std::make_move_iterator(due),
                          std::make_move_iterator(watches_.end()));
  watches_.erase(due, watches_.end());
  std::ranges::stable_sort(over, {}, &Watch::due);
  // The session's work begins before the due time goes with its ticket.
  for (const auto& watch : over)
    bus_.ring(session_actor(self_), {watch.id, time_.work.begin()});
  for (const auto& watch : watches_)
    wake_at(watch.due);
}

} // namespace parlour::actors

#include "actors/support/pending_requests.hpp"

#include <algorithm>
#include <utility>

#include "runtime/message/replies.hpp"

namespace parlour::actors {

// Where there are too many, the oldest loses its early error: its sender's
// time-out is left.
void PendingRequests::given(const Message& message, Timestamp now) {
  if (message.correlation == 0 || !wants_answer(message.command))
    return;
  forget_old(now);
  if (entries_.size() == max_entries)
    entries_.pop_front();
  entries_.push_back({now, message.correlation, message.session});
}

// Progress events carry the same correlation and end nothing.
void PendingRequests::said(const Message& event) {
  if (event.correlation == 0 || entries_.empty())
    return;
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.correlation == event.correlation &&
               entry.session == event.session;
      });
  if (found != entries_.end() && is_answer(event.command))
    entries_.erase(found);
}

// A command that no role of the component knows may want one: it is kept.
bool PendingRequests::wants_answer(const std::string& command) const {
  for (const auto& name : roles_)
    if (const auto* role = find_role(name))
      if (const auto* known = role->command(command))
        return known->answered;
  return true;
}

// As a session would take it.
bool PendingRequests::is_answer(const std::string& command) const {
  return find_reply(command, roles_, own_events_) != Reply::none;
}

bool PendingRequests::none(Timestamp now) {
  forget_old(now);
  return entries_.empty();
}

std::vector<Message> PendingRequests::take(Timestamp now) {
  forget_old(now);
  std::vector<Message> messages;
  for (auto& entry : std::exchange(entries_, {})) {
    Message message;
    message.correlation = entry.correlation;
    message.session = std::move(entry.session);
    messages.push_back(std::move(message));
  }
  return messages;
}

void PendingRequests::forget_old(Timestamp now) {
  while (!entries_.empty() && entries_.front().since <= now - patience.count())
    entries_.pop_front();
}

} // namespace parlour::actors

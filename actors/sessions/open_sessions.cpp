#include "actors/sessions/open_sessions.hpp"

namespace parlour::actors {

// The latest actor has the highest id: it is added at the end, without a
// search.
void OpenSessions::add(const SessionId& id, const session_actor& session,
                       const seat_actor& seat) {
  directory_->add(id, session, seat);
  at_seat_[seat.id()] = session.id();
  sessions_.emplace_hint(sessions_.end(), session.id(),
                         Entry{id, session, seat});
}

std::optional<OpenSessions::Entry> OpenSessions::remove(const SessionId& id) {
  const auto* entry = find(id);
  if (!entry)
    return std::nullopt;
  directory_->remove(id);
  at_seat_.erase(entry->seat.id());
  return std::move(sessions_.extract(entry->session.id()).mapped());
}

OpenSessions::Entry* OpenSessions::find(const SessionId& id) {
  const auto session = directory_->find(id);
  return session ? find(session.id()) : nullptr;
}

OpenSessions::Entry* OpenSessions::find(caf::actor_id session) {
  const auto found = sessions_.find(session);
  return found == sessions_.end() ? nullptr : &found->second;
}

OpenSessions::Entry* OpenSessions::at(const seat_actor& seat) {
  const auto found = at_seat_.find(seat.id());
  return found == at_seat_.end() ? nullptr : find(found->second);
}

} // namespace parlour::actors

#include "actors/session_manager.hpp"

#include <utility>

#include "actors/session.hpp"

namespace parlour::actors {

namespace {

using Self = session_manager_actor::stateful_pointer<session_manager_state>;

session_opened open(Self self, Services& services, const open_session& what) {
  auto id = services.new_session_id();
  auto session = self->spawn<caf::monitored>(
      actors::session, &services,
      SessionOrder{id, services.new_seed(), what.seat});
  services.sessions.add(id, session);
  self->send(session, begin_session{what.work});
  self->state.sessions[id] = {std::move(session), what.seat};
  return {std::move(id)};
}

// Turns that a session left unread begin the seat's next one (a goodbye and a
// further turn in one row); answers to the old one mean nothing to it.
SessionId begin_next(Self self, Services& services, const seat_actor& seat,
                     const session_gone& what) {
  std::vector<Message> turns;
  for (const auto& message : what.unread)
    if (message.correlation == 0)
      turns.push_back(message);
  if (turns.empty())
    return {};
  auto id = open(self, services, open_session{seat, what.work}).session;
  for (auto& turn : turns)
    turn.session = id;
  self->send(self->state.sessions[id].session,
             deliver{std::move(turns), what.work});
  return id;
}

void forget(Self self, Services& services, const session_gone& what) {
  auto entry = self->state.sessions.extract(what.session);
  services.sessions.remove(what.session);
  if (entry.empty())
    return;
  const auto& seat = entry.mapped().seat;
  auto next = begin_next(self, services, seat, what);
  self->send(seat, session_over{what.session, what.work, std::move(next)});
}

// A session that ended without a word: its actor was lost to an exception.
void notice_loss(Self self, Services& services, const caf::down_msg& down) {
  for (const auto& [id, entry] : self->state.sessions)
    if (entry.session.address() == down.source) {
      services.log("session " + id +
                   " was lost: " + self->system().render(down.reason));
      forget(self, services, {SessionId(id), services.work.begin()});
      return;
    }
}

void pass_on(Self self, Services& services, const Message& message,
             const Work& work) {
  auto found = self->state.sessions.find(message.session);
  if (found != self->state.sessions.end())
    self->send(found->second.session, deliver{{message}, work});
  else if (!message.session.empty())
    services.unhandled(message, "its session is over");
  else if (services.table.load()->subscribed(message))
    for (const auto& [id, entry] : self->state.sessions)
      self->send(entry.session, deliver{{message}, work});
  else if (message.source != "System") // raised for those who listen
    services.unhandled(message, "no session listens to it");
}

void close(Self self, const close_session& what) {
  for (const auto& [id, entry] : self->state.sessions)
    if (what.session.empty() || what.session == id)
      self->send(entry.session, end_session{what.work});
}

} // namespace

session_manager_actor::behavior_type session_manager(
    session_manager_actor::stateful_pointer<session_manager_state> self,
    Services* services) {
  self->set_down_handler(
      [=](const caf::down_msg& down) { notice_loss(self, *services, down); });
  return {
      [=](const open_session& what) { return open(self, *services, what); },
      [=](const forward& what) {
        for (const auto& message : what.messages)
          pass_on(self, *services, message, what.work);
      },
      [=](const close_session& what) { close(self, what); },
      [=](const session_gone& what) { forget(self, *services, what); },
  };
}

} // namespace parlour::actors

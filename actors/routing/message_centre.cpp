#include "actors/routing/message_centre.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

using Self = message_centre_actor::stateful_pointer<message_centre_state>;

// What goes to one session together: a row of turns stays a row.
struct Batch {
  const InFlight& work;
  Nanoseconds arrived;
  SessionId session = {};
  std::vector<Message> messages = {};
  // A message for all sessions goes by the manager. What follows takes the same
  // way, so that no session gets it earlier.
  bool by_manager = false;
};

// A session that the directory does not know, as it has ended, is the
// manager's: it may take a late turn to the seat's next session.
void flush(Self self, Batch& batch) {
  if (batch.messages.empty())
    return;
  auto messages = std::exchange(batch.messages, {});
  batch.by_manager |= batch.session.empty();
  if (auto session = self->state.sessions->find(batch.session);
      session && !batch.by_manager)
    self->send(session,
               deliver{std::move(messages), batch.work, batch.arrived});
  else
    self->send(self->state.manager, forward{std::move(messages), batch.work});
}

// What a query or an ask waits for goes to that actor, and to no session. A
// change of the session ends the row.
void add(Self self, Batch& batch, Message message) {
  if (auto query = self->state.bus->replies().take(message.correlation)) {
    self->send(query, component_event{std::move(message), batch.work});
    return;
  }
  if (batch.session != message.session)
    flush(self, batch);
  batch.session = message.session;
  batch.messages.push_back(std::move(message));
}

std::string counted(const Counters& counters) {
  return std::to_string(counters.messages()) + " messages routed, " +
         std::to_string(counters.unhandled) + " taken by nobody";
}

// Messages of one session that follow each other stay together: "two lines
// entered at once" reach the session as one row (engine rule 3.1).
void give(Self self, std::vector<Message> messages, const InFlight& work,
          Nanoseconds arrived = 0) {
  Batch batch{work, arrived};
  for (auto& message : messages)
    add(self, batch, std::move(message));
  flush(self, batch);
}

} // namespace

message_centre_actor::behavior_type message_centre(
    message_centre_actor::stateful_pointer<message_centre_state> self,
    MessageBus* bus, const SessionDirectory* sessions,
    session_manager_actor manager) {
  self->state = {bus, sessions, std::move(manager)};
  return traced<message_centre_actor::behavior_type>(
      ActorTrace(bus->observer(), message_centre_state::name, ""),
      [=](publish& what) {
        give(self, bus->route(std::move(what.messages)), what.work,
             what.arrived);
      },
      [=](distribute& what) {
        give(self, std::move(what.messages), what.work);
      },
      [=](const retire& what) { self->send(what.session, leave{what.work}); },
      [=](const ring& what) { self->send(what.session, what.what); },
      [=](const get_status& what) {
        return tell_status(self, what, {{}, counted(bus->counters())});
      });
}

} // namespace parlour::actors

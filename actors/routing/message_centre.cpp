#include "actors/routing/message_centre.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

namespace parlour::actors {

namespace {

using Self = message_centre_actor::stateful_pointer<message_centre_state>;

// What goes to one session together: a row of turns stays a row.
struct Batch {
  SessionId session;
  std::vector<Message> messages;
};

void flush(Self self, Batch& batch, const Work& work) {
  if (batch.messages.empty())
    return;
  auto messages = std::exchange(batch.messages, {});
  if (auto session = self->state.sessions->find(batch.session))
    self->send(session, deliver{std::move(messages), work});
  else
    self->send(self->state.manager, forward{std::move(messages), work});
}

void add(Self self, Batch& batch, Message message, const Work& work) {
  if (auto query = self->state.bus->claims().take(message.correlation)) {
    self->send(query, component_event{std::move(message), work});
    return;
  }
  if (batch.session != message.session)
    flush(self, batch, work);
  batch.session = message.session;
  batch.messages.push_back(std::move(message));
}

void give(Self self, std::vector<Message> messages, const Work& work) {
  Batch batch;
  for (auto& message : messages)
    add(self, batch, std::move(message), work);
  flush(self, batch, work);
}

} // namespace

message_centre_actor::behavior_type message_centre(
    message_centre_actor::stateful_pointer<message_centre_state> self,
    MessageBus* bus, const SessionDirectory* sessions,
    session_manager_actor manager) {
  self->state = {bus, sessions, std::move(manager)};
  return {
      [=](publish& what) {
        give(self, bus->route(std::move(what.messages)), what.work);
      },
      [=](distribute& what) {
        give(self, std::move(what.messages), what.work);
      },
      [=](const retire& what) { self->send(what.session, leave{what.work}); },
  };
}

} // namespace parlour::actors

#include "actors/sessions/query.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/routing/outcomes.hpp"
#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

using Self = query_actor::stateful_pointer<query_state>;

const char* command_of(dialogue::QueryRequest::Kind kind) {
  constexpr const char* commands[] = {"Query", "Begin", "Commit", "Rollback"};
  return commands[static_cast<std::size_t>(kind)];
}

// A transaction's commands have no parameters: the session says which
// transaction it is.
Message as_message(const QueryOrder& order, Correlation correlation) {
  const auto& request = order.request;
  Message message;
  message.source = "Session";
  message.command = command_of(request.kind);
  if (request.kind == dialogue::QueryRequest::Kind::query)
    message.params = {request.sql, request.values, request.write};
  message.sinks = {request.database.empty() ? std::string("Database")
                                            : request.database};
  message.session = order.session_id;
  message.correlation = correlation;
  return message;
}

// The session's token begins before this actor, and its due time, goes.
void finish(Self self, const session_actor& session, std::uint64_t id,
            Expected<Value> outcome) {
  auto work = self->state.time->work.begin();
  self->send(session, query_outcome{id, std::move(outcome), std::move(work)});
  self->quit();
}

// Nobody knows what became of a commit that was not answered.
Expected<Value> silence_of(dialogue::QueryRequest::Kind kind) {
  if (kind == dialogue::QueryRequest::Kind::commit)
    return fail(ErrorKind::in_doubt, "the database did not answer in time; "
                                     "whether the transaction is kept is not "
                                     "known");
  return fail(ErrorKind::timeout, "the database did not answer in time");
}

} // namespace

query_state::~query_state() {
  if (bus)
    bus->replies().forget(correlation);
}

// The correlation is registered before the question leaves: the answer may come
// on another thread at once.
query_actor::behavior_type
query(query_actor::stateful_pointer<query_state> self, NodeTime* time,
      MessageBus* bus, session_actor session, QueryOrder order) {
  auto& state = self->state;
  state.time = time;
  state.bus = bus;
  state.ticket = DueTicket(time->due_times, order.due);
  state.correlation = bus->replies().add(query_actor(self));
  self->delayed_send(self, order.timeout, give_up{});
  const auto id = order.request.id;
  if (!bus->ask(as_message(order, state.correlation), order.work))
    finish(self, session, id,
           fail(ErrorKind::offline, "no database component is there"));
  return traced<query_actor::behavior_type>(
      ActorTrace(bus->observer(), query_state::name, std::to_string(id),
                 order.session_id),
      [=](const component_event& what) {
        finish(self, session, id, outcome_of(what.event));
      },
      [=](const give_up&) {
        finish(self, session, id, silence_of(order.request.kind));
      },
      [=](const get_status& what) {
        return tell_status(
            self, what,
            {std::to_string(id),
             "waits for " + std::string(command_of(order.request.kind))});
      });
}

} // namespace parlour::actors

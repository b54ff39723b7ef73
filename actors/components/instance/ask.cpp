#include "actors/components/instance/ask.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"
#include "runtime/message/replies.hpp"

namespace parlour::actors {

namespace {

using Self = query_actor::stateful_pointer<ask_state>;

// True where somebody took the question.
bool send(Self self, const ask_component& order) {
  auto& state = self->state;
  auto request = order.request;
  request.correlation = state.correlation;
  return state.bus->ask(std::move(request), order.work);
}

std::string asked(const ask_component& order) {
  const auto& sinks = order.request.sinks;
  return sinks.empty() ? std::string() : sinks.front();
}

Error nobody_there(const ask_component& order) {
  return {ErrorKind::offline,
          "nobody fills the role or has the name '" + asked(order) + "'",
          {}};
}

// "Weather did not answer Forecast in time".
Error silence(const ask_component& order) {
  return {ErrorKind::timeout,
          asked(order) + " did not answer " + order.request.command +
              " in time",
          {}};
}

} // namespace

ask_state::~ask_state() {
  if (bus)
    bus->replies().forget(correlation);
}

// It ends with the host that it works for: nobody could be called back then.
//
// It wants all events with its correlation, not only the first: one that is
// neither reply nor refusal, such as progress, ends nothing.
query_actor::behavior_type ask(Self self, MessageBus* bus,
                               component_host_actor host, ask_component order) {
  self->state.bus = bus;
  self->state.correlation =
      bus->replies().add(query_actor(self), ReplyRegistry::Wants::all);
  self->monitor(host);
  self->set_down_handler([self](const caf::down_msg&) { self->quit(); });
  auto finish = [self, finished = order.finished](Expected<Message> outcome) {
    finished(std::move(outcome));
    self->quit();
  };
  if (send(self, order))
    self->delayed_send(self, order.patience, give_up{});
  else
    finish(tl::make_unexpected(nobody_there(order)));
  order.work.reset();
  return traced<query_actor::behavior_type>(
      ActorTrace(bus->observer(), ask_state::name, order.request.source,
                 order.request.session),
      [=](const component_event& what) {
        const auto table = bus->table();
        const auto reply = table->reply_to_request(what.event);
        if (reply == Reply::refusal)
          finish(tl::make_unexpected(refusal_of(
              what.event, table->is_source("Database", what.event.source))));
        else if (reply == Reply::answer)
          finish(what.event);
      },
      [=](const give_up&) { finish(tl::make_unexpected(silence(order))); },
      [=](const get_status& what) {
        return tell_status(self, what,
                           {order.request.source, "waits for " + asked(order) +
                                                      " to answer " +
                                                      order.request.command});
      });
}

} // namespace parlour::actors

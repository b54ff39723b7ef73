#include "actors/routing/services.hpp"

#include <utility>

#include <caf/send.hpp>

#include "actors/routing/hand_over.hpp"

namespace parlour::actors {

namespace {

void carry(Services& services, Message&& message, Timestamp now, Work& held,
           std::vector<Message>& rest, Answers answers = Answers::yes) {
  const auto table = services.table.load();
  if (!table)
    return; // the house is down
  auto routed = table->route(std::move(message), now);
  services.unreached(routed);
  for (auto& [target, sent] : routed.deliveries) {
    if (!held)
      held = services.time.work.begin();
    auto answer =
        hand_over(services, *target, {std::move(sent), std::move(held)});
    if (answer && answers == Answers::yes)
      carry(services, std::move(*answer), now, held, rest, Answers::no);
  }
  if (routed.rest)
    rest.push_back(std::move(*routed.rest));
}

void pass_to_centre(Services& services, std::vector<Message> messages) {
  if (!messages.empty() && services.centre)
    caf::anon_send(services.centre,
                   distribute{std::move(messages), services.time.work.begin()});
}

} // namespace

void Services::publish(Message&& message, Timestamp now, Work held) {
  if (time.gate.keeps_out())
    return publish(std::vector{std::move(message)});
  std::vector<Message> rest;
  carry(*this, std::move(message), now, held, rest);
  pass_to_centre(*this, std::move(rest));
}

void Services::publish(std::vector<Message> messages) {
  time.gate.enter([this, messages = std::move(messages),
                   waits = time.work.begin()]() mutable {
    pass_to_centre(*this, route(std::move(messages)));
  });
}

void Services::bring_in(std::vector<Message> messages) {
  time.gate.enter([this, messages = std::move(messages),
                   waits = time.work.begin()]() mutable {
    if (centre)
      caf::anon_send(centre, actors::publish{std::move(messages), waits});
  });
}

std::vector<Message> Services::route(std::vector<Message> messages) {
  std::vector<Message> rest;
  Work held;
  for (auto& message : messages)
    carry(*this, std::move(message), time.now(), held, rest);
  return rest;
}

void Services::unhandled(const Message& message, const std::string& why) {
  if (const auto now = table.load(); now && now->is_routine(message))
    return;
  ++counters->unhandled;
  Inspection inspection;
  inspection.kind = InspectionKind::unhandled;
  inspection.session = message.session;
  inspection.subject = message.source + "." + message.command;
  inspection.detail = why;
  inspection.message = std::make_shared<const Message>(message);
  observer.inspect(std::move(inspection));
}

void Services::unreached(const Routed& routed) {
  for (const auto& [sink, message] : routed.unreached)
    unhandled(*message, "nobody is there for " + sink);
}

void Services::failed(const Message& message, const Error& error) {
  Inspection inspection;
  inspection.kind = InspectionKind::error;
  inspection.session = message.session;
  inspection.subject = name_of(error.kind);
  inspection.detail = to_string(error);
  observer.inspect(std::move(inspection));
}

bool Services::is_heard(const Message& message) const {
  const auto current = table.load();
  return current && !message.params.empty() &&
         current->is_source("ASR", message.source);
}

} // namespace parlour::actors

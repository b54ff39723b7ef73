#include "actors/routing/hand_over.hpp"

#include <utility>

#include "actors/routing/services.hpp"

namespace parlour::actors {

namespace {

// As ComponentMailbox::put says.
const char* put(const Target& target, ComponentMailbox::Job& job) {
  if (!target.branches)
    return target.mailbox->put(job);
  const auto mailbox = target.mailbox_of(job.message->session);
  return mailbox ? mailbox->put(job) : "has no instance for that session";
}

} // namespace

Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason) {
  Message event;
  event.source = component;
  event.command = "Failed";
  event.params = {reason};
  event.session = message.session;
  event.correlation = message.correlation;
  event.rounds = message.rounds + 1;
  return event;
}

std::optional<Message> hand_over(Services& services, const Target& target,
                                 ComponentMailbox::Job job) {
  const auto* why = put(target, job);
  if (!why)
    return std::nullopt;
  const auto reason = target.name + " " + why;
  services.unhandled(*job.message, reason);
  if (job.message->correlation == 0)
    return std::nullopt;
  return failure_answer(target.name, *job.message, reason);
}

bool ask_by_table(Services& services, Message question, const Work& work) {
  const auto table = services.table.load();
  auto routed = table->route(std::move(question));
  bool taken = false;
  for (auto& [target, sent] : routed.deliveries)
    taken |= !hand_over(services, *target, {std::move(sent), work});
  return taken;
}

} // namespace parlour::actors

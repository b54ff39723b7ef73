// The part of supervision that says what others hear of components: the table,
// the events of System, and the answers in place of an instance's own.
#include <algorithm>
#include <utility>

#include "actors/components/supervision.hpp"

namespace parlour::actors {

// -- the table ----------------------------------------------------------------

void Supervision::publish_table() {
  std::vector<KeptPointer> order;
  for (const auto& [name, kept] : kept_)
    order.push_back(kept);
  std::ranges::sort(order, {}, &Kept::rank);
  std::vector<Target> targets;
  for (const auto& kept : order) {
    Target target;
    target.name = kept->order.name;
    target.roles = kept->order.factory.description.roles;
    target.events = kept->order.factory.description.events;
    if (kept->by_session) {
      target.branches = kept->by_session;
    } else {
      const auto& house = *kept->branches.at(house_->name());
      target.mailbox = house.component->mailbox;
      target.direct = house.direct;
      target.up = house.component->up;
    }
    targets.push_back(std::move(target));
  }
  parts_.bus.set_targets(std::move(targets));
}

// -- events -------------------------------------------------------------------

// One session's own is told to that one, if it listens; else all that do.
void Supervision::tell(const char* event, std::vector<Value> params,
                       const SessionId& session) {
  Message message;
  message.source = "System";
  message.command = event;
  message.params = std::move(params);
  message.session = session;
  if (session.empty() || (parts_.sessions.find(session) &&
                          parts_.bus.table()->is_listened_to(message)))
    parts_.bus.publish({std::move(message)});
}

void Supervision::tell_up(const Component& component,
                          const SessionId& session) {
  const auto& roles = component.description().roles;
  tell("ComponentUp",
       {component.name(), roles.empty() ? Value() : Value(roles.front())},
       session);
}

// -- answers ------------------------------------------------------------------

void Supervision::answer_by_failure(const Branch& branch,
                                    const std::vector<Message>& messages,
                                    const std::string& reason) {
  std::vector<Message> answers;
  for (const auto& message : messages)
    if (message.correlation != 0)
      answers.push_back(failure_answer(branch.name(), message, reason));
  if (!answers.empty() && !closing_ && !branch.over)
    parts_.bus.publish(std::move(answers));
}

void Supervision::answer_what_waits(const Branch& branch,
                                    const std::string& reason) {
  std::vector<Message> messages;
  for (auto& job : branch.component->mailbox->take_all()) {
    if (branch.over)
      parts_.bus.unhandled(*job.message, branch.name() + ": " + reason);
    messages.push_back(*job.message);
  }
  answer_by_failure(branch, messages, reason);
}

// So that virtual time stops there, and nobody thinks that nothing is due.
DueTicket Supervision::ticket(Milliseconds delay) {
  const auto due = parts_.time.now() + delay.count();
  return {parts_.time.due_times,
          parts_.time.due_times.add(due, DueTimes::Of::component)};
}

} // namespace parlour::actors

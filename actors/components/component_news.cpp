#include "actors/components/component_news.hpp"

#include <utility>

namespace parlour::actors {

namespace {

// A component with an instance for each seat or session has no mailbox here:
// the sender finds it by the message's session.
Target target_of(const Deployment& deployment) {
  const auto& description = deployment.order.factory.description;
  Target target;
  target.name = deployment.name();
  target.roles = description.roles;
  target.events = description.events;
  target.by_session = deployment.by_session;
  if (deployment.by_session)
    return target;
  const auto& service = *deployment.services.begin()->second; // the node's
  target.mailbox = service.component->mailbox;
  target.direct = service.direct;
  target.up = service.component->up;
  return target;
}

} // namespace

void ComponentNews::publish_table(
    const std::vector<DeploymentPointer>& deployments) const {
  std::vector<Target> targets;
  for (const auto& deployment : deployments)
    targets.push_back(target_of(*deployment));
  parts_.bus.set_targets(std::move(targets));
}

// An event for one session is not sent where no reaction listens: it would be
// shown as unhandled, though nobody had asked.
void ComponentNews::tell(const char* event, std::vector<Value> params,
                         const SessionId& session) const {
  Message message;
  message.source = "System";
  message.command = event;
  message.params = std::move(params);
  message.session = session;
  if (session.empty() || (parts_.sessions.find(session) &&
                          parts_.bus.table()->is_listened_to(message)))
    parts_.bus.publish({std::move(message)});
}

void ComponentNews::tell_up(const Service& service) const {
  const auto& roles = service.component->description().roles;
  tell("ComponentUp",
       {service.name(), roles.empty() ? Value() : Value(roles.front())},
       service.scope->session());
}

std::vector<Message>
ComponentNews::failure_answers(const Service& service,
                               const std::vector<Message>& messages,
                               const std::string& reason) const {
  std::vector<Message> answers;
  for (const auto& message : messages)
    if (auto answer = answer_for_failed(service.name(), message, reason))
      answers.push_back(std::move(*answer));
  return answers;
}

void ComponentNews::answer_by_failure(const Service& service,
                                      const std::vector<Message>& messages,
                                      const std::string& reason) const {
  auto answers = failure_answers(service, messages, reason);
  if (!answers.empty() && answers_ && !service.over)
    parts_.bus.publish(std::move(answers));
}

// All in one batch: a script hears "AgentOffline" before the failed answer
// makes it say something. Of one that leaves it hears the answers only: another
// of its name may serve by now.
void ComponentNews::tell_available(const Service& service, bool is_available,
                                   std::vector<Message> unanswered) const {
  if (!answers_ || service.over)
    return;
  std::vector<Message> messages;
  if (service.state != ServiceState::leaving) {
    auto& news = messages.emplace_back();
    news.source = "System";
    news.command = is_available ? "AgentOnline" : "AgentOffline";
    news.params = {service.name()};
    news.session = service.scope->session();
  }
  for (auto& answer :
       failure_answers(service, unanswered, "is not available any more"))
    messages.push_back(std::move(answer));
  if (!messages.empty())
    parts_.bus.publish(std::move(messages));
}

// Where the scope is over nobody can be answered: the messages are shown as
// unhandled instead, so that they are not lost silently (architecture rule 6).
void ComponentNews::answer_what_waits(const Service& service,
                                      const std::string& reason) const {
  std::vector<Message> messages;
  for (auto& job : service.component->mailbox->take_all()) {
    if (service.over)
      parts_.bus.unhandled(*job.message, service.name() + ": " + reason);
    messages.push_back(*job.message);
  }
  answer_by_failure(service, messages, reason);
}

} // namespace parlour::actors

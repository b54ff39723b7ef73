#include "adapters/http/rules/service_rules.hpp"

#include <algorithm>

namespace parlour::adapters::http {

namespace {

constexpr const char* failed = "Failed";

// "value1, value2".
std::string parameters_of(const EventRule& event) {
  std::string text;
  for (std::size_t i = 1; i <= event.params.size(); ++i)
    text += (i == 1 ? "value" : ", value") + std::to_string(i);
  return text;
}

std::string parameters_of(const CommandRule& command) {
  std::string text;
  for (const auto& parameter : command.parameters)
    text += (text.empty() ? "" : ", ") + parameter.name +
            (parameter.optional ? "?" : "");
  return text;
}

} // namespace

std::string CommandRule::who_answered() const {
  return (request.server.empty() ? "The service" : request.server) +
         " answered";
}

const CommandRule* ServiceRules::find(std::string_view command) const {
  const auto found = std::ranges::find(commands, command, &CommandRule::name);
  return found == commands.end() ? nullptr : &*found;
}

const WebhookRule* ServiceRules::find_webhook(std::string_view path) const {
  const auto found = std::ranges::find(webhooks, path, &WebhookRule::path);
  return found == webhooks.end() ? nullptr : &*found;
}

// The first refusal of the role whose only parameter is the reason.
std::string ServiceRules::refusal() const {
  const auto* known = find_role(role);
  if (!known)
    return failed;
  const auto found =
      std::ranges::find_if(known->events, [](const RoleEvent& event) {
        return event.reply == Reply::refusal && event.parameters == "reason";
      });
  return found == known->events.end() ? failed : found->name;
}

std::vector<RoleCommand> own_commands(const ServiceRules& rules) {
  const auto* role = find_role(rules.role);
  std::vector<RoleCommand> own;
  for (const auto& command : rules.commands)
    if (!role || !role->command(command.name))
      own.push_back({command.name, parameters_of(command), true});
  return own;
}

// An event that a command and a webhook have is listed once, as an answer.
std::vector<RoleEvent> own_events(const ServiceRules& rules) {
  const auto* role = find_role(rules.role);
  std::vector<RoleEvent> own;
  auto add = [&](const std::vector<AnswerRule>& answers, Reply reply) {
    for (const auto& answer : answers) {
      const auto& event = answer.event;
      if (event.name != failed && !(role && role->event(event.name)) &&
          std::ranges::count(own, event.name, &RoleEvent::name) == 0)
        own.push_back({event.name, parameters_of(event), reply});
    }
  };
  for (const auto& command : rules.commands)
    add(command.answers, Reply::answer);
  for (const auto& webhook : rules.webhooks)
    add(webhook.answers, Reply::none);
  return own;
}

} // namespace parlour::adapters::http

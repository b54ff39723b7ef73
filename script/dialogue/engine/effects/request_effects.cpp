#include "script/dialogue/engine/effects/request_effects.hpp"

#include <algorithm>
#include <utility>

#include "runtime/message/replies.hpp"
#include "script/dialogue/engine/effects/effect_operands.hpp"
#include "script/dialogue/engine/effects/heard_texts.hpp"

namespace parlour::dialogue {

namespace {

// What another session asks for: correlations are a session's own, and what is
// answered goes to that one.
Message message_of(SessionId session, const Value& module, const Value& command,
                   List params) {
  Message message;
  message.source = "Script";
  message.command = command.text();
  message.params = std::move(params);
  message.sinks = {module.text()};
  message.session = std::move(session);
  return message;
}

} // namespace

script::Performed RequestEffects::post(TurnId turn,
                                       const script::Effect& effect) {
  const auto& other = effect.operand(3);
  if (other.is_unknown() || other.text() == context_.options.session)
    messenger_.post(effect.text(0), effect.text(1), params_of(turn, effect),
                    turn);
  else
    messenger_.post_for_another(message_of(other.text(), effect.operand(0),
                                           effect.operand(1),
                                           list_of(effect.operand(2))));
  return Value();
}

// A role is no agent, even if one fills it: who sends means this one only.
script::Performed RequestEffects::send(TurnId turn,
                                       const script::Effect& effect) {
  const auto& agents = context_.program->settings.agents.agents;
  if (std::ranges::find(agents, effect.text(0), &AgentSettings::name) ==
      agents.end())
    return missing("agent", effect.operand(0));
  messenger_.post(effect.text(0), effect.text(1), list_of(effect.operand(2)),
                  turn);
  return Value();
}

// The understanding is told what was asked, and what else was heard, unless the
// script tells it itself.
List RequestEffects::params_of(TurnId turn,
                               const script::Effect& effect) const {
  auto params = list_of(effect.operand(2));
  if (params.size() == 1 && effect.text(1) == "DoNLU" &&
      context_.port.is_source("NLU", effect.text(0)))
    params.push_back(with_heard(whereabouts_.understanding_context(), params[0],
                                context_.turns.heard(turn)));
  return params;
}

// A request that nobody can answer fails at once and does not wait for its
// time-out. One with a long timeout lets the lane go on (engine rule 2.4), so
// it counts as a wait for time.
script::Performed RequestEffects::request(TurnId turn,
                                          const script::Effect& effect) {
  const auto module = effect.text(0);
  if (!context_.port.reachable(module))
    return Error{ErrorKind::offline,
                 "nobody fills the role or has the name '" + module + "'",
                 {}};
  auto correlation =
      messenger_.post(module, effect.text(1), params_of(turn, effect), turn);
  const auto usual = context_.program->settings.sessions.request_timeout;
  const auto timeout = effect.has(3) ? milliseconds(effect.operand(3)) : usual;
  // For longer than usual nobody else has to wait.
  const auto wait =
      running_.begin_wait(timeout > usual ? WaitFor::time : WaitFor::answer);
  requests_[correlation] = wait;
  timers_.start(context_.in(timeout), {.purpose = Timer::Purpose::wait,
                                       .wait = wait,
                                       .correlation = correlation});
  return script::Waits{};
}

std::optional<WaitOutcome> RequestEffects::reply(const Message& message) {
  auto found = requests_.find(message.correlation);
  if (found == requests_.end())
    return std::nullopt;
  const auto reply = context_.port.reply_to_request(message);
  if (reply == Reply::none)
    return std::nullopt;
  auto wait = found->second;
  requests_.erase(found);
  if (reply == Reply::refusal) {
    const bool is_database =
        context_.port.is_source("Database", message.source);
    return WaitOutcome{wait,
                       tl::make_unexpected(refusal_of(message, is_database))};
  }
  return WaitOutcome{wait, Value(Map{{"command", message.command},
                                     {"params", List(message.params)}})};
}

// A reply that has arrived and is still queued counts: its request is answered.
std::vector<WaitOutcome> RequestEffects::lost() const {
  std::vector<WaitOutcome> lost;
  for (const auto& [correlation, wait] : requests_)
    if (!messenger_.has_reply(correlation))
      lost.push_back(in_doubt(wait));
  return lost;
}

void RequestEffects::forget(WaitId wait) {
  std::erase_if(requests_,
                [&](const auto& entry) { return entry.second == wait; });
}

} // namespace parlour::dialogue

// What scripts want of components: messages, requests, frames, speech.
#include <optional>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/effect_handler.hpp"
#include "script/dialogue/engine/effect_operands.hpp"
#include "script/dialogue/topics/misnamed.hpp"

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

// -- messages -----------------------------------------------------------------

script::Performed EffectHandler::post(Context context, Call effect) {
  const auto& other = effect.operand(3);
  if (other.is_unknown() || other.text() == context_.options.session)
    context_.post(effect.text(0), effect.text(1), params_of(effect),
                  context.turn);
  else
    post_for(message_of(other.text(), effect.operand(0), effect.operand(1),
                        list_of(effect.operand(2))));
  return Value();
}

// The understanding is told what was asked, unless the script tells it itself.
List EffectHandler::params_of(Call effect) const {
  auto params = list_of(effect.operand(2));
  if (params.size() == 1 && effect.text(1) == "DoNLU" &&
      context_.port.is_source("NLU", effect.text(0)))
    params.push_back(topics_.understanding_context());
  return params;
}

void EffectHandler::post_for(Message message) {
  message.rounds = context_.rounds + 1;
  context_.port.post(std::move(message));
}

script::Performed EffectHandler::request(Context context, Call effect) {
  const auto module = effect.text(0);
  if (!context_.port.reachable(module))
    return Error{ErrorKind::offline,
                 "nobody fills the role or has the name '" + module + "'",
                 {}};
  auto correlation =
      context_.post(module, effect.text(1), params_of(effect), context.turn);
  const auto usual = context_.program->settings.sessions.request_timeout;
  const auto timeout = effect.has(3) ? milliseconds(effect.operand(3)) : usual;
  // For longer than usual nobody else has to wait.
  const auto wait =
      begin_wait(timeout > usual ? ActivationRunner::WaitFor::time
                                 : ActivationRunner::WaitFor::answer);
  requests_[correlation] = wait;
  context_.timers.start(timeout, {.purpose = Timer::Purpose::wait,
                                  .wait = wait,
                                  .correlation = correlation});
  return script::Waits{};
}

bool EffectHandler::reply(const Message& message) {
  auto found = requests_.find(message.correlation);
  if (found == requests_.end())
    return false;
  const auto reply = context_.port.reply_to_request(message);
  if (reply == Reply::none)
    return false;
  auto wait = found->second;
  requests_.erase(found);
  if (reply == Reply::refusal) {
    auto reason =
        message.params.empty() ? message.command : message.params.back().text();
    auto kind = context_.port.is_source("Database", message.source)
                    ? ErrorKind::database
                    : ErrorKind::refused;
    waits_.resume(wait, fail(kind, message.source + ": " + reason));
  } else {
    waits_.resume(wait, Value(Map{{"command", message.command},
                                  {"params", List(message.params)}}));
  }
  return true;
}

void EffectHandler::forget(WaitId wait) {
  std::erase_if(requests_,
                [&](const auto& entry) { return entry.second == wait; });
  std::erase_if(queries_,
                [&](const auto& entry) { return entry.second.wait == wait; });
  sockets_.forget(wait);
}

script::Performed EffectHandler::fire_frames(Context context, Call effect) {
  auto parsed = parse_acts(effect.operand(0));
  const auto place = context_.program->place(effect.position);
  for (const auto& problem : parsed.problems)
    context_.inspect(InspectionKind::error, "fire",
                     to_string(Error{ErrorKind::range, problem, place}));
  // Who listens to Dialogue may know names that no topic has.
  for (const auto& act : parsed.acts)
    if (!reactions_.listens("Dialogue", std::string(name_of(act.kind))))
      if (auto error = misnamed(*context_.program, act))
        return std::move(*error);
  if (parsed.acts.empty()) {
    Step nothing;
    nothing.kind = StepKind::no_match;
    nothing.turn = context.turn;
    runner_.later(std::move(nothing));
  }
  for (auto& act : parsed.acts)
    runner_.later(
        act_step(std::make_shared<const Act>(std::move(act)), context.turn));
  return Value();
}

script::Performed EffectHandler::speak(Context context, Call effect) {
  auto handled = context.message ? context.message->correlation : 0;
  output_.speak(effect.text(0), handled, context.turn,
                !effect.has(1) || effect.operand(1));
  return Value();
}

} // namespace parlour::dialogue

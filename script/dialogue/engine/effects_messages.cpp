// What scripts want of components: messages, requests, frames, speech.
#include <optional>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/core.hpp"
#include "script/dialogue/engine/effect_operands.hpp"
#include "script/dialogue/engine/effects.hpp"
#include "script/source/findings.hpp"

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

template <class Named>
std::string did_you_mean(const std::string& name,
                         const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return script::did_you_mean(name, names);
}

// What a frame may leave open it must not get wrong: another topic would take
// it.
std::optional<Error> misnamed(const script::Program& program, const Act& act) {
  if (act.topic.empty())
    return {};
  const auto id = program.topic(act.topic);
  if (id == script::no_id)
    return Error{ErrorKind::range,
                 "there is no topic '" + act.topic + "' for this frame" +
                     did_you_mean(act.topic, program.topics),
                 {}};
  const auto& topic = program.topics[id];
  for (const auto& value : act.slots)
    if (topic.slot(value.slot) == script::no_id)
      return Error{ErrorKind::range,
                   "the topic '" + topic.name + "' has no slot '" + value.slot +
                       "' for this frame" +
                       did_you_mean(value.slot, topic.slots),
                   {}};
  return {};
}

} // namespace

// -- messages -----------------------------------------------------------------

script::Performed Effects::post(Context context, Call effect) {
  const auto& other = effect.operand(3);
  if (other.is_unknown() || other.text() == core_.options.session)
    core_.post(effect.text(0), effect.text(1), list_of(effect.operand(2)),
               context.turn);
  else
    post_for(message_of(other.text(), effect.operand(0), effect.operand(1),
                        list_of(effect.operand(2))));
  return Value();
}

void Effects::post_for(Message message) {
  message.rounds = core_.rounds + 1;
  core_.port.post(std::move(message));
}

script::Performed Effects::request(Context context, Call effect) {
  const auto module = effect.text(0);
  if (!core_.port.reachable(module))
    return Error{ErrorKind::offline,
                 "nobody fills the role or has the name '" + module + "'",
                 {}};
  auto correlation = core_.post(module, effect.text(1),
                                list_of(effect.operand(2)), context.turn);
  const auto usual = core_.program->settings.sessions.request_timeout;
  const auto timeout = effect.has(3) ? milliseconds(effect.operand(3)) : usual;
  // For longer than usual nobody else has to wait.
  const auto wait = begin_wait(timeout > usual ? Runner::WaitFor::time
                                               : Runner::WaitFor::answer);
  requests_[correlation] = wait;
  core_.timers.start(timeout, {.purpose = Timer::Purpose::wait,
                               .wait = wait,
                               .correlation = correlation});
  return script::Waits{};
}

bool Effects::reply(const Message& message) {
  auto found = requests_.find(message.correlation);
  if (found == requests_.end())
    return false;
  const auto reply = core_.port.reply_to_request(message);
  if (reply == Reply::none)
    return false;
  auto wait = found->second;
  requests_.erase(found);
  if (reply == Reply::refusal) {
    auto reason =
        message.params.empty() ? message.command : message.params.back().text();
    auto kind = core_.port.is_source("Database", message.source)
                    ? ErrorKind::database
                    : ErrorKind::refused;
    core_.resume(wait, fail(kind, message.source + ": " + reason));
  } else {
    core_.resume(wait, Value(Map{{"command", message.command},
                                 {"params", List(message.params)}}));
  }
  return true;
}

void Effects::forget(WaitId wait) {
  std::erase_if(requests_,
                [&](const auto& entry) { return entry.second == wait; });
  std::erase_if(queries_,
                [&](const auto& entry) { return entry.second.wait == wait; });
  sockets.forget(wait);
}

script::Performed Effects::fire_frames(Context context, Call effect) {
  auto parsed = parse_acts(effect.operand(0));
  for (const auto& problem : parsed.problems)
    core_.inspect(InspectionKind::error, "fire", problem);
  // Who listens to Dialogue may know names that no topic has.
  for (const auto& act : parsed.acts)
    if (!core_.pipeline.listens("Dialogue", std::string(name_of(act.kind))))
      if (auto error = misnamed(*core_.program, act))
        return std::move(*error);
  if (parsed.acts.empty()) {
    Step nothing;
    nothing.kind = StepKind::no_match;
    nothing.turn = context.turn;
    core_.runner.later(std::move(nothing));
  }
  for (auto& act : parsed.acts)
    core_.runner.later(
        act_step(std::make_shared<const Act>(std::move(act)), context.turn));
  return Value();
}

script::Performed Effects::speak(Context context, Call effect) {
  auto handled = context.message ? context.message->correlation : 0;
  core_.mouth.speak(effect.text(0), handled, context.turn,
                    !effect.has(1) || effect.operand(1));
  return Value();
}

void Effects::unhandled(const Message& message, TurnId turn, bool raised) {
  if (message.source == "Script" && message.command == "Error") {
    if (!core_.apologies.due(core_.now))
      return;
    Say what;
    what.act = "unavailable";
    what.data =
        Map{{"reason", message.params.empty() ? Value() : message.params[0]}};
    what.turn = turn;
    core_.mouth.say(std::move(what));
    return;
  }
  if (!raised)
    core_.port.unhandled(message);
}

} // namespace parlour::dialogue

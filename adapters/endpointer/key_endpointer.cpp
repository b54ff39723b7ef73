#include "adapters/endpointer/key_endpointer.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"before", "300ms",
       "how much audio before the key was pressed belongs to the turn", false,
       OptionType::duration},
      {"after", "200ms", "how much audio after the release belongs to it",
       false, OptionType::duration},
      {"longest", "60s", "longer turns are cut", false, OptionType::duration}};
  return options;
}

Milliseconds time_of(const Options& given, const std::string& name) {
  return parse_duration(option_value(given, option_descriptions(), name))
      .value_or(Milliseconds{});
}

} // namespace

KeyEndpointer::KeyEndpointer() {
  on("Pressed", &KeyEndpointer::on_pressed);
  on("Released", &KeyEndpointer::on_released);
  on("Partial", &KeyEndpointer::ignore_partial);
  on("Wake", &KeyEndpointer::ignore_wake);
  on("Sleep", &KeyEndpointer::ignore_sleep);
  for (const auto* command :
       {"SpeechStarted", "SpeechEnded", "RobotStarted", "RobotFinished"})
    on(command, &KeyEndpointer::ignore);
}

Expected<void> KeyEndpointer::on_start(const Options& given) {
  KeyEndpointTimes times;
  times.before = time_of(given, "before");
  times.after = time_of(given, "after");
  times.longest = time_of(given, "longest");
  if (times.longest < Milliseconds(1'000) ||
      times.longest > Milliseconds(300'000))
    return fail(ErrorKind::settings, "\"longest\" is a time from 1s to 5m");
  if (std::max(times.before, times.after) > Milliseconds(10'000))
    return fail(ErrorKind::settings,
                "\"before\" and \"after\" may be at most 10s");
  endpointing_ = KeyEndpointing(times);
  return {};
}

TurnSteps KeyEndpointer::hear(Value frame, std::int64_t position) {
  return endpointing_.hear(std::move(frame), position);
}

TurnSteps KeyEndpointer::finish() {
  return endpointing_.finish();
}

TurnSteps KeyEndpointer::reset() {
  return endpointing_.reset();
}

bool KeyEndpointer::in_turn() const {
  return endpointing_.in_turn();
}

void KeyEndpointer::on_pressed() {
  carry_out(endpointing_.pressed());
}

void KeyEndpointer::on_released() {
  carry_out(endpointing_.released());
}

void KeyEndpointer::ignore(std::int64_t) {}

void KeyEndpointer::ignore_wake(std::optional<std::int64_t>) {}

void KeyEndpointer::ignore_sleep() {}

void KeyEndpointer::ignore_partial(const std::string&, std::int64_t,
                                   std::optional<bool>) {}

PluginFactory key_endpointer_factory() {
  PluginDescription description;
  description.name = "KeyEndpointer";
  description.roles = {"Endpointer"};
  description.sentence = "begins and ends turns by a key";
  description.options = option_descriptions();
  description.commands = {{"Pressed", ""}, {"Released", ""}};
  return {std::move(description),
          [] { return std::make_unique<KeyEndpointer>(); }};
}

} // namespace parlour::adapters

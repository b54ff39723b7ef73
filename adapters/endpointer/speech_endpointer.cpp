#include "adapters/endpointer/speech_endpointer.hpp"

#include <utility>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

namespace {

// A speaker that never tells of the end.
constexpr std::size_t most_utterances = 100;

const std::vector<OptionDescription> options = {
    {"after-sentence", "300ms", "the pause that ends a turn after a sentence",
     false, OptionType::duration},
    {"pause", "700ms", "the pause that usually ends a turn", false,
     OptionType::duration},
    {"within-sentence", "1200ms",
     "the pause that ends a turn where no sentence can end", false,
     OptionType::duration},
    {"interruption", "250ms",
     "how long somebody must speak to interrupt the robot", false,
     OptionType::duration},
    {"margin", "300ms", "how much audio around the speech belongs to the turn",
     false, OptionType::duration},
    {"longest", "30s", "longer turns are cut", false, OptionType::duration},
    {"sleeps-after", "",
     "it sleeps until Wake, and after so much silence; else it is always awake",
     false, OptionType::duration}};

Milliseconds time_of(const Options& given, const std::string& name) {
  return parse_duration(option_value(given, options, name))
      .value_or(Milliseconds{});
}

Expected<void> check(const EndpointTimes& times) {
  if (times.longest < Milliseconds(1'000))
    return fail(ErrorKind::settings, "\"longest\" must be at least 1s");
  if (times.longest > Milliseconds(300'000) ||
      std::max({times.after_sentence, times.usual, times.within_sentence,
                times.interruption, times.margin}) > Milliseconds(10'000))
    return fail(ErrorKind::settings,
                "a pause may be at most 10s, and \"longest\" 5m");
  if (times.awake && *times.awake < Milliseconds(1'000))
    return fail(ErrorKind::settings, "\"sleeps-after\" must be at least 1s");
  return {};
}

} // namespace

SpeechEndpointer::SpeechEndpointer() {
  on("SpeechStarted", &SpeechEndpointer::on_speech_started);
  on("SpeechEnded", &SpeechEndpointer::on_speech_ended);
  on("Partial", &SpeechEndpointer::on_partial);
  on("RobotStarted", &SpeechEndpointer::on_robot_started);
  on("RobotFinished", &SpeechEndpointer::on_robot_finished);
  on("Wake", &SpeechEndpointer::on_wake);
  on("Sleep", &SpeechEndpointer::on_sleep);
}

Expected<void> SpeechEndpointer::on_start(const Options& given) {
  EndpointTimes times;
  times.after_sentence = time_of(given, "after-sentence");
  times.usual = time_of(given, "pause");
  times.within_sentence = time_of(given, "within-sentence");
  times.interruption = time_of(given, "interruption");
  times.margin = time_of(given, "margin");
  times.longest = time_of(given, "longest");
  if (!option_value(given, options, "sleeps-after").empty())
    times.awake = time_of(given, "sleeps-after");
  return check(times).map([&] { endpointing_ = Endpointing(times); });
}

TurnSteps SpeechEndpointer::hear(Value frame, std::int64_t position) {
  return endpointing_.hear(std::move(frame), position);
}

TurnSteps SpeechEndpointer::finish() {
  return endpointing_.finish();
}

TurnSteps SpeechEndpointer::reset() {
  return endpointing_.reset();
}

bool SpeechEndpointer::in_turn() const {
  return endpointing_.in_turn();
}

void SpeechEndpointer::on_speech_started(std::int64_t position) {
  endpointing_.speech_started(position);
}

void SpeechEndpointer::on_speech_ended(std::int64_t position) {
  endpointing_.speech_ended(position);
}

void SpeechEndpointer::on_partial(const std::string&, std::int64_t,
                                  std::optional<bool> ends) {
  endpointing_.recognised(ends);
}

void SpeechEndpointer::on_robot_started(std::int64_t utterance) {
  if (robot_speaks_.size() == most_utterances)
    robot_speaks_.clear();
  robot_speaks_.insert(utterance);
  endpointing_.robot_speaks(true);
}

void SpeechEndpointer::on_robot_finished(std::int64_t utterance) {
  robot_speaks_.erase(utterance);
  endpointing_.robot_speaks(!robot_speaks_.empty());
}

void SpeechEndpointer::on_wake(std::optional<std::int64_t> position) {
  endpointing_.wake(position);
}

void SpeechEndpointer::on_sleep() {
  endpointing_.sleep();
}

PluginFactory speech_endpointer_factory() {
  PluginDescription description;
  description.name = "SpeechEndpointer";
  description.roles = {"Endpointer"};
  description.sentence = "decides which speech is a turn, and when it ends";
  description.options = options;
  return {std::move(description),
          [] { return std::make_unique<SpeechEndpointer>(); }};
}

} // namespace parlour::adapters

#include "tools/parlour/talk/voice_progress.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

constexpr std::size_t measured = adapters::speech_rate / 5; // 200 ms
constexpr std::size_t bar_length = 20;
constexpr double quietest = -60; // decibels

} // namespace

std::string level_bar(const adapters::LevelMeter& level) {
  const auto part = std::clamp(1 - level.level() / quietest, 0.0, 1.0);
  const auto signs = static_cast<std::size_t>(std::lround(part * bar_length));
  return fmt::format("[{:<{}}] {:>4} dB{}", std::string(signs, '#'), bar_length,
                     std::lround(level.level()),
                     level.clipped() > 0 ? " too loud" : "");
}

std::string VoiceProgress::line() const {
  std::lock_guard lock(mutex_);
  return line_now();
}

std::string VoiceProgress::line_now() const {
  switch (doing_) {
  case Doing::loading:
    return "loading the recogniser";
  case Doing::deaf:
    return "no microphone; waiting for it";
  case Doing::asleep:
    return "asleep       " + level_bar(shown_);
  case Doing::listening:
    return "listening    " + level_bar(shown_);
  case Doing::hearing:
    return "hearing you  " + level_bar(shown_);
  case Doing::thinking:
    return "thinking     " + level_bar(shown_);
  case Doing::speaking:
    return "speaking     " + level_bar(shown_);
  }
  return "";
}

std::optional<std::string> VoiceProgress::take(const Message& message) {
  const auto role = roles_.find(message.source);
  if (role == roles_.end())
    return std::nullopt;
  std::lock_guard lock(mutex_);
  bool changed = false;
  if (role->second == "Microphone")
    changed = heard(message);
  if (const auto doing = next(role->second, message.command))
    changed |= change(*doing);
  return changed ? std::optional(line_now()) : std::nullopt;
}

// Sound of the microphone, whatever a route calls it.
bool VoiceProgress::heard(const Message& message) {
  if (message.params.empty() || !message.params.front().if_binary())
    return false;
  bool changed = false;
  if (doing_ == Doing::loading || doing_ == Doing::deaf)
    changed = change(sleeps_ ? Doing::asleep : Doing::listening);
  const auto samples = adapters::speech_samples(message.params.front());
  if (samples)
    now_.add(*samples);
  if (now_.samples() < measured)
    return changed;
  shown_ = std::exchange(now_, {});
  return true;
}

bool VoiceProgress::change(Doing doing) {
  return std::exchange(doing_, doing) != doing;
}

// Routes give some events another name.
std::optional<VoiceProgress::Doing>
VoiceProgress::next(std::string_view role, std::string_view command) const {
  using enum Doing;
  if (role == "Microphone" && command == "Failed")
    return deaf;
  if (role == "Endpointer" && command == "TurnStarted")
    return hearing;
  if (role == "Endpointer" && (command == "TurnEnded" || command == "Finish"))
    return thinking;
  if (role == "Endpointer" && (command == "TurnDropped" || command == "Cancel"))
    return listening;
  if (role == "Endpointer" && command == "Woken")
    return listening;
  if (role == "Endpointer" && command == "FellAsleep")
    return asleep;
  if (role == "ASR" && command == "Rejected")
    return listening;
  if (role == "Speaker" && (command == "Started" || command == "RobotStarted"))
    return speaking;
  const bool has_spoken = role == "Speaker" &&
                          (command == "Finished" || command == "RobotFinished");
  return has_spoken && doing_ == speaking ? std::optional(listening)
                                          : std::nullopt;
}

} // namespace parlour::tools

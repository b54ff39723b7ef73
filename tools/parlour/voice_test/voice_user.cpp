// In virtual time the microphone moves the clock, 20 ms at a time.
#include "tools/parlour/voice_test/voice_user.hpp"

#include <algorithm>
#include <utility>

#include "adapters/audio/file_speaker.hpp"

namespace parlour::tools {

namespace {

// All in virtual time.
constexpr Milliseconds longest_turn{60'000};
constexpr Milliseconds robot_talks_at_most{120'000};
// After the robot has spoken the user takes so long to answer.
constexpr Milliseconds before_answer{300};
// Speech in which no turn was found is over after so long.
constexpr Milliseconds unheard{2'500};
// The next line of a row cuts in so long after the robot's first sound, or
// after this if the robot is silent.
constexpr Milliseconds before_cut{600};
constexpr Milliseconds before_next_line{1'500};

void pass(actors::Node& node, Milliseconds time) {
  node.advance(time);
  node.run_until_quiet();
}

} // namespace

VoiceUser::VoiceUser(adapters::Sound noise, bool told,
                     KeptComponents* recognisers)
    : told_(told), recognisers_(recognisers),
      sound_(std::make_shared<UserSound>(std::move(noise))) {}

Composition VoiceUser::seated(Composition composition,
                              const std::filesystem::path& data) const {
  for (auto& component : composition.components) {
    const auto plugin = component.factory.description.name;
    for (const auto& option : component.factory.description.options)
      if (option.name == "conversations" && !told_)
        component.options[option.name] = "none";
    if (plugin == "FileMicrophone") {
      component.factory = user_microphone_factory(sound_);
      component.options.clear();
    } else if (plugin == "FileSpeaker") {
      component.factory = adapters::file_speaker_factory(data / "robot.wav");
    } else if (recognisers_ && fills(component, "ASR")) {
      component.factory =
          recognisers_->keep(component.name, std::move(component.factory),
                             forgetting_of_recognisers());
    }
  }
  return composition;
}

void VoiceUser::surround(adapters::Sound noise) {
  sound_->surround(std::move(noise));
}

void VoiceUser::begin(actors::Node& node, const adapters::Sound& line) {
  sound_->say(line);
  until(
      node, [this] { return sound_->is_silent(); }, longest_turn);
  log_.line_ended(node.now());
}

void VoiceUser::say(actors::Node& node, const adapters::Sound& line) {
  const auto turns = log_.recognised();
  begin(node, line);
  const auto end = node.now() + unheard.count();
  until(
      node,
      [&] {
        return !log_.in_turn() &&
               (log_.recognised() > turns || node.now() >= end);
      },
      longest_turn);
}

void VoiceUser::wait_to_cut_in(actors::Node& node) {
  until(
      node, [this] { return log_.robot_sounds(); }, before_next_line);
  pass(node, before_cut);
}

void VoiceUser::wait_for_words(actors::Node& node, std::size_t count) {
  until(
      node,
      [&] {
        return log_.words_said(node.now()) >= count || !log_.robot_speaks();
      },
      robot_talks_at_most);
}

void VoiceUser::think(actors::Node& node) {
  pass(node, before_answer);
}

void VoiceUser::settle(actors::Node& node) {
  until(
      node, [this] { return !log_.robot_speaks(); }, robot_talks_at_most);
}

void VoiceUser::until(actors::Node& node, const std::function<bool()>& holds,
                      Milliseconds at_most) {
  const auto end = node.now() + at_most.count();
  node.run_until_quiet();
  while (!holds() && node.now() < end &&
         node.step_to_next_due(Milliseconds(end - node.now()))) {
  }
}

} // namespace parlour::tools

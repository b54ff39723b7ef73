// VoiceUser: the user of one conversation by voice, in virtual time: speaks
// lines into the application's microphone, waits for the robot, and cuts in.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "actors/node/node.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/voice_test/kept_component.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"
#include "tools/parlour/voice_test/turn_log.hpp"
#include "tools/parlour/voice_test/user_microphone.hpp"

namespace parlour::tools {

// For one thread at a time; it outlives the node.
class VoiceUser {
public:
  // `told`: the recogniser knows what users say in the application's
  // conversations, as it does in a run. `recognisers`: where they are kept for
  // the next conversation; null: each has one of its own.
  VoiceUser(adapters::Sound noise, bool told, KeptComponents* recognisers);

  // The application with the user's microphone, and a speaker whose file goes
  // with the data folder. It has a voice seat with files as microphone and
  // speaker (add_voice), which are replaced.
  Composition seated(Composition composition,
                     const std::filesystem::path& data) const;

  // What the node's inspections tell.
  TurnLog& log() {
    return log_;
  }
  const TurnLog& log() const {
    return log_;
  }
  void surround(adapters::Sound noise);

  // Speaks the line, and lets time pass until its turn is recognised.
  void say(actors::Node& node, const adapters::Sound& line);
  // The same, but does not wait for what becomes of it.
  void begin(actors::Node& node, const adapters::Sound& line);
  // Lets time pass until the robot is in the middle of what it says, if it
  // says something; or until it has said so many words.
  void wait_to_cut_in(actors::Node& node);
  void wait_for_words(actors::Node& node, std::size_t count);
  // How long somebody takes before speaking.
  void think(actors::Node& node);
  // Lets time pass until the robot has spoken to its end.
  void settle(actors::Node& node);
  // Lets time pass until it holds, or nothing is due for so long.
  static void until(actors::Node& node, const std::function<bool()>& holds,
                    Milliseconds at_most);

private:
  bool told_;
  KeptComponents* recognisers_;
  std::shared_ptr<UserSound> sound_;
  TurnLog log_;
};

} // namespace parlour::tools

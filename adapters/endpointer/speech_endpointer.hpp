// SpeechEndpointer is a plug-in for the role Endpointer: it stands between
// detector and recogniser, and hands the recogniser what is a turn
// (endpointing.hpp). Each microphone needs an instance of its own:
// scope="seat".
//
//  Process(audio, position?)
//      Speech(audio) for each frame of a turn; TurnStarted(position) before the
//      first, TurnEnded(position) after the last.
//  SpeechStarted(position), SpeechEnded(position)
//      from the detector.
//  Partial(text, revision, ends?)
//      from the recogniser: how long a pause ends the turn depends on it.
//  RobotStarted(utterance), RobotFinished(utterance)
//      While the robot speaks, short sounds begin no turn.
//  Reset
//      TurnDropped(position) if a turn was open.
//
// A turn also ends when no audio comes for a second.
// Options: after-sentence, pause, within-sentence, interruption, margin,
// longest.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "adapters/endpointer/endpointing.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

class SpeechEndpointer : public RolePlugin {
public:
  SpeechEndpointer();

protected:
  Expected<void> on_start(const Options& options) override;

private:
  void on_process(const Binary& audio, std::optional<std::int64_t> position);
  void on_speech_started(std::int64_t position);
  void on_speech_ended(std::int64_t position);
  void on_partial(const std::string& text, std::int64_t revision,
                  std::optional<bool> ends);
  void on_robot_started(std::int64_t utterance);
  void on_robot_finished(std::int64_t utterance);
  void on_reset();

  void carry_out(TurnSteps steps);
  void carry_out(TurnStep& step);
  // Looks every second whether audio still comes while a turn is open.
  void watch();
  void look();

  Endpointing endpointing_{{}};
  // Where the next frame begins that does not say so.
  std::int64_t next_position_ = 0;
  // Utterances that the robot speaks now.
  std::set<std::int64_t> robot_speaks_;
  // What came last from the microphone: events outside of a call answer it.
  Message last_;
  bool heard_ = false; // since the last look
  bool watches_ = false;
};

PluginFactory speech_endpointer_factory();

} // namespace parlour::adapters

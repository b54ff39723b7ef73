// SpeechEndpointer is a plug-in for the role Endpointer: it stands between
// detector and recogniser, and hands the recogniser what is a turn
// (endpointing.hpp). Each microphone needs an instance of its own:
// scope="seat".
//
//  Process(audio, position?)
//      Speech(audio) for each frame of a turn; TurnStarted(position) before the
//      first, TurnEnded(position, silence) after the last.
//  SpeechStarted(position), SpeechEnded(position)
//      from the detector.
//  Partial(text, revision, ends?)
//      from the recogniser: how long a pause ends the turn depends on it.
//  RobotStarted(utterance), RobotFinished(utterance)
//      While the robot speaks, short sounds begin no turn.
//  Reset
//      TurnDropped(position) if a turn was open.
//  Wake(position?), Sleep
//      With the option `sleeps-after` nothing is a turn until Wake: what is
//      said from the position on is one, and it falls asleep again after so
//      much silence. Who the robot speaks to may answer. Woken(position),
//      FellAsleep(position).
//
// A turn also ends when no audio comes for a second (turn_plugin.hpp).
// Options: after-sentence, pause, within-sentence, interruption, margin,
// longest, sleeps-after.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "adapters/endpointer/turn_plugin.hpp"

namespace parlour::adapters {

class SpeechEndpointer : public TurnPlugin {
public:
  SpeechEndpointer();

protected:
  Expected<void> on_start(const Options& options) override;
  TurnSteps hear(Value frame, std::int64_t position) override;
  TurnSteps finish() override;
  TurnSteps reset() override;
  bool in_turn() const override;

private:
  void on_speech_started(std::int64_t position);
  void on_speech_ended(std::int64_t position);
  void on_partial(const std::string& text, std::int64_t revision,
                  std::optional<bool> ends);
  void on_robot_started(std::int64_t utterance);
  void on_robot_finished(std::int64_t utterance);
  void on_wake(std::optional<std::int64_t> position);
  void on_sleep();

  Endpointing endpointing_{{}};
  // Utterances that the robot speaks now.
  std::set<std::int64_t> robot_speaks_;
};

PluginFactory speech_endpointer_factory();

} // namespace parlour::adapters

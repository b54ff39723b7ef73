// KeyEndpointer is a plug-in for the role Endpointer by which turns begin and
// end with a key (key_endpointing.hpp): parlour:push-to-talk connects it to a
// component of the role PushToTalk. Each microphone needs an instance of its
// own: scope="seat".
//
//  Process(audio, position?)
//      Speech(audio) for each frame of a turn.
//  Pressed, Released
//      TurnStarted(position), and after the last frame
//      TurnEnded(position, silence), or
//      TurnDropped(position) if it was no longer than a click.
//  Reset
//      TurnDropped(position) if a turn was open.
//
// What the detector, the recogniser, the speaker and a word that wakes tell has
// no effect. A turn also ends when no audio comes for a second
// (turn_plugin.hpp). Options: before, after, longest.
#pragma once

#include <optional>
#include <string>

#include "adapters/endpointer/key_endpointing.hpp"
#include "adapters/endpointer/turn_plugin.hpp"

namespace parlour::adapters {

class KeyEndpointer : public TurnPlugin {
public:
  KeyEndpointer();

protected:
  Expected<void> on_start(const Options& options) override;
  TurnSteps hear(Value frame, std::int64_t position) override;
  TurnSteps finish() override;
  TurnSteps reset() override;
  bool in_turn() const override;

private:
  void on_pressed();
  void on_released();
  void ignore(std::int64_t position);
  void ignore_wake(std::optional<std::int64_t> position);
  void ignore_sleep();
  void ignore_partial(const std::string& text, std::int64_t revision,
                      std::optional<bool> ends);

  KeyEndpointing endpointing_{{}};
};

PluginFactory key_endpointer_factory();

} // namespace parlour::adapters

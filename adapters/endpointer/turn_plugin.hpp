// TurnPlugin: what plug-ins of the role Endpointer have in common. It hands the
// audio to the rules of the plug-in, fires the events that follow, and ends a
// turn when no audio comes for a second. Audio whose positions begin anew is
// another stream: what was heard before is forgotten, as after Reset.
#pragma once

#include <cstdint>
#include <optional>

#include "adapters/endpointer/endpointing.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

class TurnPlugin : public RolePlugin {
protected:
  // Registers handlers for Process and Reset.
  TurnPlugin();

  // The rules: the next frame, no more audio, a new beginning.
  virtual TurnSteps hear(Value frame, std::int64_t position) = 0;
  virtual TurnSteps finish() = 0;
  virtual TurnSteps reset() = 0;
  virtual bool in_turn() const = 0;

  // Fires what follows, in answer to the message that is handled, and sees to
  // it that a turn which has begun ends.
  void carry_out(TurnSteps steps);

private:
  void on_process(const Binary& audio, std::optional<std::int64_t> position);
  void on_reset();

  void carry_out(TurnStep& step);
  void remember_call();
  // Looks every second whether audio still comes while a turn is open.
  void watch();
  void look();

  // Where the next frame begins that does not say so.
  std::int64_t next_position_ = 0;
  // What came last from the microphone, or began the turn: events outside of a
  // call answer it.
  Message last_;
  bool heard_ = false; // since the last look
  bool watches_ = false;
};

} // namespace parlour::adapters

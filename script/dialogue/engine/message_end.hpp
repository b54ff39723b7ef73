// MessageEnd: what becomes of a message when all of its reactions are done: an
// output may have got its words, words may mean nothing, or nobody took it
// (engine rule 1.4).
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/input.hpp"
#include "script/dialogue/engine/effects/sockets.hpp"
#include "script/dialogue/output/output_manager.hpp"

namespace parlour::dialogue {

// Works for the Pipeline; keeps nothing.
class MessageEnd {
public:
  MessageEnd(DialogueContext& context, OutputManager& output,
             ScriptSockets& sockets)
      : context_(context), output_(output), sockets_(sockets) {}

  // A message whose reactions are all done, or of which none took it.
  struct Handled {
    const Message& message;
    TurnId turn = 0;
    bool raised = false;  // by the engine: nobody has to take it
    bool is_said = false; // by the user
    bool taken = false;   // by a state or a handler
    bool worded = false;  // by one that names it
  };
  // Called once for each message that goes through the pipeline. It may queue a
  // step, so it does not run the lane itself.
  void handled(const Handled& what);
  // Nobody is to handle it any more: its turn is let go, and an output that
  // waited for its words goes on without.
  void dropped(const Input& input) {
    output_.drop(input);
  }

private:
  void unhandled(const Handled& what);
  // NLU.NoResult, or NLU.Failed for a user turn.
  bool means_nothing(const Handled& what) const;
  void not_understood(const Handled& what);

  DialogueContext& context_;
  OutputManager& output_;
  ScriptSockets& sockets_;
};

} // namespace parlour::dialogue

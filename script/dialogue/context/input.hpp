// A message on its way to the pipeline, and the user turn it belongs to.
#pragma once

#include <memory>

#include "runtime/message/message.hpp"
#include "script/dialogue/agenda/turns.hpp"

namespace parlour::dialogue {

// Made when the message arrives or is raised, and moved along the pipeline.
struct Input {
  // Never null; others may have got it, too.
  std::shared_ptr<const Message> message;
  // The turn that it begins or is an answer for; 0: none, such as a sensor's
  // event.
  TurnId turn = 0;
  bool begins_turn = false; // the user spoke
  // The recogniser has rejected what the user said, so nobody knows what it was
  // (engine rule 3.2).
  bool is_unclear = false;
  // Raised by the engine itself, for those who listen, or the engine has dealt
  // with it: nobody has to take it (engine rule 1.4).
  bool raised = false;
  // Answers has found that it does not answer what a handler waits for; it
  // takes its usual way.
  bool is_no_answer = false;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(message, turn, begins_turn, is_unclear, raised, is_no_answer);
    archive.needs(message);
  }
};

} // namespace parlour::dialogue

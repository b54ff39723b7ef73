// A message on its way to the pipeline, and the user turn it belongs to.
#pragma once

#include <memory>

#include "runtime/message/message.hpp"
#include "script/dialogue/agenda/turns.hpp"

namespace parlour::dialogue {

struct Input {
  std::shared_ptr<const Message> message;
  TurnId turn = 0;
  bool begins_turn = false;  // the user spoke
  bool is_unclear = false;   // the user spoke, and nobody knows what
  bool raised = false;       // by the engine itself, for those who listen
  bool is_no_answer = false; // to what a handler waits for

  template <class Archive>
  void serialize(Archive& archive) {
    archive(message, turn, begins_turn, is_unclear, raised, is_no_answer);
    archive.needs(message);
  }
};

} // namespace parlour::dialogue

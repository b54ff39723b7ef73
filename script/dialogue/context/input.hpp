// A message on its way to the pipeline, and the user turn it belongs to.
#pragma once

#include <memory>

#include "runtime/base/message.hpp"
#include "script/dialogue/agenda/turns.hpp"

namespace parlour::dialogue {

struct Input {
  std::shared_ptr<const Message> message;
  TurnId turn = 0;
  bool begins_turn = false;  // the user spoke
  bool raised = false;       // by the engine itself, for those who listen
  bool is_no_answer = false; // to what a handler waits for
};

} // namespace parlour::dialogue

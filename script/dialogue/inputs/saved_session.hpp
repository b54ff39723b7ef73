// SavedSession: a session as a crash has left it, ready to go on (engine rule
// 7.11).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/message/message.hpp"
#include "script/dialogue/inputs/turn_log.hpp"

namespace parlour::dialogue {

struct SavedSession {
  SessionId id;
  std::uint64_t seed = 1;
  std::uint64_t inputs = 0; // that it has taken
  std::string state;        // the bytes of Conversation::save()
  // What it posted last, and what may not have left.
  std::vector<Message> posts;
  TurnLog turns;
};

} // namespace parlour::dialogue

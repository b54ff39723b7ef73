// SavedSession: a session as a crash has left it, ready to go on (engine rule
// 7.11). Recovery makes it; a session that is made of it has Resumed as its
// first input.
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
  // How many it has taken; the journal goes on counting from there.
  std::uint64_t inputs = 0;
  std::string state; // the bytes of Conversation::save()
  // What it posted last, and what may not have left, in order. Each has its
  // session and correlation, so that who got it already can tell. Empty without
  // a strict journal.
  std::vector<Message> posts;
  TurnLog turns;
  std::string seat = {}; // the configured one; empty: another
};

} // namespace parlour::dialogue

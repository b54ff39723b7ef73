// Which conversations of an application can be played with a server: those that
// are typed, and in which no time is passed or told. Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

// What is said in one turn, and what is expected from then on until the next.
struct PlayedTurn {
  std::vector<std::string> lines; // none before the first turn
  std::vector<const Step*> answers;
};

struct Played {
  const Conversation* conversation = nullptr;
  std::vector<PlayedTurn> turns;
  std::size_t unchecked = 0; // lines that look into the application
};

// Why it cannot be played; nothing where it can.
std::optional<std::string> why_unplayable(const Conversation& conversation);
// Of one that can be played; refers to it.
Played played(const Conversation& conversation);

} // namespace parlour::tools

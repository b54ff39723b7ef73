// What came of one conversation of `parlour test`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/rewording.hpp"

namespace parlour::tools {

// The first line that differs; a conversation ends there.
struct Failure {
  std::uint32_t line = 0;
  std::string expected; // the line, or what should have happened
  // What happened instead.
  std::string found;
};

// The outcome of one conversation.
struct ConversationResult {
  std::string name;
  std::string file;
  std::optional<Failure> failure; // empty: it passed
  std::vector<std::string> said;  // what was said so far: "U: …", "R: …"
  std::vector<std::string> trace; // lines as of `parlour run --trace`
  double seconds = 0;             // real time that the run took
  // If it failed: what the engine had understood, and its state, topics and
  // slots (talk/failure_context.hpp).
  std::vector<std::string> context = {};
  std::vector<Rewording> rewordings = {}; // if Words::any
};

} // namespace parlour::tools

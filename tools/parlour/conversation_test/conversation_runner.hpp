// Holds one conversation against an application: a node of its own in virtual
// time, a copy of the seeded database in memory, a temporary data folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"
#include "tools/parlour/conversation_test/coverage.hpp"
#include "tools/parlour/conversation_test/rewording.hpp"

namespace parlour::tools {

// Time that may pass at an R before the robot says something.
inline constexpr Milliseconds longest_silence{60'000};

struct Failure {
  std::uint32_t line = 0;
  std::string expected; // the line of the file, or what should have been
  std::string found;
};

struct ConversationResult {
  std::string name;
  std::string file;
  std::optional<Failure> failure;
  std::vector<std::string> said; // "U: …", "R: …": the conversation so far
  std::vector<std::string> trace;
  double seconds = 0; // that it took to run
  // What the engine made of it where it failed, a line each (thoughts.hpp).
  std::vector<std::string> thoughts = {};
  std::vector<Rewording> rewordings = {}; // other words that were accepted
};

// Whether an `R:` that the robot says in other words ends the conversation, or
// the words are noted and it goes on. Words that follow an error of a script
// are no other wording.
enum class Words { as_written, any };

// Notes what was reached in `coverage`. Safe to call from several threads, each
// with its own coverage.
ConversationResult hold_conversation(const Application& application,
                                     const Conversation& conversation,
                                     Coverage& coverage,
                                     Words words = Words::as_written);

} // namespace parlour::tools

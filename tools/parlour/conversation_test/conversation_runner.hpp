// Runs one conversation against an application and compares what the robot
// says, posts and stores. Each run has a node of its own in virtual time, a
// copy of the seeded database and a temporary data folder (engine rule 7.5), so
// runs neither see each other nor leave anything behind.
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

// Virtual time that may pass at an `R:` until the robot says something.
inline constexpr Milliseconds longest_silence{60'000};

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

// What to do if the robot uses other words than an `R:` expects: fail
// (as_written), or note them in `rewordings` and go on (any; for --update).
// Words that follow a script's error in the same turn always fail.
enum class Words { as_written, any };

struct HoldOptions {
  Words words = Words::as_written;
  bool restores_after_each_input = false; // actors/node/node_options.hpp
};

// Notes in `coverage` what the conversation reached. Blocks until it has ended.
// Threads may run conversations of one application at the same time, each with
// its own `coverage`.
ConversationResult hold_conversation(const Application& application,
                                     const Conversation& conversation,
                                     Coverage& coverage,
                                     const HoldOptions& options = {});

} // namespace parlour::tools

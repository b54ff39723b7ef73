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
#include "tools/parlour/conversation_test/conversation_result.hpp"
#include "tools/parlour/conversation_test/coverage.hpp"
#include "tools/parlour/conversation_test/spoken_seat.hpp"

namespace parlour::tools {

// Virtual time that may pass at an `R:` until the robot says something.
inline constexpr Milliseconds longest_silence{60'000};

// What to do if the robot uses other words than an `R:` expects: fail
// (as_written), or note them in `rewordings` and go on (any; for --update).
// Words that follow a script's error in the same turn always fail.
enum class Words { as_written, any };

struct HoldOptions {
  Words words = Words::as_written;
  bool restores_after_each_input = false; // actors/node/node_options.hpp
  // For conversations with spoken lines; null: they fail.
  SpokenSeats* seats = nullptr;
};

// Notes in `coverage` what the conversation reached. Blocks until it has ended.
// Threads may run conversations of one application at the same time, each with
// its own `coverage`.
ConversationResult hold_conversation(const Application& application,
                                     const Conversation& conversation,
                                     Coverage& coverage,
                                     const HoldOptions& options = {});

} // namespace parlour::tools

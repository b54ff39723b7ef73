// Repeats the sessions of a journal, one after the other, and tells what was
// said, line by line (docs/running.md).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/message/phrases.hpp"
#include "script/dialogue/inputs/session_history.hpp"
#include "script/program/program.hpp"
#include "tools/parlour/journal/session_lines.hpp"

namespace parlour::tools {

// The options of `parlour replay`.
struct ReplayWishes {
  std::string session;              // empty: all
  std::optional<std::size_t> until; // inputs of each; nothing: all
  bool trace = false;               // also messages, topics and slots
  LineForm form = LineForm::transcript;
};

// Sessions are the same if all inputs led to the same wishes.
struct ReplayOutcome {
  std::size_t sessions = 0; // that were repeated
  std::size_t inputs = 0;   // of all of them
  std::size_t differ = 0;   // sessions that were not the same
  std::size_t others = 0;   // sessions of another program, left out
};

// `print` gets each line. What is private is shown as *** (engine rule 7.6).
ReplayOutcome
replay_sessions(const std::vector<dialogue::SessionHistory>& sessions,
                const std::shared_ptr<const script::Program>& program,
                const std::shared_ptr<const PhraseEvaluator>& phrases,
                const ReplayWishes& wishes,
                const std::function<void(const std::string&)>& print);

} // namespace parlour::tools

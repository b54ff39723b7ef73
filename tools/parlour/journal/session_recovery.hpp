// Brings back the sessions that a run which was killed has left in its journal
// (engine rule 7.11).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/phrases.hpp"
#include "script/dialogue/inputs/saved_session.hpp"
#include "script/program/program.hpp"

namespace parlour::tools {

// Given to Node::go_on() or Node::begin_visit(), each at a seat.
struct RecoveredSessions {
  // In the order in which they were opened.
  std::vector<dialogue::SavedSession> sessions;
  // What cannot be brought back, and why, a line each.
  std::vector<std::string> notices;
};

// Of the journal in that folder; none where it has none. On all cores.
// Reads only: the sessions go on when their owner says so.
Expected<RecoveredSessions>
recover_sessions(const std::filesystem::path& folder,
                 const std::shared_ptr<const script::Program>& program,
                 const std::shared_ptr<const PhraseEvaluator>& phrases);

} // namespace parlour::tools

// The options of a node that keeps a journal, and what it finds there.
#pragma once

#include <filesystem>

#include "actors/node/node_options.hpp"
#include "tools/parlour/journal/session_recovery.hpp"

namespace parlour::tools {

// The options `--journal` and `--strict` of the command line.
struct JournalWishes {
  std::filesystem::path folder; // empty: there is none
  bool strict = false;          // NodeOptions::strict_journal
};

// What a tool starts a node with, and what it hands to NodeHost or go_on().
struct JournaledNode {
  actors::NodeOptions options;
  RecoveredSessions recovered; // of the run before, if it was killed
};

// Errors of kind File: the journal cannot be read or written, or is another
// run's. What goes wrong with it later is told by the options' `log`.
Expected<JournaledNode> with_journal(actors::NodeOptions options,
                                     const JournalWishes& wishes);

} // namespace parlour::tools

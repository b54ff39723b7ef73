// The options of a node that keeps a journal, and what it finds there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "actors/node/node.hpp"
#include "adapters/journal/journal_folder.hpp"
#include "tools/parlour/journal/session_recovery.hpp"

namespace parlour::tools {

// The options `--journal` and `--strict` of the command line. How long it is
// kept, and whether it is strict without the option, the settings say.
struct JournalWishes {
  std::filesystem::path folder; // empty: there is none
  bool strict = false;          // NodeOptions::strict_journal
};

// What a tool starts a node with, and what it hands to NodeHost or go_on().
struct JournaledNode {
  actors::NodeOptions options;
  RecoveredSessions recovered; // of the run before, if it was killed
};

// How the command line and the settings want it. In virtual time there is no
// strict journal (engine rule 7.11).
adapters::JournalFolder::Options
journal_options(const actors::NodeOptions& node, const JournalWishes& wishes);

// Errors of kind File: the journal cannot be read or written, or is another
// run's. What goes wrong with it later is told by the options' `log`.
Expected<JournaledNode> with_journal(actors::NodeOptions options,
                                     const JournalWishes& wishes);

// Conversations of configured seats go on there; returned are the others, and
// that of the seat `except`, in their order.
std::vector<dialogue::SavedSession>
go_on_at_seats(actors::Node& node, const Settings& settings,
               std::vector<dialogue::SavedSession> left,
               const std::string& except = {});

} // namespace parlour::tools

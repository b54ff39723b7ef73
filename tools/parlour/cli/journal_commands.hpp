// The commands `parlour journal list|verify|export`. They follow the rules of
// commands.hpp.
#pragma once

#include <string>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

struct JournalOptions {
  std::string journal;     // a folder
  std::string app;         // whose program it is
  std::string session;     // empty: all
  std::string as = "test"; // or "json", "transcript"
};

// `parlour journal list`: the sessions of a journal, a line each.
int journal_list_command(const Places& places, const JournalOptions& options,
                         const Console& console);

// `parlour journal verify`: reads all of it; what is damaged is told with its
// place, and is an error.
int journal_verify_command(const Places& places, const JournalOptions& options,
                           const Console& console);

// `parlour journal export`: its sessions as conversation tests, as transcripts,
// or an object of JSON a line.
int journal_export_command(const Places& places, const JournalOptions& options,
                           const Console& console);

struct JournalCommand {
  const char* name;
  const char* sentence;
  int (*run)(const Places&, const JournalOptions&, const Console&);
};
inline constexpr JournalCommand journal_commands[] = {
    {"list", "Its sessions", journal_list_command},
    {"verify", "Whether anything in it is damaged", journal_verify_command},
    {"export", "Its sessions as conversation tests, or otherwise",
     journal_export_command},
};

} // namespace parlour::tools

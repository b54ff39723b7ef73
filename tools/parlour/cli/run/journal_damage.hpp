// What is wrong with a journal, as its commands tell it.
#pragma once

#include <string>

#include <fmt/format.h>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/journal/journal_sessions.hpp"

namespace parlour::tools {

inline void tell_damage(const JournalSessions& journal, const std::string& name,
                        const Console& console) {
  if (journal.torn > 0)
    say_warning(console,
                fmt::format("{}: the last record was not finished; its {} "
                            "bytes are left out",
                            name, journal.torn));
  for (const auto& damage : journal.damages)
    say_error(console, fmt::format("{}/{}", name, damage));
  if (!journal.broken.empty())
    say_error(console, fmt::format("{} sessions cannot be repeated, as some of "
                                   "their records cannot be read",
                                   journal.broken.size()));
}

} // namespace parlour::tools

// Reads the sessions of a journal.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/dialogue/inputs/session_history.hpp"

namespace parlour::tools {

// All of it in memory: a recovery needs little, a replay what was kept.
struct JournalSessions {
  // In the order in which they were opened. An id may come twice, where runs
  // with the same seed share a journal.
  std::vector<dialogue::SessionHistory> sessions;
  // Each with its file and place; what stands behind a damage in a file was not
  // read, and sessions that need it are not among the sessions.
  std::vector<std::string> damages;
  std::vector<SessionId> broken;
  // Bytes at the ends of files that a crash left unfinished.
  std::size_t torn = 0;
};

// What a journal has to say, part by part.
// Parts have to come in order. A session's records may be in several of them.
class JournalSessionsReader {
public:
  explicit JournalSessionsReader(dialogue::HistoryFrom from) : from_(from) {}

  // One part; `name` is told with what is wrong in it.
  void take(const std::string& name, std::string_view bytes);
  JournalSessions finish();

private:
  // `broken`: a record of it is missing, and no state has come since.
  struct Known {
    dialogue::SessionHistory history;
    bool broken = false;
  };
  void take(dialogue::SessionRecord record);
  void damaged(const std::string& what);

  const dialogue::HistoryFrom from_;
  std::vector<Known> all_;
  std::map<SessionId, std::size_t> place_;
  JournalSessions read_;
};

// Of a folder: all parts, or those that sessions which may be open need. An
// error, of kind File: it cannot be read, or has no part.
Expected<JournalSessions> read_sessions(const std::filesystem::path& folder,
                                        dialogue::HistoryFrom from);

} // namespace parlour::tools

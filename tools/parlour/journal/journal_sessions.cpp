#include "tools/parlour/journal/journal_sessions.hpp"

#include <utility>

#include "adapters/journal/journal_format.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::tools {

namespace {

using dialogue::HistoryFrom;
using dialogue::SessionRecord;

} // namespace

// A damage ends the part: where the next record would begin is not known.
void JournalSessionsReader::take(const std::string& name,
                                 std::string_view bytes) {
  auto reader = adapters::JournalReader::over(bytes);
  if (!reader)
    return damaged(name + ": " + reader.error().message);
  while (const auto record_bytes = reader->next()) {
    if (!*record_bytes)
      return damaged(name + ": " + record_bytes->error().message);
    auto record = dialogue::read_record(**record_bytes);
    if (!record)
      return damaged(name + ": " + record.error().message);
    take(std::move(*record));
  }
  read_.torn += reader->torn_bytes();
}

// Nobody knows whose records stand behind it. A state that is kept later mends
// a session.
void JournalSessionsReader::damaged(const std::string& what) {
  read_.damages.push_back(what);
  for (auto& known : all_)
    known.broken |= !known.history.closed;
}

// An id that is opened again is another session, of a later run with the same
// seed.
void JournalSessionsReader::take(SessionRecord record) {
  const bool opens =
      std::holds_alternative<dialogue::SessionOpened>(record.what);
  const bool mends = std::holds_alternative<dialogue::StateKept>(record.what);
  auto [found, is_new] = place_.try_emplace(record.session, all_.size());
  if (is_new || opens) {
    found->second = all_.size();
    all_.emplace_back();
  }
  auto& known = all_[found->second];
  if (known.broken && mends)
    known = {};
  known.broken |= !dialogue::take(known.history, std::move(record), from_);
  // What is over need not be kept in memory to go on.
  if (known.history.closed && from_ == HistoryFrom::last_state) {
    known.history.inputs = {};
    known.history.state = {};
  }
}

// A session that is broken but closed is of no use and needs no notice: nobody
// wants to go on with it.
JournalSessions JournalSessionsReader::finish() {
  for (auto& known : all_)
    if (known.broken && !known.history.closed)
      read_.broken.push_back(known.history.id);
    else if (!known.broken)
      read_.sessions.push_back(std::move(known.history));
  return std::move(read_);
}

// A recovery leaves out the parts that no open session needs, a replay reads
// all.
Expected<JournalSessions> read_sessions(const std::filesystem::path& folder,
                                        HistoryFrom from) {
  const auto parts = adapters::parts_of(folder);
  if (!parts)
    return tl::make_unexpected(parts.error());
  if (parts->empty())
    return fail(ErrorKind::file,
                "this folder has no journal: there is no "
                "000001.journal in it",
                {folder.string(), 0, 0});
  const auto first =
      from == HistoryFrom::last_state ? adapters::first_needed(*parts) : 0;
  JournalSessionsReader reader(from);
  for (const auto& [number, path] : *parts) {
    if (number < first)
      continue;
    const auto bytes = read_file(path, adapters::max_part_bytes);
    if (!bytes)
      return tl::make_unexpected(bytes.error());
    reader.take(path.filename().string(), *bytes);
  }
  return reader.finish();
}

} // namespace parlour::tools

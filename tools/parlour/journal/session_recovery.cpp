#include "tools/parlour/journal/session_recovery.hpp"

#include <utility>

#include <fmt/format.h>

#include "script/dialogue/inputs/recovery.hpp"
#include "tools/parlour/console/in_parallel.hpp"
#include "tools/parlour/journal/journal_sessions.hpp"

namespace parlour::tools {

// Each session is repeated by itself, so that they share the cores; one that
// has ended has an outcome without a session, and is passed over.
Expected<RecoveredSessions>
recover_sessions(const std::filesystem::path& folder,
                 const std::shared_ptr<const script::Program>& program,
                 const std::shared_ptr<const PhraseEvaluator>& phrases) {
  const auto journal = read_sessions(folder, dialogue::HistoryFrom::last_state);
  if (!journal)
    return tl::make_unexpected(journal.error());
  const auto& histories = journal->sessions;
  using Outcome = Expected<std::unique_ptr<dialogue::SavedSession>>;
  std::vector<Outcome> outcomes(histories.size());
  in_parallel(histories.size(), 0, [&](std::size_t i) {
    outcomes[i] = dialogue::recover(program, phrases, histories[i]);
  });
  RecoveredSessions recovered;
  for (std::size_t i = 0; i < histories.size(); ++i)
    if (!outcomes[i])
      recovered.notices.push_back(fmt::format("session {} cannot go on: {}",
                                              histories[i].id,
                                              outcomes[i].error().message));
    else if (*outcomes[i])
      recovered.sessions.push_back(std::move(**outcomes[i]));
  for (const auto& damage : journal->damages)
    recovered.notices.push_back("the journal: " + damage);
  for (const auto& id : journal->broken)
    recovered.notices.push_back(
        fmt::format("session {} cannot go on: some of its records cannot be "
                    "read",
                    id));
  return recovered;
}

} // namespace parlour::tools

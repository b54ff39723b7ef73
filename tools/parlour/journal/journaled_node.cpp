#include "tools/parlour/journal/journaled_node.hpp"

#include <chrono>
#include <utility>

namespace parlour::tools {

// The option counts in any case: it says nothing of being relaxed.
adapters::JournalFolder::Options
journal_options(const actors::NodeOptions& node, const JournalWishes& wishes) {
  const auto sessions =
      node.program ? node.program->settings.sessions : SessionSettings();
  adapters::JournalFolder::Options options;
  options.log = node.log;
  options.keep = std::chrono::ceil<std::chrono::seconds>(sessions.keep_journal);
  const bool strict = wishes.strict || sessions.strict_journal;
  if (strict && !node.virtual_start)
    options.sync = adapters::JournalSync::on_disk;
  else if (strict && node.log)
    node.log("a strict journal is wanted, which there is not in virtual time: "
             "it is relaxed");
  return options;
}

// The journal first: nobody else writes there from then on.
Expected<JournaledNode> with_journal(actors::NodeOptions options,
                                     const JournalWishes& wishes) {
  if (wishes.folder.empty())
    return JournaledNode{std::move(options), {}};
  auto its = journal_options(options, wishes);
  options.strict_journal = its.sync == adapters::JournalSync::on_disk;
  auto journal = adapters::JournalFolder::open(wishes.folder, std::move(its));
  if (!journal)
    return tl::make_unexpected(journal.error());
  auto recovered =
      recover_sessions(wishes.folder, options.program, options.phrases);
  if (!recovered)
    return tl::make_unexpected(recovered.error());
  options.journal = std::move(*journal);
  return JournaledNode{std::move(options), std::move(*recovered)};
}

// Where an event has opened another one there meanwhile, the one before goes to
// the caller, too.
std::vector<dialogue::SavedSession>
go_on_at_seats(actors::Node& node, const Settings& settings,
               std::vector<dialogue::SavedSession> left,
               const std::string& except) {
  std::erase_if(left, [&](const dialogue::SavedSession& saved) {
    return saved.seat != except && find_seat(settings.seats, saved.seat) &&
           !node.go_on(saved.seat, saved).empty();
  });
  return left;
}

} // namespace parlour::tools

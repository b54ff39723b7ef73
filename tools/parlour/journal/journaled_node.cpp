#include "tools/parlour/journal/journaled_node.hpp"

#include <utility>

#include "adapters/journal/journal_folder.hpp"

namespace parlour::tools {

// The journal first: nobody else writes there from then on.
Expected<JournaledNode> with_journal(actors::NodeOptions options,
                                     const JournalWishes& wishes) {
  if (wishes.folder.empty())
    return JournaledNode{std::move(options), {}};
  adapters::JournalFolder::Options its;
  its.log = options.log;
  if (wishes.strict)
    its.sync = adapters::JournalSync::on_disk;
  auto journal = adapters::JournalFolder::open(wishes.folder, std::move(its));
  if (!journal)
    return tl::make_unexpected(journal.error());
  auto recovered =
      recover_sessions(wishes.folder, options.program, options.phrases);
  if (!recovered)
    return tl::make_unexpected(recovered.error());
  options.journal = std::move(*journal);
  options.strict_journal = wishes.strict;
  return JournaledNode{std::move(options), std::move(*recovered)};
}

} // namespace parlour::tools

// Runs that are killed and go on are in tests/tools/parlour/replay_test.py.
#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/journal/journaled_node.hpp"

namespace parlour::tools {
namespace {

TEST(JournaledNode, HasNoneUnlessToldTo) {
  const auto made = with_journal({}, {}).value();
  EXPECT_FALSE(made.options.journal);
}

TEST(JournaledNode, BeginsAJournal) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "kept";
  const auto made = with_journal({}, {path, true}).value();
  EXPECT_TRUE(made.options.journal);
  EXPECT_TRUE(made.options.strict_journal);
  EXPECT_EQ(adapters::parts_of(path)->size(), 1u);
  EXPECT_FALSE(with_journal({}, {path, true})) << "it is another's";
}

} // namespace
} // namespace parlour::tools

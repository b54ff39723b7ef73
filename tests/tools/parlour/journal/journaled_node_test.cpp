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

// A node's options as the settings have them.
actors::NodeOptions options_with(const SessionSettings& sessions) {
  auto program = std::make_shared<script::Program>();
  program->settings.sessions = sessions;
  actors::NodeOptions options;
  options.program = std::move(program);
  return options;
}

TEST(JournaledNode, IsStrictWhereTheSettingsSayIt) {
  const test::TemporaryFolder folder;
  SessionSettings sessions;
  const auto strict = [&](const char* name, bool option) {
    return with_journal(options_with(sessions), {folder.path() / name, option})
        .value()
        .options.strict_journal;
  };
  EXPECT_FALSE(strict("relaxed", false));
  EXPECT_TRUE(strict("option", true));
  sessions.strict_journal = true;
  EXPECT_TRUE(strict("settings", false));
  EXPECT_FALSE(
      with_journal(options_with(sessions), {}).value().options.strict_journal)
      << "nobody keeps one";
}

TEST(JournaledNode, IsRelaxedInVirtualTimeAndSaysSo) {
  const test::TemporaryFolder folder;
  SessionSettings sessions;
  sessions.strict_journal = true;
  auto options = options_with(sessions);
  options.virtual_start = 0;
  std::vector<std::string> logs;
  options.log = [&](const std::string& line) { logs.push_back(line); };
  const auto made =
      with_journal(std::move(options), {folder.path() / "kept", false}).value();
  EXPECT_FALSE(made.options.strict_journal);
  EXPECT_THAT(logs, testing::ElementsAre(testing::HasSubstr("is relaxed")));
}

TEST(JournaledNode, KeepsPartsForAsLongAsTheSettingsSay) {
  using std::chrono::hours;
  SessionSettings sessions;
  EXPECT_EQ(journal_options(options_with(sessions), {}).keep, hours(24 * 7));
  sessions.keep_journal = hours(12);
  EXPECT_EQ(journal_options(options_with(sessions), {}).keep, hours(12));
}

} // namespace
} // namespace parlour::tools

// Runs that are killed and go on are in
// tests/tools/parlour/journal/replay_test.py.
#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "tests/actors/node_fixture.hpp"
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

class SeatsGoOn : public testing::Test {
protected:
  // One whose journal is there, in virtual time.
  JournaledNode make(const std::filesystem::path& path) {
    actors::NodeOptions options;
    options.program = program;
    options.virtual_start = actors::nine_o_clock;
    return with_journal(std::move(options), {path}).value();
  }
  static std::unique_ptr<actors::Node> started(JournaledNode& made) {
    return actors::Node::start(std::move(made.options)).value();
  }

  test::TemporaryFolder folder;
  std::shared_ptr<const script::Program> program = actors::compile(
      actors::echo, "<seat name='desk'/><seat name='hall' closes-after='5s'/>",
      "");
};

// What a killed run leaves is what its folder holds while it runs. Without its
// seat, a session would want another time for its end when it is repeated.
TEST_F(SeatsGoOn, WhereTheyWere) {
  auto before = make(folder.path() / "before");
  const auto journal = std::dynamic_pointer_cast<adapters::JournalFolder>(
      before.options.journal);
  auto node = started(before);
  const auto desk = node->open_seat({});
  const auto hall = node->open_seat({});
  const auto other = node->open_seat({});
  const auto at_desk = node->open(desk);
  const auto at_hall = node->open(hall);
  const auto elsewhere = node->open(other);
  node->run_until_quiet();
  journal->flush();
  std::filesystem::copy(folder.path() / "before", folder.path() / "after");
  auto after = make(folder.path() / "after");
  EXPECT_EQ(after.recovered.sessions.size(), 3u);
  node = started(after);
  const auto others = go_on_at_seats(
      *node, program->settings, std::move(after.recovered.sessions), "desk");
  std::vector<std::string> ids;
  for (const auto& one : others)
    ids.push_back(one.id);
  EXPECT_THAT(ids, testing::ElementsAre(at_desk, elsewhere));
  EXPECT_EQ(node->session_at("hall"), at_hall);
  EXPECT_EQ(node->session_at("desk"), "");
}

} // namespace
} // namespace parlour::tools

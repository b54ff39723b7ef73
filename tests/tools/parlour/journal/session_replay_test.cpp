// Conversations that a node has held are repeated from its journal.
#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tests/support/memory_journal.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/journal/journal_sessions.hpp"
#include "tools/parlour/journal/session_replay.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class SessionReplayTest : public ApplicationTest {
protected:
  const Application application = load("greeter");
  const std::shared_ptr<test::MemoryJournal> journal =
      std::make_shared<test::MemoryJournal>();
  std::vector<std::string> lines;
  bool restores = false; // after each input (engine rule 7.8)

  // One conversation, in virtual time.
  std::vector<std::string> hold(const std::vector<std::string>& turns) {
    auto data = DataFolder::temporary().value();
    auto options = node_options(application, rehearsed(application.composition),
                                {data.path().string(), Timestamp{5}, 7});
    options.journal = journal;
    options.restores_after_each_input = restores;
    std::vector<std::string> said;
    auto node = actors::Node::start(std::move(options)).value();
    const auto seat =
        node->open_seat({[&](const SessionId&, const dialogue::Output& output) {
                           said.push_back(output.text);
                         },
                         {}});
    for (const auto& turn : turns) {
      node->enter(seat, {turn});
      node->run_until_quiet();
    }
    node->stop();
    return said;
  }

  std::vector<dialogue::SessionHistory> kept() const {
    JournalSessionsReader reader(dialogue::HistoryFrom::beginning);
    auto bytes = adapters::part_header(1);
    for (const auto& record : journal->records)
      bytes += adapters::framed(record);
    reader.take("part", bytes);
    return reader.finish().sessions;
  }
  ReplayOutcome replay(const ReplayWishes& wishes = {}) {
    lines.clear();
    return replay_sessions(
        kept(), application.program,
        script::make_phrase_evaluator(application.program), wishes,
        [this](const std::string& line) { lines.push_back(line); });
  }
};

TEST_F(SessionReplayTest, SaysAllThatWasSaid) {
  const auto said = hold({"hello", "bye"});
  ASSERT_FALSE(said.empty());
  const auto outcome = replay();
  EXPECT_EQ(outcome.sessions, 1u);
  EXPECT_EQ(outcome.differ, 0u);
  std::vector<std::string> again;
  for (const auto& line : lines)
    if (line.starts_with("R: "))
      again.push_back(line.substr(3));
  EXPECT_EQ(again, said);
  EXPECT_THAT(lines, testing::Contains("U: hello"));
}

TEST_F(SessionReplayTest, RepeatsAlsoWhatWentOnWithAnotherPort) {
  restores = true;
  hold({"hello", "bye"});
  const auto outcome = replay();
  EXPECT_EQ(outcome.sessions, 1u);
  EXPECT_EQ(outcome.differ, 0u) << testing::PrintToString(lines);
}

TEST_F(SessionReplayTest, StopsWhereItIsToldTo) {
  hold({"hello"});
  EXPECT_EQ(replay({.session = {}, .until = 1}).inputs, 1u);
  EXPECT_EQ(replay({.session = "nobody", .until = {}}).sessions, 0u);
}

TEST_F(SessionReplayTest, ShowsMoreOnRequest) {
  hold({"hello"});
  replay({.session = {}, .until = {}, .trace = true});
  EXPECT_THAT(lines, testing::Contains(HasSubstr("message     ")));
}

TEST_F(SessionReplayTest, LeavesOutSessionsOfAnotherProgram) {
  hold({"hello"});
  const auto other = load("parting");
  const auto outcome = replay_sessions(
      kept(), other.program, script::make_phrase_evaluator(other.program), {},
      [](const std::string&) {});
  EXPECT_EQ(outcome.others, 1u);
  EXPECT_EQ(outcome.sessions, 0u);
}

TEST_F(SessionReplayTest, TellsWhereItIsAnotherOne) {
  hold({"hello"});
  auto sessions = kept();
  auto& inputs = sessions.front().inputs;
  std::swap(inputs[0].answers, inputs[1].answers);
  const auto outcome = replay_sessions(
      sessions, application.program,
      script::make_phrase_evaluator(application.program), {},
      [this](const std::string& line) { lines.push_back(line); });
  EXPECT_EQ(outcome.differ, 1u);
  EXPECT_THAT(lines, testing::Contains(HasSubstr("input 1 differs")));
}

} // namespace
} // namespace parlour::tools

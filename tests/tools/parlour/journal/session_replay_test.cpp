// Conversations that a node has held are repeated from its journal.
#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/journal/session_replay.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

// Keeps the records in memory, as they stand in a file.
class Bytes : public Journal {
public:
  std::string all{adapters::journal_magic};
  void append(std::string record) override {
    all += adapters::framed(record);
  }
};

class SessionReplayTest : public ApplicationTest {
protected:
  const Application application = load("greeter");
  const std::shared_ptr<Bytes> journal = std::make_shared<Bytes>();
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

  Expected<ReplayOutcome> replay(const ReplayWishes& wishes = {}) {
    lines.clear();
    return replay_sessions(
        journal->all, application.program,
        script::make_phrase_evaluator(application.program), wishes,
        [this](const std::string& line) { lines.push_back(line); });
  }
};

TEST_F(SessionReplayTest, SaysAllThatWasSaid) {
  const auto said = hold({"hello", "bye"});
  ASSERT_FALSE(said.empty());
  const auto outcome = replay();
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->sessions, 1u);
  EXPECT_EQ(outcome->differ, 0u);
  std::vector<std::string> again;
  for (const auto& line : lines)
    if (line.starts_with("P: "))
      again.push_back(line.substr(3));
  EXPECT_EQ(again, said);
  EXPECT_THAT(lines, testing::Contains("U: hello"));
}

TEST_F(SessionReplayTest, RepeatsAlsoWhatWentOnWithAnotherPort) {
  restores = true;
  hold({"hello", "bye"});
  const auto outcome = replay();
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->sessions, 1u);
  EXPECT_EQ(outcome->differ, 0u) << testing::PrintToString(lines);
}

TEST_F(SessionReplayTest, StopsWhereItIsToldTo) {
  hold({"hello"});
  EXPECT_EQ(replay({.session = {}, .until = 1})->inputs, 1u);
  EXPECT_EQ(replay({.session = "nobody", .until = {}})->sessions, 0u);
}

TEST_F(SessionReplayTest, ShowsMoreOnRequest) {
  hold({"hello"});
  ASSERT_TRUE(replay({.session = {}, .until = {}, .trace = true}));
  EXPECT_THAT(lines, testing::Contains(HasSubstr("message     ")));
}

TEST_F(SessionReplayTest, LeavesOutSessionsOfAnotherProgram) {
  hold({"hello"});
  const auto other = load("parting");
  const auto outcome = replay_sessions(
      journal->all, other.program, script::make_phrase_evaluator(other.program),
      {}, [](const std::string&) {});
  EXPECT_EQ(outcome->others, 1u);
  EXPECT_EQ(outcome->sessions, 0u);
}

TEST_F(SessionReplayTest, TellsOfDamageAfterWhatIsWhole) {
  hold({"hello"});
  journal->all.back() ^= 1;
  EXPECT_THAT(replay().error().message, HasSubstr("damaged"));
  EXPECT_THAT(lines, testing::Contains("U: hello"));
  journal->all = "nothing";
  EXPECT_FALSE(replay());
}

} // namespace
} // namespace parlour::tools

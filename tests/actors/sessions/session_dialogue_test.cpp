#include "actors/sessions/session.hpp"
#include "actors/sessions/session_dialogue.hpp"
#include "script/dialogue/inputs/recovery.hpp"
#include "tests/actors/node_fixture.hpp"
#include "tests/support/memory_journal.hpp"

namespace parlour::actors {
namespace {

using testing::SizeIs;

// After each input another conversation goes on, mostly with another port.
class SessionDialogueTest : public NodeFixture {
protected:
  SessionDialogueTest() {
    options.restores_after_each_input = true;
  }

  // A handler that does this when the user says something.
  void start_with(const std::string& statements) {
    start("<handler name='Pipeline'><messages><component>"
          "<ASR><RecognitionResult>" +
          statements +
          "</RecognitionResult></ASR></component></messages></handler>");
  }
};

TEST_F(SessionDialogueTest, TimersAreDueAtTheirTimes) {
  start_with("<timer name='egg' after='3s'><speak param='Done.'/></timer>"
             "<wait for='1s'/><speak param='Boiling.'/>");
  EXPECT_THAT(say({"an egg"}), IsEmpty());
  EXPECT_TRUE(node->step_to_next_due(1s));
  EXPECT_THAT(said(), ElementsAre("Boiling."));
  EXPECT_FALSE(node->step_to_next_due(1999ms));
  EXPECT_TRUE(node->step_to_next_due(2s));
  EXPECT_THAT(said(), ElementsAre("Done."));
  EXPECT_EQ(node->now(), nine_o_clock + 3'000);
}

// It would be in doubt with another port.
TEST_F(SessionDialogueTest, AnOutcomeThatIsToComeKeepsThePort) {
  options.components = {answering("Shelf", "Database", "Result")};
  start_with("<querydb param='select 1'/><speak param='Found.'/>");
  EXPECT_THAT(say({"look"}), ElementsAre("Found."));
}

TEST_F(SessionDialogueTest, EventsThatWereSubscribedComeStill) {
  options.components = {component("Door", "Device", [](auto& self, auto&) {
    self.host().after(1s, [&self] { self.fire_event("Opened"); });
  })};
  start("<handler name='Pipeline'><messages><component>"
        "<ASR><RecognitionResult><subscribe source='Door'/>"
        "<post module='Door' command='Watch' param=''/>"
        "</RecognitionResult></ASR>"
        "<Door><Opened><speak param='The door.'/></Opened></Door>"
        "</component></messages></handler>");
  EXPECT_THAT(say({"watch"}), IsEmpty());
  EXPECT_TRUE(node->step_to_next_due(1s));
  EXPECT_THAT(said(), ElementsAre("The door."));
}

TEST_F(SessionDialogueTest, EndsAsUsual) {
  start_with("<speak param='Bye.'/><end/>");
  EXPECT_THAT(say({"bye"}), ElementsAre("Bye."));
  EXPECT_TRUE(node->session_at(seat).empty());
}

// -- rest ---------------------------------------------------------------------

// Engine rule 7.14.
class RestingSessionTest : public NodeFixture {
protected:
  void start_with(const std::string& statements) {
    start("<var name='tally' expr='0'/>"
          "<handler name='Pipeline'><messages><component>"
          "<ASR><RecognitionResult><set name='tally' expr='tally + 1'/>" +
              statements +
              "</RecognitionResult></ASR></component></messages></handler>",
          "<sessions rest-after='10s' closes-after='1h'/>");
  }
  bool rests() {
    for (const auto& one : node->status())
      if (one.kind == session_state::name && one.name == session())
        return one.doing == "is at rest";
    return false;
  }
  SessionId session() const {
    return node->session_at(seat);
  }
};

TEST_F(RestingSessionTest, GoesOnAsItWas) {
  start_with("<speak param='{tally}.'/>");
  EXPECT_THAT(say({"a"}), ElementsAre("1."));
  const auto id = session();
  EXPECT_FALSE(rests());
  node->advance(9s);
  EXPECT_FALSE(rests());
  node->advance(6s);
  EXPECT_TRUE(rests());
  EXPECT_THAT(say({"b"}), ElementsAre("2."));
  EXPECT_FALSE(rests());
  EXPECT_EQ(session(), id);
  node->advance(15s);
  EXPECT_TRUE(rests());
}

TEST_F(RestingSessionTest, IsRungByItsTimers) {
  start_with("<timer name='egg' after='1m'><speak param='Done.'/></timer>");
  say({"an egg"});
  node->advance(59s);
  EXPECT_TRUE(rests());
  EXPECT_THAT(said(), IsEmpty());
  node->advance(1s);
  EXPECT_THAT(said(), ElementsAre("Done."));
  EXPECT_FALSE(rests());
}

TEST_F(RestingSessionTest, IsNoneThatWaitsForSomebody) {
  options.components = {component("Shelf", "Database", [](auto&, auto&) {})};
  start("<handler name='Pipeline'><messages><component>"
        "<ASR><RecognitionResult><querydb param='select 1'/>"
        "</RecognitionResult></ASR></component></messages></handler>",
        "<sessions rest-after='1s' closes-after='1h' request-timeout='1m'/>");
  say({"look"});
  node->advance(30s);
  EXPECT_FALSE(rests());
}

TEST_F(RestingSessionTest, EndsAsUsual) {
  start("<handler name='Pipeline'><messages><component>"
        "<Session><Ended><speak param='Bye.'/></Ended></Session>"
        "</component></messages></handler>",
        "<sessions rest-after='10s' closes-after='1m'/>");
  say({"hello"});
  node->advance(30s);
  EXPECT_TRUE(rests());
  node->advance(31s);
  EXPECT_TRUE(session().empty());
  EXPECT_THAT(said(), ElementsAre("Bye."));
}

TEST_F(RestingSessionTest, NeverRestsWhereItIsToldSo) {
  start(echo, "<sessions rest-after='0s' closes-after='10h'/>");
  say({"hello"});
  node->advance(1h);
  EXPECT_FALSE(rests());
  EXPECT_THAT(say({"a"}), ElementsAre("You said: a"));
}

// -- the journal --------------------------------------------------------------

class JournaledSessionTest : public NodeFixture {
protected:
  std::shared_ptr<test::MemoryJournal> journal =
      std::make_shared<test::MemoryJournal>();

  bool strict = true;
  std::string script;

  void start_with(const std::string& statements) {
    script = "<handler name='Pipeline'><messages><component>"
             "<ASR><RecognitionResult>" +
             statements +
             "</RecognitionResult></ASR></component></messages></handler>";
    start_again();
  }
  void start_again() {
    options.journal = journal;
    options.strict_journal = strict;
    start(script);
  }
  // What the journal has of the last session that was opened.
  dialogue::SessionHistory history() {
    dialogue::SessionHistory history;
    for (const auto& bytes : journal->records) {
      auto record = dialogue::read_record(bytes).value();
      if (std::holds_alternative<dialogue::SessionOpened>(record.what))
        history = {};
      EXPECT_TRUE(dialogue::take(history, std::move(record),
                                 dialogue::HistoryFrom::last_state));
    }
    return history;
  }
  std::unique_ptr<dialogue::SavedSession> recovered() {
    return dialogue::recover(compile(script), nullptr, history()).value();
  }
};

TEST_F(JournaledSessionTest, NothingIsSaidBeforeItIsWritten) {
  start_with("<speak param='One.'/>");
  journal->writes_at_once = false;
  EXPECT_THAT(say({"hello"}), IsEmpty());
  EXPECT_GT(journal->waiting(), 0u);
  journal->write();
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("One."));
}

TEST_F(JournaledSessionTest, NothingIsPostedBeforeItIsWritten) {
  std::vector<std::string> got;
  options.components = {component("Door", "Device", [&](auto&, auto& message) {
    got.push_back(message.command);
  })};
  start_with("<post module='Door' command='Open' param=''/>");
  journal->writes_at_once = false;
  say({"open"});
  EXPECT_THAT(got, IsEmpty());
  EXPECT_THAT(recovered()->posts, SizeIs(1));
  journal->write();
  node->run_until_quiet();
  EXPECT_THAT(got, ElementsAre("Open"));
  EXPECT_THAT(recovered()->posts, IsEmpty());
}

// What follows a change is repeated with the other program, from a state.
class ChangedSessionTest : public JournaledSessionTest {
protected:
  static std::string counter(const std::string& words) {
    return "<var name='tally' expr='0'/>"
           "<handler name='Pipeline'><messages><component>"
           "<ASR><RecognitionResult><set name='tally' expr='tally + 1'/>"
           "<speak param='" +
           words +
           " {tally}.'/></RecognitionResult></ASR></component></messages>"
           "</handler>";
  }
  void change_to(const std::string& words, ReloadMode mode) {
    script = counter(words);
    ChangedApplication to;
    to.program = compile(script);
    ASSERT_TRUE(node->reload(to, mode));
    node->run_until_quiet();
  }
};

TEST_F(ChangedSessionTest, GoesOnAfterACrash) {
  script = counter("One");
  start_again();
  say({"a"});
  change_to("Two", ReloadMode::keep);
  EXPECT_THAT(say({"b"}), ElementsAre("Two 2."));
  const auto saved = recovered();
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->turns.said.size(), 1U);
  start_again();
  EXPECT_EQ(node->go_on(seat, *saved), saved->id);
  EXPECT_THAT(say({"c"}), ElementsAre("Two 3."));
}

TEST_F(ChangedSessionTest, ThatBeganAgainDoesToo) {
  script = counter("One");
  start_again();
  say({"a"});
  change_to("Two", ReloadMode::restart);
  EXPECT_THAT(say({"b"}), ElementsAre("Two 1."));
  const auto saved = recovered();
  ASSERT_TRUE(saved);
  start_again();
  EXPECT_EQ(node->go_on(seat, *saved), saved->id);
  EXPECT_THAT(say({"c"}), ElementsAre("Two 2."));
}

TEST_F(JournaledSessionTest, GoesOnWhereItWas) {
  script = "<var name='tally' expr='0'/>"
           "<handler name='Pipeline'><messages><component>"
           "<ASR><RecognitionResult><set name='tally' expr='tally + 1'/>"
           "<speak param='{tally}.'/></RecognitionResult></ASR>"
           "</component></messages></handler>";
  start_again();
  EXPECT_THAT(say({"a"}), ElementsAre("1."));
  EXPECT_THAT(say({"b"}), ElementsAre("2."));
  const auto id = node->session_at(seat);
  const auto saved = recovered();
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->id, id);
  ASSERT_THAT(saved->turns.said, SizeIs(1));
  EXPECT_EQ(saved->turns.said[0].text, "2.");
  start_again();
  EXPECT_EQ(node->go_on(seat, *saved), id);
  EXPECT_EQ(history().before, saved->inputs);
  EXPECT_THAT(say({"c"}), ElementsAre("3."));
}

TEST_F(JournaledSessionTest, WhatHasEndedDoesNotGoOn) {
  start_with("<end/>");
  say({"bye"});
  EXPECT_TRUE(history().closed);
  EXPECT_FALSE(recovered());
}

TEST_F(JournaledSessionTest, AnotherPartBeginsWithTheState) {
  start_with("<speak param='One.'/>");
  say({"hello"});
  EXPECT_EQ(history().before, 0u);
  journal->begin_part();
  say({"hello"});
  EXPECT_GT(history().before, 0u);
  EXPECT_TRUE(recovered());
}

TEST_F(JournaledSessionTest, WhereNothingCanBeKeptAStrictSessionEnds) {
  start_with("<speak param='One.'/>");
  say({"hello"});
  journal->is_full = true;
  EXPECT_THAT(say({"hello"}), IsEmpty());
  EXPECT_TRUE(node->session_at(seat).empty());
}

// Its end waits for the journal, and a late turn behind it.
TEST_F(JournaledSessionTest, ALateTurnWaitsForTheEndToBeWritten) {
  start_with("<speak param='Bye.'/><end/>");
  journal->writes_at_once = false;
  EXPECT_THAT(say({"bye"}), IsEmpty());
  const auto id = node->session_at(seat);
  EXPECT_THAT(say({"one more"}), IsEmpty());
  EXPECT_EQ(node->session_at(seat), id);
  journal->writes_at_once = true;
  journal->write();
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Bye.", "Bye."));
  EXPECT_TRUE(node->session_at(seat).empty());
}

// It is there until its end is written, and goes over to nothing.
TEST_F(JournaledSessionTest, ASessionThatHasEndedDoesNotGoOver) {
  start_with("<speak param='Bye.'/><end/>");
  journal->writes_at_once = false;
  say({"bye"});
  EXPECT_FALSE(node->session_at(seat).empty());
  ChangedApplication to;
  to.program = compile(echo);
  const auto outcome = node->reload(to, ReloadMode::keep);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->sessions.gone_over, 0U);
  EXPECT_EQ(outcome->sessions.later, 0U);
  journal->write();
  node->run_until_quiet();
}

// It has no room for the end of a session.
class ForgetsTheEnd : public test::MemoryJournal {
public:
  Place append(std::string record) override {
    const auto read = dialogue::read_record(record).value();
    is_full |= std::holds_alternative<dialogue::SessionClosed>(read.what);
    return MemoryJournal::append(std::move(record));
  }
};

TEST_F(JournaledSessionTest, AStrictSessionWhoseEndIsLostLeavesItsSeat) {
  journal = std::make_shared<ForgetsTheEnd>();
  start_with("<speak param='Bye.'/><end/>");
  EXPECT_THAT(say({"bye"}), ElementsAre("Bye."));
  EXPECT_TRUE(node->session_at(seat).empty());
}

// The state that follows a gap makes it whole.
TEST_F(JournaledSessionTest, ARelaxedSessionGoesOnBehindAGap) {
  strict = false;
  start_with("<speak param='One.'/>");
  say({"hello"});
  journal->is_full = true;
  EXPECT_THAT(say({"hello"}), ElementsAre("One."));
  journal->is_full = false;
  EXPECT_THAT(say({"hello"}), ElementsAre("One."));
  EXPECT_GT(history().before, 0u);
  EXPECT_TRUE(recovered());
}

} // namespace
} // namespace parlour::actors

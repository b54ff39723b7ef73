// A running node goes over to changed scripts and components (engine rule
// 7.13).
#include <future>

#include "actors/node/node.hpp"
#include "actors/node/reloader.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using testing::Contains;
using testing::Pair;

class ReloaderTest : public NodeFixture {
protected:
  ChangedApplication changed(const std::string& elements,
                             const std::string& settings = "",
                             const std::string& beginning = "") {
    ChangedApplication to;
    to.program = compile(elements, settings, beginning);
    to.components = components;
    return to;
  }
  // The same components as before, unless the test says otherwise.
  Expected<ReloadOutcome> reload(const std::string& elements,
                                 ReloadMode mode = ReloadMode::keep,
                                 const std::string& beginning = "") {
    return node->reload(changed(elements, "", beginning), mode);
  }
  void start_with(const std::string& elements,
                  const std::string& beginning = "") {
    options.components = components;
    start(elements, "", beginning);
  }

  // Counts turns, and has a state with an opening prompt.
  static std::string counter(const std::string& words,
                             const std::string& more = "") {
    return "<var name='turns' expr='0'/><state name='Desk'><Entrance>"
           "<speak param='Welcome.'/></Entrance></state>"
           "<handler name='H'><messages><component><ASR><RecognitionResult>"
           "<set name='turns' expr='turns + 1'/><speak param='" +
           words + " {turns}'/>" + more +
           "</RecognitionResult></ASR></component></messages></handler>";
  }

  std::vector<ComponentOrder> components;
};

TEST(Reloader, KnowsWhichComponentsStartFirst) {
  auto database = answering("Rows", "Database", "Answer");
  auto robot = answering("Olivia", "Robot", "Arrived");
  auto ear = answering("Ear", "Microphone", "Audio");
  ear.policy.scope.kind = Scope::Kind::seat;
  EXPECT_LT(phase_of_start(database), phase_of_start(robot));
  EXPECT_LT(phase_of_start(robot), phase_of_start(ear));
}

TEST_F(ReloaderTest, ConversationsGoOnWhereTheyAre) {
  start_with(counter("One:"), "Desk");
  EXPECT_THAT(say({"a", "b"}), ElementsAre("Welcome.", "One: 1", "One: 2"));
  const auto session = node->session_at(seat);
  const auto outcome = reload(counter("Two:"), ReloadMode::keep, "Desk");
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->sessions.gone_over, 1U);
  EXPECT_EQ(outcome->sessions.later, 0U);
  EXPECT_THAT(outcome->sessions.lost, IsEmpty());
  EXPECT_THAT(said(), IsEmpty());
  EXPECT_THAT(say({"c"}), ElementsAre("Two: 3"));
  EXPECT_EQ(node->session_at(seat), session);
  EXPECT_EQ(node->state(session), "Desk");
}

TEST_F(ReloaderTest, WhatIsLostIsCounted) {
  start_with("<var name='mood' expr='1'/>" + counter("One:"), "Desk");
  say({"a"});
  open_seat();
  say({"a"});
  const auto outcome = reload(counter("Two:"), ReloadMode::keep, "Desk");
  ASSERT_TRUE(outcome);
  EXPECT_THAT(outcome->sessions.lost,
              ElementsAre(Pair("the variable 'mood'", 2U)));
}

TEST_F(ReloaderTest, ConversationsCanBeginAgain) {
  start_with(counter("One:", "<timer name='late' after='5s'>"
                             "<speak param='Late.'/></timer>"),
             "Desk");
  say({"a", "b"});
  const auto session = node->session_at(seat);
  const auto outcome = reload(counter("Two:"), ReloadMode::restart, "Desk");
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->sessions.gone_over, 1U);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Welcome."));
  EXPECT_THAT(say({"c"}), ElementsAre("Two: 1"));
  EXPECT_EQ(node->session_at(seat), session);
  node->advance(10s);
  EXPECT_THAT(said(), IsEmpty());
  EXPECT_EQ(over, 0);
}

TEST_F(ReloaderTest, OnlyNewConversationsAreChanged) {
  start_with(counter("One:"), "Desk");
  say({"a"});
  ASSERT_TRUE(reload(counter("Two:"), ReloadMode::new_only, "Desk"));
  EXPECT_THAT(say({"b"}), ElementsAre("One: 2"));
  node->end(node->session_at(seat));
  node->run_until_quiet();
  EXPECT_THAT(say({"c"}), ElementsAre("Welcome.", "Two: 1"));
}

TEST_F(ReloaderTest, ScriptsComeToTheirEndFirst) {
  start_with(counter("One:", "<wait for='10s'/><speak param='Done.'/>"));
  EXPECT_THAT(say({"a"}), ElementsAre("One: 1"));
  const auto outcome = reload(counter("Two:"));
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->sessions.later, 1U);
  EXPECT_EQ(outcome->sessions.gone_over, 0U);
  node->advance(11s);
  EXPECT_THAT(said(), ElementsAre("Done."));
  EXPECT_THAT(say({"b"}), ElementsAre("Two: 2"));
}

TEST_F(ReloaderTest, ScriptsThatTakeTooLongAreEnded) {
  start_with("<var name='x' expr='0'/>" +
             counter("One:", "<try><wait for='1h'/><catch name='e'>"
                             "<speak param='{e.kind}'/></catch></try>"));
  say({"a"});
  ASSERT_TRUE(reload(counter("Two:")));
  node->advance(29s);
  EXPECT_THAT(said(), IsEmpty());
  node->advance(2s);
  EXPECT_THAT(said(), ElementsAre("Cancelled"));
  EXPECT_THAT(logs, Contains(HasSubstr("without the variable 'x'")));
  EXPECT_THAT(say({"b"}), ElementsAre("Two: 2"));
}

// The session is still busy when the scripts are changed again.
TEST_F(ReloaderTest, TheLastChangeCounts) {
  start_with(counter("One:", "<wait for='10s'/>"));
  say({"a"});
  ASSERT_TRUE(reload(counter("Two:")));
  ASSERT_TRUE(reload(counter("Three:")));
  node->advance(40s);
  EXPECT_THAT(say({"b"}), ElementsAre("Three: 2"));
}

TEST_F(ReloaderTest, RoutesAreChangedToo) {
  start_with(
      counter("One:") +
      "<routes><filter source='Robot' command='*' drop='true'/></routes>");
  EXPECT_THAT(say({"a"}), ElementsAre("One: 1"));
  ASSERT_TRUE(reload(counter("Two:")));
  EXPECT_THAT(say({"b"}), ElementsAre("Two: 2"));
}

// -- components ---------------------------------------------------------------

class ReloadedComponentsTest : public ReloaderTest {
protected:
  // Asks for the language when it is given a message, and notes that it was
  // made.
  ComponentOrder reader(const std::string& name, bool reads) {
    auto order =
        component(name, "Robot", [reads](FunctionPlugin& self, const Message&) {
          if (reads)
            self.host().understanding();
        });
    order.factory.create = [this, name, create = order.factory.create] {
      made.push_back(name);
      return create();
    };
    return order;
  }
  static std::string posts() {
    return counter("One:", "<post module='Reader' command='Go' param=''/>"
                           "<post module='Other' command='Go' param=''/>");
  }
  std::vector<std::string> made;
};

TEST_F(ReloadedComponentsTest, WhoKnowsTheScriptsIsLoadedAgain) {
  components = {reader("Reader", true), reader("Other", false)};
  start_with(posts());
  say({"a"});
  made.clear();
  const auto outcome = reload(posts());
  ASSERT_TRUE(outcome);
  EXPECT_THAT(outcome->loaded, ElementsAre("Reader"));
  EXPECT_THAT(made, ElementsAre("Reader"));
}

TEST_F(ReloadedComponentsTest, OtherSettingsAreOtherComponents) {
  components = {reader("Reader", false), reader("Other", false)};
  start_with(posts());
  components = {reader("Other", false), reader("Third", false)};
  components[0].options["colour"] = "blue";
  made.clear();
  const auto outcome = reload(posts());
  ASSERT_TRUE(outcome);
  EXPECT_THAT(outcome->loaded, ElementsAre("Other", "Third"));
  EXPECT_THAT(outcome->unloaded, ElementsAre("Reader"));
  EXPECT_THAT(made, ElementsAre("Other", "Third"));
}

TEST_F(ReloadedComponentsTest, OneThatDoesNotStartLeavesAllAsItWas) {
  components = {reader("Reader", true), reader("Other", false)};
  start_with(posts());
  say({"a"});
  auto broken = reader("Broken", false);
  broken.factory.create = []() -> std::unique_ptr<IPlugin> {
    throw std::runtime_error("no line");
  };
  components.push_back(broken);
  const auto outcome = reload(counter("Two:"));
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("no line"));
  EXPECT_THAT(say({"b"}), ElementsAre("One: 2"));
  components.pop_back();
  const auto second = reload(counter("Two:"));
  ASSERT_TRUE(second) << to_string(second.error());
  // The turn waits for what nobody answers (engine rule 3.1).
  EXPECT_EQ(second->sessions.later, 1U);
  node->advance(31s);
  EXPECT_THAT(say({"c"}), ElementsAre("Two: 3"));
}

TEST_F(ReloaderTest, WhatWasNotPrivateCannotBecomeSo) {
  start_with(counter("One:"));
  const auto outcome = reload("<var name='secret' expr='1' private='true'/>");
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::refused);
  EXPECT_THAT(say({"a"}), ElementsAre("One: 1"));
}

// -- in real time -------------------------------------------------------------

TEST_F(ReloaderTest, AnotherThreadMayAskForIt) {
  options.virtual_start = {};
  start_with(counter("One:"), "Desk");
  node->open(seat);
  node->run_until_quiet();
  said();
  const auto to = changed(counter("Two:"), "", "Desk");
  auto done = std::async(std::launch::async, [&] {
    return node->reload(to, ReloadMode::keep).has_value();
  });
  EXPECT_TRUE(done.get());
  EXPECT_THAT(say({"a"}), ElementsAre("Two: 1"));
}

} // namespace
} // namespace parlour::actors

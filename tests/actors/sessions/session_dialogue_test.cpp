#include "actors/sessions/session_dialogue.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

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

} // namespace
} // namespace parlour::actors

#include <stdexcept>
#include <thread>

#include "actors/components/instance/component_host.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using ComponentHostTest = NodeFixture;

constexpr const char* ask_taxi = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <request module="Taxi" command="Book" param="_LPARAM1" return="reply"/>
        <speak param="{reply.params[0]}"/>
        <catch name="e"><speak param="no taxi: {e.message}"/></catch>
      </try>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

TEST_F(ComponentHostTest, AnswersARequest) {
  options.components = {answering("City", "Taxi", "Booked")};
  start(ask_taxi);
  EXPECT_THAT(say({"to the airport"}), ElementsAre("to the airport"));
  EXPECT_THAT(ways_of("Booked"), ElementsAre(HasSubstr("| session")));
}

TEST_F(ComponentHostTest, AnswersAfterADelayInVirtualTime) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        self.host().after(
            2s, [&self, message] { self.answer(message, "Booked", {"S1"}); });
      })};
  start(ask_taxi);
  EXPECT_THAT(say({"home"}), IsEmpty());
  EXPECT_TRUE(node->step_to_next_due(10s));
  EXPECT_EQ(node->now(), nine_o_clock + 2000);
  EXPECT_THAT(said(), ElementsAre("S1"));
}

TEST_F(ComponentHostTest, SurvivesWhatItsPluginThrows) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        if (message.params.at(0) == Value("crash"))
          throw std::runtime_error("engine trouble");
        self.fire_event("Booked", {"S2"});
      })};
  start(ask_taxi);
  EXPECT_THAT(say({"crash"}), ElementsAre("no taxi: City: engine trouble"));
  EXPECT_THAT(logs, ElementsAre("City failed: engine trouble"));
  EXPECT_THAT(say({"home"}), ElementsAre("S2"));
}

TEST_F(ComponentHostTest, IsNotCalledBackForWhatItCancelled) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        const auto delay = self.host().after(
            2s, [&self, message] { self.answer(message, "Booked", {"S1"}); });
        self.host().after(1s, [&self, delay] { self.host().cancel(delay); });
      })};
  start(ask_taxi);
  say({"home"});
  EXPECT_TRUE(node->step_to_next_due(1s));
  node->advance(5s);
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(ComponentHostTest, HearsOfADeadComponentInItsDelays) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message&) {
        self.host().after(1s, [] { throw std::runtime_error("late"); });
      })};
  start(ask_taxi);
  say({"home"});
  node->advance(1s);
  EXPECT_THAT(logs, ElementsAre("City failed: late"));
}

// Really another thread, really waited for: no virtual time.
TEST_F(ComponentHostTest, AnswersFromAThreadOfItsOwn) {
  std::thread worker;
  options.virtual_start.reset();
  options.components = {component(
      "City", "Taxi",
      [&](auto& self, const Message& message) {
        worker = std::thread(
            [&self, message] { self.answer(message, "Booked", {"S3"}); });
      },
      true)};
  start(ask_taxi);
  EXPECT_THAT(say({"home"}), ElementsAre("S3"));
  worker.join();
}

TEST_F(ComponentHostTest, SpeaksUnderItsOwnNameOnly) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        Message event;
        event.source = "System";
        event.command = "Booked";
        event.session = message.session;
        self.host().fire_event(event);
      })};
  start(ask_taxi);
  say({"home"});
  EXPECT_THAT(ways_of("Booked"), ElementsAre(HasSubstr("City.Booked")));
}

} // namespace
} // namespace parlour::actors

#include "actors/routing/message_centre.hpp"
#include "tests/actors/bench.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using MessageCentreTest = NodeFixture;

Message from(std::string source, std::string command) {
  Message message;
  message.source = std::move(source);
  message.command = std::move(command);
  return message;
}

TEST_F(MessageCentreTest, CountsAndShowsWhatNobodyTakes) {
  start(echo);
  auto session = node->open(seat);
  auto lost = from("Desk", "Sound");
  lost.sinks = {"Nobody"};
  node->inject(session, lost);
  node->inject("no such session", from("Desk", "Touch"));
  node->inject("", from("Desk", "Touch"));
  node->run_until_quiet();
  EXPECT_EQ(node->counters().unhandled, 3u);
  EXPECT_THAT(unhandled, ElementsAre(HasSubstr("nobody is there for Nobody"),
                                     HasSubstr("its session is over"),
                                     HasSubstr("no session has subscribed")));
}

TEST_F(MessageCentreTest, GivesWhatHasNoSessionToThoseWhoSubscribed) {
  start(R"(<handler name="H"><messages><component>
           <Session><Started><subscribe source="Kiosk"/></Started></Session>
           <Kiosk><Touch><speak param="touched"/></Touch></Kiosk>
           </component></messages></handler>)");
  node->open(seat);
  node->inject("", from("Kiosk", "Touch"));
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("touched"));
  EXPECT_EQ(node->counters().unhandled, 0u);
}

// Words that came before a timer's moment are heard before it rings, however
// late the centre comes to them: silence is not over while somebody's words
// wait.
TEST(MessageCentre, TellsOfTimersBehindWhatHasComeBefore) {
  Bench bench;
  SessionDirectory sessions;
  const auto session = bench.session_probe("visitor");
  sessions.add("s", session, bench.seat_probe());
  bench.bus.connect(bench.system->spawn(message_centre, &bench.bus, &sessions,
                                        session_manager_actor()));
  auto words = from("Ear", "RecognitionResult");
  words.session = "s";
  bench.bus.bring_in({words});
  bench.bus.ring(session, {7, bench.time.work.begin()});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("visitor gets Ear.RecognitionResult()",
                                      "visitor rings 7"));
}

TEST_F(MessageCentreTest, RelaysToComponents) {
  options.components = {answering("Ear", "ASR", "Heard")};
  start(std::string(echo) +
        R"(<routes><relay source="Mic" command="Sound" to="ASR"
             as="DoRecognition"/></routes>)");
  node->inject(node->open(seat), from("Mic", "Sound"));
  node->run_until_quiet();
  EXPECT_THAT(ways_of("DoRecognition"), ElementsAre(HasSubstr("relay -> ASR")));
  EXPECT_THAT(ways_of("Heard"), ElementsAre(HasSubstr("| session")));
  EXPECT_EQ(node->counters().relayed, 1u);
}

} // namespace
} // namespace parlour::actors

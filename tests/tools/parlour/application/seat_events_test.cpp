#include "tests/tools/parlour/application/seats_fixture.hpp"
#include "tools/parlour/application/seat_events.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

using SeatEventsTest = SeatsTest;

TEST_F(SeatEventsTest, takes_the_events_that_can_come) {
  for (const std::string event :
       {"Telephone.*", "LogTelephone.Answered", "ASR.RecognitionResult",
        "System.ComponentUp", "Olivia.Anything"})
    EXPECT_EQ(errors("<seat name=\"desk\" opens=\"" + event + "\"/>"), "")
        << event;
}

TEST_F(SeatEventsTest, tells_of_an_event_that_nothing_can_fire) {
  EXPECT_THAT(errors("<seat name=\"desk\" opens=\"LogTelephon.Answered\"/>"),
              HasSubstr("error: nothing can fire LogTelephon.Answered: no "
                        "component, role or agent is called 'LogTelephon', "
                        "did you mean 'LogTelephone'?"));
  EXPECT_THAT(errors("<seat name=\"desk\" opens=\"Telephone.Answerd\"/>"),
              HasSubstr("error: nothing can fire Telephone.Answerd, did you "
                        "mean 'Answered'?"));
  EXPECT_THAT(errors("<seat name=\"desk\" opens=\"LogTaxi.Explodes\"/>"),
              HasSubstr("error: nothing can fire LogTaxi.Explodes; its events "
                        "are "));
  EXPECT_THAT(errors("<seat name=\"desk\" opens=\"Script.Greeted\"/>"),
              HasSubstr("error: nothing can fire Script.Greeted at a seat "
                        "where no conversation is going on"));
}

TEST_F(SeatEventsTest, warns_where_nobody_fills_the_role) {
  const auto application =
      with("<seat name=\"desk\" opens=\"VAD.SpeechStarted\"/>");
  EXPECT_FALSE(application.has_errors());
  EXPECT_THAT(findings(application),
              HasSubstr("warning: no component fills the role VAD, so that "
                        "VAD.SpeechStarted never comes but where a run adds "
                        "one (--voice)"));
}

// As an application that is right elsewhere.
TEST_F(SeatEventsTest, says_nothing_of_a_plugin_that_is_not_in_this_build) {
  auto application = with("<seat name=\"desk\" opens=\"LogTaxi.Rolls\"/>");
  EXPECT_TRUE(application.has_errors());
  application = with("<seat name=\"desk\" opens=\"LogTaxi.*\"/>");
  ASSERT_TRUE(application.program);
  auto program = *application.program;
  program.openings[0].command = "Rolls";
  std::erase_if(application.composition.components,
                [](const auto& one) { return one.name == "LogTaxi"; });
  EXPECT_THAT(check_seat_events(program, application.composition),
              testing::IsEmpty());
}

} // namespace
} // namespace parlour::tools

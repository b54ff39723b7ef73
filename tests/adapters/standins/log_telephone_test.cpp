#include "adapters/standins/log_telephone.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

using LogTelephoneTest = StandInTest;

TEST_F(LogTelephoneTest, RingsAndIsAnswered) {
  ASSERT_TRUE(start(log_telephone_factory(), {}));
  EXPECT_THAT(tell("Call", {"64781001", "Dr. Jeffery Ho"}),
              ElementsAre("Ringing()", "Answered()"));
  EXPECT_THAT(tell("Transfer", {"64781002"}),
              ElementsAre("Ringing()", "Answered()"));
  EXPECT_EQ(record("telephone"),
            "2026-11-21T09:00:00\tCall\t64781001,Dr. Jeffery Ho\n"
            "2026-11-21T09:00:00\tTransfer\t64781002\n");
}

TEST_F(LogTelephoneTest, IsBusyOrNotAnsweredAsTold) {
  ASSERT_TRUE(start(log_telephone_factory(), {{"answer", "busy"}}));
  EXPECT_THAT(tell("Call", {"64781001"}), ElementsAre("Ringing()", "Busy()"));
  ASSERT_TRUE(start(log_telephone_factory(), {{"answer", "noanswer"}}));
  EXPECT_THAT(tell("Call", {"64781001"}),
              ElementsAre("Ringing()", "NoAnswer()"));
}

TEST_F(LogTelephoneTest, RingsForAWhile) {
  ASSERT_TRUE(start(log_telephone_factory(), {{"rings", "3s"}}));
  EXPECT_THAT(tell("Call", {"64781001"}), ElementsAre("Ringing()"));
  host.advance(2999ms);
  EXPECT_TRUE(host.events.empty());
  host.advance(1ms);
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].command, "Answered");
  EXPECT_EQ(host.events[0].session, "s1");
  EXPECT_EQ(host.events[0].correlation, 7u);
}

TEST_F(LogTelephoneTest, CannotDialEverything) {
  ASSERT_TRUE(start(log_telephone_factory(), {}));
  EXPECT_THAT(tell("Call", {"Jeffery"}),
              ElementsAre("Failed('Jeffery' is not a telephone number.)"));
  EXPECT_THAT(tell("Call"),
              ElementsAre("Failed('' is not a telephone number.)"));
}

TEST_F(LogTelephoneTest, RefusesWrongOptions) {
  auto started = start(log_telephone_factory(), {{"answer", "maybe"}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().message,
            "option 'answer' is one of 'answered', 'busy', 'noanswer', not "
            "'maybe'");
  EXPECT_FALSE(start(log_telephone_factory(), {{"rings", "long"}}));
}

} // namespace
} // namespace parlour::adapters

#include "adapters/standins/log_sms.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;

using LogSMSTest = StandInTest;

TEST_F(LogSMSTest, Sends) {
  ASSERT_TRUE(start(log_sms_factory(), {}));
  EXPECT_THAT(tell("Send", {"91234567", "SHA 1234 G"}), ElementsAre("Sent()"));
}

TEST_F(LogSMSTest, SaysWhatCannotBeSent) {
  ASSERT_TRUE(start(log_sms_factory(), {}));
  EXPECT_THAT(tell("Send", {"David", "Hello"}),
              ElementsAre("Failed('David' is not a telephone number.)"));
  EXPECT_THAT(tell("Send", {"91234567", " \n"}),
              ElementsAre("Failed(There is no text to send.)"));
}

TEST_F(LogSMSTest, FailsAsTold) {
  ASSERT_TRUE(start(log_sms_factory(), {{"answer", "failed"}}));
  EXPECT_THAT(tell("Send", {"91234567", "Hello"}),
              ElementsAre("Failed(The gateway does not answer.)"));
  EXPECT_FALSE(start(log_sms_factory(), {{"answer", "lost"}}));
}

} // namespace
} // namespace parlour::adapters

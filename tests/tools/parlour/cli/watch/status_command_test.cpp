#include "tests/tools/parlour/watching_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using StatusCommandTest = WatchingTest;

TEST_F(StatusCommandTest, tells_how_a_running_application_is) {
  {
    const Running running(application("greeter"), folders_.path().string());
    ASSERT_EQ(running.hear(), "Hello.\n");
    EXPECT_EQ(call({"status", "greeter"}), exit_code::success) << err_.str();
    EXPECT_THAT(out_.str(),
                AllOf(HasSubstr("message_centre"), HasSubstr("supervisor"),
                      HasSubstr("SQLiteDatabase")));
    EXPECT_EQ(call({"status", application("greeter")}), exit_code::success);
    EXPECT_EQ(call({"status", "--json"}), exit_code::success);
    EXPECT_THAT(out_.str(), HasSubstr("\"application\": \"greeter\""));
    EXPECT_EQ(call({"status", "butler"}), exit_code::wrong);
    EXPECT_THAT(err_.str(),
                HasSubstr("'butler' does not run; running: greeter"));
  }
  EXPECT_EQ(call({"status"}), exit_code::wrong);
}

TEST_F(StatusCommandTest, says_that_nothing_runs) {
  EXPECT_EQ(call({"status"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("no application runs"));
}

} // namespace
} // namespace parlour::tools

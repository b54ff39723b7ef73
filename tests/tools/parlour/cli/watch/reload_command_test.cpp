#include "tests/tools/parlour/watching_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

using ReloadCommandTest = WatchingTest;

TEST_F(ReloadCommandTest, SaysThatNothingRuns) {
  EXPECT_EQ(call({"reload"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("no application runs"));
}

TEST_F(ReloadCommandTest, TellsWhatHasBecomeOfConversations) {
  const Running running(application("greeter"), folders_.path().string());
  ASSERT_EQ(running.hear(), "Hello.\n");
  EXPECT_EQ(call({"reload", "greeter"}), exit_code::success) << err_.str();
  EXPECT_THAT(out_.str(),
              HasSubstr("1 conversation goes on with the changed scripts\n"));
  EXPECT_EQ(call({"reload", "--new-only"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("keep the scripts that they have\n"));
  EXPECT_EQ(call({"reload", "--undo"}), exit_code::success) << err_.str();
}

TEST_F(ReloadCommandTest, NothingCanBeUndoneAtFirst) {
  const Running running(application("greeter"), folders_.path().string());
  ASSERT_EQ(running.hear(), "Hello.\n");
  EXPECT_EQ(call({"reload", "--undo"}), exit_code::wrong);
  EXPECT_THAT(err_.str(),
              testing::AllOf(HasSubstr("nothing has been changed"),
                             HasSubstr("greeter goes on unchanged")));
}

TEST_F(ReloadCommandTest, HasOneMode) {
  EXPECT_EQ(call({"reload", "--new-only", "--restart"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools

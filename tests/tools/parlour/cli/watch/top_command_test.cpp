#include "tests/tools/parlour/watching_fixture.hpp"

namespace parlour::tools {
namespace {

using TopCommandTest = WatchingTest;

TEST_F(TopCommandTest, PrintsOnceWhereNoTerminalIs) {
  const Running running(application("greeter"), folders_.path().string());
  ASSERT_EQ(running.hear(), "Hello.\n");
  for (const auto& arguments :
       {std::vector<std::string>{"top"}, {"top", "greeter", "--once"}}) {
    EXPECT_EQ(call(arguments), exit_code::success) << err_.str();
    EXPECT_THAT(out_.str(),
                testing::AllOf(testing::StartsWith("greeter (process "),
                               testing::HasSubstr("\nsessions  1 open, "),
                               testing::HasSubstr("SQLiteDatabase")));
  }
  EXPECT_EQ(call({"top", "butler"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), testing::HasSubstr("'butler' does not run"));
}

TEST_F(TopCommandTest, SaysThatNothingRuns) {
  EXPECT_EQ(call({"top"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), testing::HasSubstr("no application runs"));
}

} // namespace
} // namespace parlour::tools

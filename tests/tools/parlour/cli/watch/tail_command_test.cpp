#include <cstdio>
#include <memory>

#include <poll.h>

#include "tests/tools/parlour/watching_fixture.hpp"

namespace parlour::tools {
namespace {

using TailCommandTest = WatchingTest;

TEST_F(TailCommandTest, FollowsUntilTheApplicationEnds) {
  const auto folder = folders_.path().string();
  auto running = std::make_unique<Running>(application("greeter"), folder);
  ASSERT_EQ(running->hear(), "Hello.\n");
  auto* const tail =
      popen(("XDG_RUNTIME_DIR=" + folder + " " + test::program_path() +
             " tail greeter --kind message")
                .c_str(),
            "r");
  // Something is said until it is heard at the other end.
  pollfd heard{fileno(tail), POLLIN, 0};
  while (poll(&heard, 1, 0) == 0) {
    running->say("hello\n");
    running->hear();
  }
  running = nullptr;
  std::string text;
  char line[1'000];
  while (std::fgets(line, sizeof line, tail))
    text += line;
  EXPECT_EQ(pclose(tail), 0);
  EXPECT_THAT(text, testing::HasSubstr("  message     "));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("  output  ")));
}

TEST_F(TailCommandTest, SaysThatNothingRuns) {
  EXPECT_EQ(call({"tail"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), testing::HasSubstr("no application runs"));
  EXPECT_EQ(call({"tail", "--kind", "nonsense"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools

// What is served is in tests/tools/parlour/serve/serve_test.py.
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class ServeCommandTest : public CommandTest {};

TEST_F(ServeCommandTest, says_what_is_wrong_with_its_options) {
  EXPECT_EQ(call({"serve", "greeter", "--port", "65536"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("no whole number from 0 to 65535"));
  EXPECT_EQ(call({"serve", "greeter", "--linger", "soon"}), exit_code::usage);
  EXPECT_EQ(call({"serve", "greeter", "--sessions", "0"}), exit_code::usage);
  EXPECT_EQ(call({"serve", "nobody"}), exit_code::usage);
}

TEST_F(ServeCommandTest, says_where_it_cannot_be_heard) {
  EXPECT_EQ(call({"serve", "greeter", "--rehearsed", "--listen", "nowhere"}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("nobody can be served at nowhere"));
}

} // namespace
} // namespace parlour::tools

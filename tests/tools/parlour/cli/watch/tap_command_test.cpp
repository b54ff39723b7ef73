// `parlour tap` is told to whom it listens; with a running application it is
// tested by remote_agent_test.py.
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

using TapCommandTest = CommandTest;

TEST_F(TapCommandTest, names_an_address_that_is_none) {
  EXPECT_EQ(call({"tap", "--connect", "nowhere"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("such as tcp://127.0.0.1:5673"));
  EXPECT_EQ(out_.str(), "");
}

} // namespace
} // namespace parlour::tools

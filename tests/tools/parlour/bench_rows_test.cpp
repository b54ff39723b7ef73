#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/bench_rows.hpp"

namespace parlour::tools {
namespace {

TEST_F(CommandTest, bench_says_which_row_is_not_there) {
  EXPECT_EQ(call({"bench", "nlu", "--only", "turns"}), exit_code::usage);
  EXPECT_THAT(err_.str(), testing::HasSubstr("bench nlu has no row 'turns'"));
}

} // namespace
} // namespace parlour::tools

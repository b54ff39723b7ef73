#include <sstream>

#include <gtest/gtest.h>

#include "tools/parlour/cli/bench_rows.hpp"

namespace parlour::tools {
namespace {

TEST(BenchRows, say_which_is_not_there) {
  std::ostringstream out;
  std::ostringstream err;
  BenchOptions options;
  options.name = "nlu";
  EXPECT_TRUE(has_row({"clinc"}, options, {out, err}));
  options.only = "clinc";
  EXPECT_TRUE(has_row({"clinc"}, options, {out, err}));
  EXPECT_EQ(err.str(), "");
  options.only = "turns";
  EXPECT_FALSE(has_row({"clinc"}, options, {out, err}));
  EXPECT_NE(err.str().find("bench nlu has no row 'turns'"), std::string::npos);
}

} // namespace
} // namespace parlour::tools

#include <sstream>

#include <gtest/gtest.h>

#include "tools/parlour/console/bounded_line.hpp"

namespace parlour::tools {
namespace {

TEST(BoundedLine, EndsWithItsLineOrTheInput) {
  std::istringstream in("one\n\ntwo");
  EXPECT_EQ(read_bounded_line(in, 10)->text, "one");
  EXPECT_EQ(read_bounded_line(in, 10)->text, "");
  EXPECT_EQ(read_bounded_line(in, 10)->text, "two");
  EXPECT_FALSE(read_bounded_line(in, 10));
}

TEST(BoundedLine, IsNoLongerThanItMayBe) {
  std::istringstream in("onetwo\nsix\n");
  const auto line = read_bounded_line(in, 3);
  EXPECT_EQ(line->text, "one");
  EXPECT_TRUE(line->is_cut);
  EXPECT_EQ(read_bounded_line(in, 3)->text, "two");
  const auto whole = read_bounded_line(in, 3);
  EXPECT_EQ(whole->text, "six");
  EXPECT_FALSE(whole->is_cut);
  EXPECT_FALSE(read_bounded_line(in, 3));
}

} // namespace
} // namespace parlour::tools

#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/expectation.hpp"

namespace parlour::tools {
namespace {

TEST(Expectation, compares_values_as_they_are_written) {
  EXPECT_TRUE(is_as_expected(7, 7));
  EXPECT_TRUE(is_as_expected("7", 7));
  EXPECT_FALSE(is_as_expected(7, 8));
  EXPECT_TRUE(is_as_expected(Value(), Value()));
  EXPECT_FALSE(is_as_expected("", Value()));
}

TEST(Expectation, a_row_is_a_value_or_a_list) {
  ResultSet rows;
  EXPECT_TRUE(cells_of(rows).is_unknown());
  rows.cells = {1};
  EXPECT_EQ(cells_of(rows), Value(1));
  rows.cells = {1, 2};
  EXPECT_EQ(cells_of(rows), Value(List{1, 2}));
}

} // namespace
} // namespace parlour::tools
